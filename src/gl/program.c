#include "gl/program.h"

#include "base/clock.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/phases.h"
#include "base/text.h"
#include "gl/glsl.h"
#include "gl/screen.h"
#include "gl/screen_glsl.h"

#include <assert.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { STAGES = 4, KEPT_MAX = 64, STORED_MAX = 256 };

/* The full sources of a program, as the driver gets them. */
struct sources {
    struct glsl_source stages[STAGES];
    const char *files[STAGES];
    struct screen_desc dispatched; /* of a screen pass that is a compute shader */
};

static const GLenum stage_types[STAGES] = {GL_VERTEX_SHADER, GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER,
                                           GL_COMPUTE_SHADER};

static void free_sources(struct sources *sources) {
    for (int i = 0; i < STAGES; i++)
        glsl_free(&sources->stages[i]);
}

static bool load_stages(struct sources *sources, const char *defines) {
    for (int i = 0; i < STAGES; i++)
        if (sources->files[i] && !glsl_load(&sources->stages[i], sources->files[i], defines)) {
            free_sources(sources);
            return false;
        }
    return true;
}

/* Each text has the body's own lines, so that a message about either names them. */
static bool load_screen(struct sources *sources, const struct program_desc *desc) {
    const struct screen_desc *screen = &desc->screen;
    if (screen_way() == SCREEN_FRAGMENT) {
        const char *vertex = desc->vertex ? desc->vertex : "fullscreen.vert";
        char *defines =
            mem_printf("%s%s", screen->layers ? "LAYERS;" : "", desc->defines ? desc->defines : "");
        *sources = (struct sources){.files = {vertex, NULL, screen->body}};
        bool ok = load_stages(sources, defines);
        free(defines);
        return ok;
    }
    *sources = (struct sources){.files = {NULL, NULL, NULL, screen->body}, .dispatched = *screen};
    if (!load_stages(sources, desc->defines))
        return false;
    struct glsl_source *stage = &sources->stages[STAGES - 1];
    char *text = screen_glsl(stage->text, screen);
    free(stage->text);
    stage->text = text;
    return true;
}

static bool load_sources(struct sources *sources, const struct program_desc *desc) {
    if (desc->screen.body)
        return load_screen(sources, desc);
    *sources =
        (struct sources){.files = {desc->vertex, desc->geometry, desc->fragment, desc->compute}};
    return load_stages(sources, desc->defines);
}

/* --- compiling --- */

static bool check_compiled(GLuint shader, const struct glsl_source *source, const char *file) {
    GLint ok;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok)
        return true;
    char message[1500] = "";
    gl.GetShaderInfoLog(shader, sizeof message, NULL, message);
    if (!message[0]) /* out of memory, mostly */
        return error_set("shader %s does not compile: the driver gives no reason", file);
    char *explained = glsl_explain(source, message);
    error_set("shader %s does not compile:\n%s", file, explained);
    free(explained);
    return false;
}

static bool attach(GLuint program, GLenum type, const struct glsl_source *source,
                   const char *file) {
    GLuint shader = gl.CreateShader(type);
    gl.ShaderSource(shader, 1, (const char *const *)&source->text, NULL);
    gl.CompileShader(shader);
    bool ok = check_compiled(shader, source, file);
    if (ok)
        gl.AttachShader(program, shader);
    gl.DeleteShader(shader); /* lives on while attached */
    return ok;
}

/* What does not fit may be in any of them. */
static void name_stages(const struct sources *sources, char *names, size_t size) {
    size_t used = 0;
    names[0] = '\0';
    for (int i = 0; i < STAGES; i++)
        if (sources->files[i] && used < size)
            used += (size_t)snprintf(names + used, size - used, "%s%s", used ? " and " : "",
                                     sources->files[i]);
}

static bool link(GLuint program, const struct sources *sources) {
    gl.LinkProgram(program);
    GLint ok;
    gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok)
        return true;
    char message[1500] = "";
    gl.GetProgramInfoLog(program, sizeof message, NULL, message);
    char names[300];
    name_stages(sources, names, sizeof names);
    return error_set("shaders %s do not link: %s", names, message);
}

static GLuint compile(const struct sources *sources) {
    GLuint program = gl.CreateProgram();
    bool ok = true;
    gl.ProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, gl.fills_store);
    for (int i = 0; ok && i < STAGES; i++)
        ok = !sources->files[i] ||
             attach(program, stage_types[i], &sources->stages[i], sources->files[i]);
    if (ok && link(program, sources))
        return program;
    gl.DeleteProgram(program);
    return 0;
}

/* --- programs as the driver has linked them, by what they are made of --- */

struct program_store {
    pthread_mutex_t mutex;
    struct stored {
        char *key;
        GLenum format;
        void *binary;
        GLsizei size;
    } entries[STORED_MAX];
    int next;  /* of the ring */
    int count; /* that came */
};

struct program_store *program_store_create(void) {
    struct program_store *store = mem_alloc(1, sizeof *store);
    pthread_mutex_init(&store->mutex, NULL);
    return store;
}

static void forget(struct stored *stored) {
    mem_free(stored->key, stored->binary);
    *stored = (struct stored){0};
}

void program_store_free(struct program_store *store) {
    for (int i = 0; store && i < STORED_MAX; i++)
        forget(&store->entries[i]);
    if (store)
        pthread_mutex_destroy(&store->mutex);
    free(store);
}

int program_store_count(struct program_store *store) {
    int count = 0;
    if (!store)
        return 0;
    pthread_mutex_lock(&store->mutex);
    count = store->count;
    pthread_mutex_unlock(&store->mutex);
    return count;
}

/* Drivers without formats give no bytes. */
static void give(const char *key, GLuint program) {
    struct program_store *store = gl.store;
    GLint size = 0;
    gl.GetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &size);
    pthread_mutex_lock(&store->mutex);
    store->count++;
    pthread_mutex_unlock(&store->mutex);
    if (size <= 0)
        return;
    struct stored stored = {.key = mem_strdup(key), .binary = mem_alloc((size_t)size, 1)};
    gl.GetProgramBinary(program, size, &stored.size, &stored.format, stored.binary);
    pthread_mutex_lock(&store->mutex);
    forget(&store->entries[store->next]);
    store->entries[store->next] = stored;
    store->next = (store->next + 1) % STORED_MAX;
    pthread_mutex_unlock(&store->mutex);
}

/* 0: there is none, or the driver does not take it back. */
static GLuint take(const char *key) {
    struct program_store *store = gl.store;
    GLuint program = 0;
    GLint ok = 0;
    pthread_mutex_lock(&store->mutex);
    for (int i = 0; i < STORED_MAX && !program; i++) {
        const struct stored *stored = &store->entries[i];
        if (!stored->key || strcmp(stored->key, key) != 0)
            continue;
        program = gl.CreateProgram();
        gl.ProgramBinary(program, stored->format, stored->binary, stored->size);
    }
    pthread_mutex_unlock(&store->mutex);
    if (program)
        gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok)
        return program;
    gl.DeleteProgram(program);
    return 0;
}

/* What is given is taken back at once: Mesa compiles a program that was stored for its draws by
 * another key than the one that it was stored from. */
static GLuint make(const struct sources *sources, const char *key) {
    GLuint program = gl.store ? take(key) : 0;
    if (program)
        return program;
    double start = clock_ms();
    program = compile(sources);
    phase_add(PHASE_PROGRAMS, start);
    if (!program || !gl.fills_store)
        return program;
    give(key, program);
    GLuint taken = take(key);
    if (taken)
        gl.DeleteProgram(program);
    return taken ? taken : program;
}

/* --- the programs of a context, by what they are made of --- */

struct program_cache {
    struct cached {
        char *key;
        GLuint program;
        struct screen_desc dispatched;
        int uses;
        unsigned long last_use; /* in order of use */
    } * entries;
    int count;
    unsigned long clock;
};

static char *make_key(const struct sources *sources) {
    struct text key = {0};
    for (int i = 0; i < STAGES; i++) {
        if (sources->files[i])
            text_append(&key, sources->stages[i].text, strlen(sources->stages[i].text));
        text_append(&key, "\f", 1);
    }
    return key.data;
}

struct program_cache *program_cache_create(void) {
    return mem_alloc(1, sizeof(struct program_cache));
}

void program_cache_free(struct program_cache *programs) {
    for (int i = 0; programs && i < programs->count; i++)
        free(programs->entries[i].key);
    if (programs)
        free(programs->entries);
    free(programs);
}

void program_cache_delete_programs(struct program_cache *programs) {
    for (int i = 0; i < programs->count; i++) {
        gl.DeleteProgram(programs->entries[i].program);
        free(programs->entries[i].key);
    }
    programs->count = 0;
}

static struct cached *find(const char *key) {
    for (int i = 0; i < gl.programs->count; i++)
        if (strcmp(gl.programs->entries[i].key, key) == 0)
            return &gl.programs->entries[i];
    return NULL;
}

/* Of the programs that nobody uses, no more than KEPT_MAX stay. */
static void drop_oldest_unused(void) {
    struct program_cache *programs = gl.programs;
    int unused = 0, oldest = -1;
    for (int i = 0; i < programs->count; i++)
        if (programs->entries[i].uses == 0) {
            unused++;
            if (oldest < 0 || programs->entries[i].last_use < programs->entries[oldest].last_use)
                oldest = i;
        }
    if (unused <= KEPT_MAX)
        return;
    gl.DeleteProgram(programs->entries[oldest].program);
    free(programs->entries[oldest].key);
    programs->entries[oldest] = programs->entries[--programs->count];
}

/* Takes the key. */
static struct cached *add(char *key, GLuint program) {
    struct program_cache *programs = gl.programs;
    programs->entries =
        mem_resize(programs->entries, (size_t)programs->count + 1, sizeof *programs->entries);
    struct cached *cached = &programs->entries[programs->count++];
    *cached = (struct cached){.key = key, .program = program};
    return cached;
}

bool program_init(GLuint *program, const struct program_desc *desc) {
    struct sources sources;
    *program = 0;
    if (!load_sources(&sources, desc))
        return false;
    char *key = make_key(&sources);
    struct cached *cached = find(key);
    GLuint compiled = cached ? 0 : make(&sources, key);
    if (compiled)
        cached = add(key, compiled);
    else
        free(key);
    if (cached) {
        cached->uses++;
        cached->dispatched = sources.dispatched;
        *program = cached->program;
    }
    free_sources(&sources);
    return cached != NULL;
}

const struct screen_desc *program_dispatched(GLuint program) {
    const struct program_cache *programs = gl.programs;
    for (int i = 0; i < programs->count; i++)
        if (programs->entries[i].program == program)
            return programs->entries[i].dispatched.body ? &programs->entries[i].dispatched : NULL;
    return NULL;
}

int program_use_count(void) {
    int count = 0;
    for (int i = 0; i < gl.programs->count; i++)
        count += gl.programs->entries[i].uses;
    return count;
}

void program_free(GLuint *program) {
    if (!*program)
        return;
    struct cached *cached = gl.programs->entries;
    while (cached->program != *program)
        cached++;
    assert(cached->uses > 0);
    cached->uses--;
    cached->last_use = ++gl.programs->clock;
    drop_oldest_unused();
    *program = 0;
}
