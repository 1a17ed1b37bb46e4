#define _POSIX_C_SOURCE 200809L
#include "gl/context/context.h"

#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/names.h"
#include "base/parallel.h"
#include "gl/api.h"
#include "gl/context/needs.h"
#include "gl/context/platform.h"
#include "gl/context/samplers.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/screen.h"
#include "gl/screen_rows.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

const char *const context_kind_names[] = {"auto", "egl", "osmesa", NULL};

struct context {
    struct native_context native; /* platform NULL: adopted, the window's owner binds it */
    struct gl_api api;
    char description[128];
    int message_count;
};

/* OpenGL knows a thread's current context, so must we. */
static _Thread_local struct context *current;

/* --- debug messages --- */

/* What costs time and is no fault. NVIDIA's numbers: a shader is recompiled for a state; a buffer
 * that is read back moves to the host. */
static bool is_note(GLenum type, GLuint id) {
    return type == GL_DEBUG_TYPE_PERFORMANCE || id == 131218 || id == 131186;
}

static void APIENTRY on_message(GLenum source, GLenum type, GLuint id, GLenum severity,
                                GLsizei length, const GLchar *message, const void *user) {
    (void)source, (void)severity, (void)length;
    int end = (int)strcspn(message, "\n");
    if (is_note(type, id)) {
        log_detail("OpenGL: %.*s", end, message);
        return;
    }
    ((struct context *)user)->message_count++;
    log_warning("OpenGL: %.*s", end, message);
}

static void listen(struct context *context) {
    gl.Enable(GL_DEBUG_OUTPUT);
    gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, NULL, GL_TRUE);
    gl.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, NULL,
                           GL_FALSE);
    gl.DebugMessageCallback(on_message, context);
}

/* --- making a context --- */

static bool is_software(const char *renderer) {
    static const char *const names[] = {"llvmpipe", "softpipe", "swrast", "Software"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strstr(renderer, names[i]))
            return true;
    return false;
}

static void make_empty_objects(struct gl_api *api) {
    api->CreateVertexArrays(1, &api->empty_vertex_array);
    api->CreateFramebuffers(1, &api->empty_framebuffer);
    api->NamedFramebufferParameteri(api->empty_framebuffer, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
    api->NamedFramebufferParameteri(api->empty_framebuffer, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
}

/* Some drivers promise more, and fail when it is drawn to. 0: it is not told. */
static size_t memory_of(const struct gl_api *api) {
    enum { TOTAL_MEMORY = 0x9048 }; /* KiB */
    GLint total = 0;
    if (gl_has_extension(api, "GL_NVX_gpu_memory_info"))
        api->GetIntegerv(TOTAL_MEMORY, &total);
    return total > 0 ? (size_t)total << 10 : 0;
}

static struct screen_rows *create_rows(const struct gl_api *api) {
    GLuint buffer;
    api->CreateBuffers(1, &buffer);
    api->NamedBufferStorage(buffer, screen_rows_bytes, NULL, GL_DYNAMIC_STORAGE_BIT);
    return screen_rows_create(buffer);
}

/* Fills in what needs the context to be current, and makes `gl` its table. */
static bool load(struct context *context, void *(*getproc)(const char *name), bool debug) {
    if (!gl_api_load(&context->api, getproc) || !gl_needs_met(&context->api))
        return false;
    make_empty_objects(&context->api);
    context->api.Disable(GL_DITHER); /* drivers warn of it where targets hold integers */
    context->api.memory = memory_of(&context->api);
    context->api.programs = program_cache_create();
    context->api.framebuffers = framebuffer_list_create();
    context->api.screen_rows = create_rows(&context->api);
    context->api.software = is_software((const char *)context->api.GetString(GL_RENDERER));
    if (debug)
        samplers_watch(&context->api, &context->message_count);
    gl = context->api;
    current = context;
    if (debug)
        listen(context);
    return true;
}

/* A software rasteriser frees tens of MiB of triangles at the end of what it draws, and asks for
 * them again. */
static void keep_freed(const struct context *context) {
    if (context->api.software)
        mem_keep_freed();
}

static struct context *try_candidate(const struct candidate *candidate, bool debug) {
    struct context *context = mem_alloc(1, sizeof *context);
    const struct platform *platform = candidate->platform;
    context_make_current(NULL);
    snprintf(context->description, sizeof context->description, "%s", candidate->name);
    if (platform->create(&context->native, candidate, debug) && platform->bind(&context->native)) {
        current = context;
        if (load(context, platform->getproc, debug))
            return context;
    }
    context_free(context);
    error_prefix("%s", candidate->name);
    return NULL;
}

/* --- candidates --- */

static void add_reason(struct names *reasons) {
    names_add(reasons, "; ", error_get());
}

/* Platforms open their libraries once for all threads. */
static void list_candidates(struct candidate_list *list, enum context_kind kind,
                            struct names *reasons) {
    static pthread_mutex_t opening = PTHREAD_MUTEX_INITIALIZER;
    list->count = 0;
    pthread_mutex_lock(&opening);
    if (kind != CONTEXT_OSMESA && !egl_platform.list(list))
        add_reason(reasons);
    if (kind != CONTEXT_EGL && !osmesa_platform.list(list))
        add_reason(reasons);
    pthread_mutex_unlock(&opening);
}

/* Which candidates are tried. */
struct wish {
    enum { WISH_ANY, WISH_HARDWARE, WISH_EGL, WISH_CUDA } kind;
    int number;
};

static bool parse_wish(struct wish *wish, const char *text) {
    int end = 0;
    *wish = (struct wish){WISH_ANY, -1};
    if (!text)
        return true;
    wish->kind = strcmp(text, "hardware") == 0    ? WISH_HARDWARE
                 : strncmp(text, "cuda:", 5) == 0 ? WISH_CUDA
                                                  : WISH_EGL;
    if (wish->kind == WISH_HARDWARE)
        return true;
    const char *digits = text + (wish->kind == WISH_CUDA ? 5 : 0);
    return (sscanf(digits, "%3d%n", &wish->number, &end) == 1 && wish->number >= 0 &&
            digits[end] == '\0') ||
           error_set("'%s' is no device: a number of EGL's, cuda:N or hardware", text);
}

bool context_check_device(const char *text) {
    struct wish wish;
    return parse_wish(&wish, text);
}

static bool is_wished(const struct candidate *candidate, const struct wish *wish) {
    switch (wish->kind) {
    case WISH_ANY:
        return true;
    case WISH_HARDWARE:
        return !candidate->software;
    case WISH_EGL:
        return candidate->number == wish->number;
    case WISH_CUDA:
        return candidate->cuda == wish->number;
    }
    return false;
}

/* EGL surfaceless tells only of a context that is made whether it is software. */
static struct context *try_wished(const struct candidate *candidate, const struct wish *wish,
                                  bool debug) {
    struct context *context = try_candidate(candidate, debug);
    if (!context || wish->kind != WISH_HARDWARE || !context->api.software)
        return context;
    context_free(context);
    error_set("%s: it is software", candidate->name);
    return NULL;
}

static bool refuse_wish(const struct candidate_list *list, const struct wish *wish) {
    int count = 0;
    for (int i = 0; i < list->count; i++)
        count += list->items[i].number >= 0;
    if (wish->kind == WISH_EGL)
        return error_set("no EGL device %d (there are %d, counted from 0)", wish->number, count);
    return wish->kind == WISH_CUDA ? error_set("no EGL device is cuda:%d", wish->number)
                                   : error_set("no hardware device");
}

/* Containers pass a GPU on without the file that tells EGL of its driver. */
static void warn_of_hidden_gpu(const struct candidate_list *list) {
    for (int i = 0; i < list->count; i++)
        if (list->items[i].number >= 0 && !list->items[i].software)
            return;
    if (access("/dev/nvidiactl", F_OK) == 0)
        log_warning(
            "an NVIDIA GPU is there, but EGL does not list it: its file 10_nvidia.json is missing "
            "(__EGL_VENDOR_LIBRARY_FILENAMES names one)");
}

/* Nobody shall take a software rasteriser's times for a GPU's. */
static void warn_of_software(const struct candidate_list *list, const struct names *failures) {
    if (failures->length)
        log_warning("hardware is not used: %s", failures->text);
    else
        warn_of_hidden_gpu(list);
}

static struct context *try_list(const struct candidate_list *list, const struct wish *wish,
                                bool debug, struct names *reasons) {
    struct names failures = {0}; /* of hardware */
    int tried = 0;
    for (int i = 0; i < list->count; i++) {
        const struct candidate *candidate = &list->items[i];
        if (!is_wished(candidate, wish))
            continue;
        tried++;
        struct context *context = try_wished(candidate, wish, debug);
        if (context && context->api.software && wish->kind == WISH_ANY)
            warn_of_software(list, &failures);
        if (context)
            return context;
        add_reason(reasons);
        if (candidate->number >= 0 && !candidate->software)
            add_reason(&failures);
    }
    if (tried == 0) {
        refuse_wish(list, wish);
        add_reason(reasons);
    }
    return NULL;
}

/* Mesa complains on stderr of each device that is not its own; we report what failed. It does not
 * know of bounds but the affinity's on its threads. */
static void instruct_mesa(void) {
    char threads[16];
    snprintf(threads, sizeof threads, "%d", parallel_core_count());
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    if (parallel_core_count() < sysconf(_SC_NPROCESSORS_ONLN))
        setenv("LP_NUM_THREADS", threads, 0);
}

struct context *context_create(const struct context_desc *desc) {
    struct candidate_list list;
    struct wish wish;
    struct names reasons = {0};
    struct context *before = current;
    if (desc->screen != SCREEN_AUTO)
        screen_set_way(desc->screen);
    if (!parse_wish(&wish, desc->device) || !mem_check_driver())
        return NULL;
    if (!desc->embedded)
        instruct_mesa();
    list_candidates(&list, desc->kind, &reasons);
    struct context *context = try_list(&list, &wish, desc->debug, &reasons);
    if (!context) {
        context_make_current(before);
        error_set("no OpenGL 4.5 core context: %s", reasons.text);
    } else if (!desc->embedded)
        keep_freed(context);
    return context;
}

static struct context *adopt(void *(*getproc)(const char *name), bool debug) {
    struct context *context = mem_alloc(1, sizeof *context);
    snprintf(context->description, sizeof context->description, "window");
    if (load(context, getproc, debug))
        return context;
    context_free(context);
    error_prefix("window");
    return NULL;
}

struct context *context_adopt(void *(*getproc)(const char *name), bool debug) {
    struct context *context = adopt(getproc, debug);
    if (context)
        keep_freed(context);
    return context;
}

struct context *context_adopt_embedded(void *(*getproc)(const char *name)) {
    return adopt(getproc, false);
}

/* --- being current --- */

/* EGL and OSMesa may share one Mesa, whose notion of the current context would be torn between
 * them: the old context is always let go before another is bound. */
static void release_current(void) {
    if (current && current->native.platform)
        current->native.platform->unbind(&current->native);
    current = NULL;
    memset(&gl, 0, sizeof gl);
}

bool context_bind(struct context *context) {
    if (context == current)
        return true;
    release_current();
    if (!context)
        return true;
    if (context->native.platform && !context->native.platform->bind(&context->native))
        return error_prefix("%s", context->description);
    current = context;
    gl = context->api;
    return true;
}

void context_make_current(struct context *context) {
    if (context_bind(context))
        return;
    /* A context that was current before: only a driver that lost it refuses. */
    log_warning("%s", error_get());
    abort();
}

void context_delete_objects(struct context *context) {
    program_cache_delete_programs(context->api.programs);
    screen_rows_delete_buffer(context->api.screen_rows);
    gl.DeleteVertexArrays(1, &context->api.empty_vertex_array);
    gl.DeleteFramebuffers(1, &context->api.empty_framebuffer);
}

void context_free(struct context *context) {
    if (!context)
        return;
    if (context == current)
        release_current();
    if (context->native.platform)
        context->native.platform->destroy(&context->native);
    program_cache_free(context->api.programs);
    framebuffer_list_free(context->api.framebuffers);
    screen_rows_free(context->api.screen_rows);
    free(context);
}

void context_set_store(struct context *context, struct program_store *store, bool fills) {
    context->api.store = store;
    context->api.fills_store = fills;
    if (context == current)
        gl = context->api;
}

/* --- questions --- */

bool context_check(void) {
    GLenum status = gl.GetGraphicsResetStatus();
    return status == GL_NO_ERROR ||
           error_set("OpenGL's context is lost: %s", status == GL_GUILTY_CONTEXT_RESET
                                                         ? "this program made the GPU hang"
                                                         : "the driver has reset the GPU");
}

const char *context_description(const struct context *context) {
    return context->description;
}

int context_message_count(const struct context *context) {
    return context->message_count;
}

void context_list_devices(char *text, size_t size) {
    struct candidate_list list;
    struct names reasons = {0};
    list_candidates(&list, CONTEXT_AUTO, &reasons);
    size_t used = 0;
    text[0] = '\0';
    for (int i = 0; i < list.count && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s\n", list.items[i].name);
    if (reasons.length && used < size)
        snprintf(text + used, size - used, "%s\n", reasons.text);
}
