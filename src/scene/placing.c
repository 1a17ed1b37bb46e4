#define _POSIX_C_SOURCE 200809L
#include "scene/placing.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/text.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A word of the text: floats of the struct, or one of several names, as an int. */
struct word {
    const char *name;
    size_t offset;
    int count;
    const char *const *names;
};

/* FRAME_RIGHT is the word that says that the frame is complete. */
enum { FRAME_RIGHT = 3 };

/* A camera and a pinhole that sets it. */
struct pinhole {
    struct camera camera;
    float intrinsics[6]; /* and width and height of their picture */
    float opencv[16], opengl[16];
};

enum { WORD_FOV = 4, WORD_EXTENT, WORD_NEAR, WORD_FAR, WORD_SHIFT, WORD_LENS };
enum { WORD_INTRINSICS = WORD_LENS + 3, WORD_OPENCV, WORD_OPENGL };

static const struct word camera_words[] = {
    {"eye", offsetof(struct camera, eye), 3, NULL},
    {"forward", offsetof(struct camera, forward), 3, NULL},
    {"up", offsetof(struct camera, up), 3, NULL},
    {"right", offsetof(struct camera, right), 3, NULL},
    {"fov", offsetof(struct camera, fov_y), 1, NULL},
    {"extent", offsetof(struct camera, y_extent), 1, NULL},
    {"near", offsetof(struct camera, near), 1, NULL},
    {"far", offsetof(struct camera, far), 1, NULL},
    {"shift", offsetof(struct camera, shift), 2, NULL},
    {"lens", offsetof(struct camera, lens), 1, camera_lens_names},
    {"skew", offsetof(struct camera, skew), 1, NULL},
    {"distortion", offsetof(struct camera, distortion), 8, NULL},
    {"intrinsics", offsetof(struct pinhole, intrinsics), 6, NULL},
    {"opencv", offsetof(struct pinhole, opencv), 16, NULL},
    {"opengl", offsetof(struct pinhole, opengl), 16, NULL},
    {NULL, 0, 0, NULL},
};

static const struct word emitter_words[] = {
    {"position", offsetof(struct emitter, position), 3, NULL},
    {"direction", offsetof(struct emitter, direction), 3, NULL},
    {"up", offsetof(struct emitter, up), 3, NULL},
    {"right", offsetof(struct emitter, right), 3, NULL},
    {"intensity", offsetof(struct emitter, intensity), 3, NULL},
    {"size", offsetof(struct emitter, size), 2, NULL},
    {"cone", offsetof(struct emitter, cos_inner), 2, NULL},
    {"range", offsetof(struct emitter, range), 1, NULL},
    {"type", offsetof(struct emitter, type), 1, emitter_type_names},
    {NULL, 0, 0, NULL},
};

enum { EMITTER_WORDS = sizeof emitter_words / sizeof *emitter_words - 1 };

static bool parse_floats(const char *text, float *values, int count) {
    for (int i = 0; i < count; i++) {
        char *end;
        values[i] = strtof(text, &end);
        char after = i + 1 < count ? ',' : '\0';
        if (end == text || *end != after || !isfinite(values[i]))
            return false;
        text = end + 1;
    }
    return true;
}

static int find_name(const char *const *names, const char *text) {
    int i = 0;
    while (names[i] && strcmp(names[i], text) != 0)
        i++;
    return names[i] ? i : -1;
}

/* The value, what comes after "name=". */
static bool parse_value(const struct word *word, void *target, const char *text) {
    void *at = (char *)target + word->offset;
    if (!word->names)
        return parse_floats(text, at, word->count);
    int found = find_name(word->names, text);
    memcpy(at, &found, sizeof found);
    return found >= 0;
}

static bool refuse_word(const struct word *word, const char *text) {
    static const char *const examples[] = {"1", "1,0", "0,1,0"};
    if (!word->names && word->count > 3)
        return error_set("'%s' wants %d numbers with commas", text, word->count);
    if (!word->names)
        return error_set("'%s' wants %d number%s, as in %s=%s", text, word->count,
                         word->count > 1 ? "s" : "", word->name, examples[word->count - 1]);
    struct text known = {0};
    for (int i = 0; word->names[i]; i++)
        text_print(&known, "%s%s", i ? ", " : "", word->names[i]);
    error_set("'%s': there is %s", text, known.data);
    free(known.data);
    return false;
}

/* One "name=1,2,3"; sets its bit in given. */
static bool parse_word(const struct word *words, void *target, const char *text, unsigned *given) {
    size_t length = strcspn(text, "=");
    for (int i = 0; words[i].name; i++)
        if (strlen(words[i].name) == length && strncmp(words[i].name, text, length) == 0) {
            *given |= 1U << i;
            return (text[length] == '=' && parse_value(&words[i], target, text + length + 1)) ||
                   refuse_word(&words[i], text);
        }
    return error_set("'%s' is not understood", text);
}

/* Parses the words from the first with "=" on, and leaves in text what comes before them. */
static bool parse_words(const struct word *words, void *target, char *text, unsigned *given) {
    char *equals = strchr(text, '='), *end = equals ? equals : text + strlen(text), *next = NULL;
    while (equals && end > text && end[-1] != ' ')
        end--;
    char *rest = mem_strdup(end);
    while (end > text && end[-1] == ' ')
        end--;
    *end = '\0';
    *given = 0;
    bool ok = true;
    for (char *word = strtok_r(rest, " ", &next); ok && word; word = strtok_r(NULL, " ", &next))
        ok = parse_word(words, target, word, given);
    free(rest);
    return ok;
}

/* Sets those fields that were given. */
static void take_words(const struct word *words, void *target, const void *changes,
                       unsigned given) {
    for (int i = 0; words[i].name; i++)
        if (given & 1U << i)
            memcpy((char *)target + words[i].offset, (const char *)changes + words[i].offset,
                   (size_t)words[i].count * sizeof(float));
}

static void append(char text[PLACING_TEXT_SIZE], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void append(char text[PLACING_TEXT_SIZE], const char *format, ...) {
    size_t used = strlen(text);
    va_list args;
    va_start(args, format);
    vsnprintf(text + used, PLACING_TEXT_SIZE - used, format, args);
    va_end(args);
}

static void append_word(const struct word *word, const void *at, char text[PLACING_TEXT_SIZE]) {
    const float *x = at;
    int name;
    if (word->names) {
        memcpy(&name, at, sizeof name);
        append(text, " %s=%s", word->name, word->names[name]);
        return;
    }
    append(text, " %s=%.9g", word->name, (double)x[0]);
    for (int c = 1; c < word->count; c++)
        append(text, ",%.9g", (double)x[c]);
}

/* The first `count` words. */
static void append_words(const struct word *words, int count, const void *values,
                         const void *before, char text[PLACING_TEXT_SIZE]) {
    bool moved = false;
    for (int i = 1; i <= FRAME_RIGHT; i++)
        moved |= memcmp((const char *)values + words[i].offset,
                        (const char *)before + words[i].offset, 3 * sizeof(float)) != 0;
    for (int i = 0; i < count; i++) {
        const void *now = (const char *)values + words[i].offset;
        const void *old = (const char *)before + words[i].offset;
        bool of_frame = i >= 1 && i <= FRAME_RIGHT;
        if (of_frame ? moved : memcmp(now, old, (size_t)words[i].count * sizeof(float)) != 0)
            append_word(&words[i], now, text);
    }
}

static unsigned bit_of(int word) {
    return 1U << word;
}

/* Sets a camera by the pinhole's words that are given. Others of the same meaning are refused. */
static bool take_pinhole(struct camera *camera, const struct pinhole *pinhole, unsigned given) {
    const unsigned frame = 15, poses = bit_of(WORD_OPENCV) | bit_of(WORD_OPENGL);
    const unsigned lens = bit_of(WORD_FOV) | bit_of(WORD_EXTENT) | bit_of(WORD_SHIFT);
    bool opencv = given & bit_of(WORD_OPENCV), has_pose = given & poses;
    if ((given & poses) == poses || (has_pose && (given & frame)))
        return error_set("opencv, opengl, and eye, forward, up, right exclude each other");
    if ((given & bit_of(WORD_INTRINSICS)) && (given & lens))
        return error_set("intrinsics excludes fov, extent and shift");
    double pose[16], intrinsics[4];
    for (int i = 0; i < 16; i++)
        pose[i] = (double)(opencv ? pinhole->opencv : pinhole->opengl)[i];
    for (int i = 0; i < 4; i++)
        intrinsics[i] = (double)pinhole->intrinsics[i];
    int size[2];
    for (int c = 0; c < 2; c++)
        size[c] = (int)fminf(fmaxf(pinhole->intrinsics[4 + c], 0), 1e6F);
    return (!has_pose || camera_set_pose(camera, pose, opencv)) &&
           (!(given & bit_of(WORD_INTRINSICS)) || camera_set_intrinsics(camera, intrinsics, size));
}

static bool change_camera(struct camera *camera, const struct scene *scene, char *text, double time,
                          int *n) {
    struct pinhole changes = {.camera.up = {0, 1, 0}};
    unsigned given = 0;
    bool is_name = strchr(text, '=') && camera_find(scene, text) >= 0;
    if (!is_name && !parse_words(camera_words, &changes, text, &given))
        return error_prefix("camera");
    int found = *text ? camera_find(scene, text) : 0;
    if (found < 0)
        return false;
    if (n)
        *n = found;
    camera_place(camera, scene, found, time);
    take_words(camera_words, camera, &changes, given & (bit_of(WORD_INTRINSICS) - 1));
    if ((given & (2U | 4U)) && !(given & 1U << FRAME_RIGHT))
        camera_look(camera, camera->eye, camera->forward,
                    given & 4U ? camera->up : changes.camera.up);
    return given == 0 || (take_pinhole(camera, &changes, given) && camera_check(camera)) ||
           error_prefix("camera");
}

bool camera_from_text(struct camera *camera, const struct scene *scene, const char *text,
                      double time, int *n) {
    char *copy = mem_strdup(text ? text : "");
    bool ok = change_camera(camera, scene, copy, time, n);
    free(copy);
    return ok;
}

/* Marks all area lights; false where there is none. */
static bool mark_area_lights(const struct scene *scene, bool *marked) {
    bool found = false;
    for (int node = 0, n = 0; node < scene->node_count; node++) {
        int light = scene->nodes[node].light;
        if (light < 0)
            continue;
        bool is_area = scene->lights[light].type == EMITTER_AREA;
        marked[n++] |= is_area;
        found |= is_area;
    }
    return found;
}

/* Marks the lights of a list of names and numbers: all where it is empty. The last mark is the
 * sky's. */
static bool mark_emitters(const struct scene *scene, char *list, bool *marked, int count) {
    char *next = NULL;
    for (int n = 0; !*list && n < count; n++)
        marked[n] = true;
    marked[count] = !*list && scene->environment;
    for (char *name = strtok_r(list, ",", &next); name; name = strtok_r(NULL, ",", &next)) {
        name += strspn(name, " ");
        if (strcmp(name, "emitters") == 0 && mark_area_lights(scene, marked))
            continue;
        if (strcmp(name, "sky") == 0 && scene->environment) {
            marked[count] = true;
            continue;
        }
        int n = emitter_find(scene, name);
        if (n < 0)
            return false;
        marked[n] = true;
    }
    return true;
}

static bool check_changes(const struct emitter *changes) {
    const float *size = changes->size, *intensity = changes->intensity;
    double inner = (double)changes->cos_inner, outer = (double)changes->cos_outer;
    if (size[0] < 0 || size[1] < 0)
        return error_set("size=%g,%g: less than none", (double)size[0], (double)size[1]);
    if (changes->range < 0)
        return error_set("range=%g: less than none", (double)changes->range);
    for (int c = 0; c < 3; c++)
        if (!(intensity[c] >= 0 && intensity[c] <= SCENE_LIGHT_MOST))
            return error_set("intensity=%g,%g,%g: it is negative or above %g", (double)intensity[0],
                             (double)intensity[1], (double)intensity[2], (double)SCENE_LIGHT_MOST);
    return (-1 <= outer && outer <= inner && inner <= 1) ||
           error_set("cone=%g,%g: cosines, and the first is the greater one", inner, outer);
}

static bool parse_changes(struct emitter *changes, char *part, unsigned *given) {
    return (parse_words(emitter_words, changes, part, given) && check_changes(changes)) ||
           error_prefix("light");
}

static void change_emitter(struct emitter *emitter, const struct emitter *changes, unsigned given) {
    take_words(emitter_words, emitter, changes, given);
    if ((given & 2U) && !(given & 1U << FRAME_RIGHT))
        emitter_aim(emitter, emitter->direction);
}

/* Those of a text, and which of them shine. */
struct picked {
    struct emitters emitters; /* the scene's, then those that were added */
    int scene_count;
    bool *shines; /* of the scene's; the last is the sky */
    bool by_name; /* each part of the text names its lights */
};

/* One that the scene does not have; name is its type. */
static bool add_emitter(struct picked *picked, const char *name, const struct emitter *changes,
                        unsigned given) {
    int type = find_name(emitter_type_names, name);
    struct emitters *all = &picked->emitters;
    if (type < 0)
        return error_set("light: '+%s' is no type of light", name);
    struct emitter added = emitter_new((enum emitter_type)type);
    change_emitter(&added, changes, given);
    all->items = mem_resize(all->items, (size_t)all->count + 1, sizeof *all->items);
    all->items[all->count++] = added;
    return true;
}

/* A profile is of directions alone. */
static bool check_profile(const struct emitter *emitter) {
    return !emitter->slide || !emitter->slide->is_profile || emitter_has_slide(emitter) ||
           error_set("light: a light with a profile is a point without a size");
}

/* The light of a surface follows its material. */
static bool check_stand_in(const struct emitter *emitter, unsigned given) {
    return !given || !emitter->stands_in ||
           error_set("light: %d stands in for a part of a surface that emits, and cannot change",
                     emitter->number);
}

/* Picks the lights of one part of the text, with its changes. */
static bool pick_emitters(struct picked *picked, const struct scene *scene, char *part) {
    int count = picked->scene_count;
    struct emitter changes = {0};
    unsigned given;
    if (!parse_changes(&changes, part, &given))
        return false;
    if (*part == '+')
        return add_emitter(picked, part + 1, &changes, given);
    picked->by_name &= *part != '\0';
    bool *marked = mem_alloc((size_t)count + 1, sizeof *marked);
    bool ok = mark_emitters(scene, part, marked, count);
    for (int n = 0; ok && n <= count; n++) {
        picked->shines[n] |= marked[n];
        if (n < count && marked[n]) {
            struct emitter *light = &picked->emitters.items[n];
            change_emitter(light, &changes, given);
            ok = check_profile(light) && check_stand_in(light, given);
        }
    }
    free(marked);
    return ok;
}

static bool pick_all_parts(struct picked *picked, const struct scene *scene, const char *text) {
    int whole = text && strpbrk(text, ",;=") ? emitter_find(scene, text) : -1;
    if (whole >= 0)
        return picked->shines[whole] = true;
    char *copy = mem_strdup(text ? text : ""), *next = NULL;
    char *part = strtok_r(copy, ";", &next);
    bool ok = pick_emitters(picked, scene, part ? part : copy);
    while (ok && part && (part = strtok_r(NULL, ";", &next)))
        ok = pick_emitters(picked, scene, part + strspn(part, " "));
    free(copy);
    return ok;
}

/* Lets those go that do not shine. */
static void keep_picked(struct picked *picked) {
    struct emitters *all = &picked->emitters;
    int kept = 0;
    for (int n = 0; n < all->count; n++)
        if (n >= picked->scene_count || picked->shines[n])
            all->items[kept++] = all->items[n];
    all->count = kept;
    if (!picked->shines[picked->scene_count])
        all->sky = NULL;
}

static bool pick(struct picked *picked, const struct scene *scene, const char *text, double time) {
    *picked = (struct picked){.emitters = emitters_place(scene, time), .by_name = true};
    picked->scene_count = picked->emitters.count;
    picked->shines = mem_alloc((size_t)picked->scene_count + 1, sizeof *picked->shines);
    return pick_all_parts(picked, scene, text);
}

bool emitters_text_is_complete(const struct scene *scene, const char *text) {
    struct picked picked;
    bool complete = pick(&picked, scene, text, 0) && picked.by_name;
    emitters_free(&picked.emitters);
    free(picked.shines);
    return complete;
}

bool emitters_from_text(struct emitters *emitters, const struct scene *scene, const char *text,
                        double time) {
    struct picked picked;
    bool ok = pick(&picked, scene, text, time);
    keep_picked(&picked);
    free(picked.shines);
    if (ok && picked.emitters.count == 0 && !picked.emitters.sky)
        ok = error_set("light: '%s' names none", text);
    if (!ok) {
        emitters_free(&picked.emitters);
        return false;
    }
    emitters_free(emitters);
    *emitters = picked.emitters;
    return true;
}

void camera_to_text(const struct camera *camera, const struct scene *scene, int n, double time,
                    char text[PLACING_TEXT_SIZE]) {
    struct camera before;
    camera_place(&before, scene, n, time);
    snprintf(text, PLACING_TEXT_SIZE, "%d", n);
    append_words(camera_words, WORD_INTRINSICS, camera, &before, text);
}

char *emitters_to_text(const struct emitters *emitters, const struct scene *scene, double time) {
    struct emitters placed = emitters_place(scene, time);
    struct text text = {0};
    const char *separator = "";
    for (int i = 0; i < emitters->count; i++) {
        const struct emitter *light = &emitters->items[i];
        struct emitter before = emitter_new(light->type);
        char changes[PLACING_TEXT_SIZE] = "";
        if (light->number >= 0)
            before = placed.items[light->number];
        append_words(emitter_words, EMITTER_WORDS, light, &before, changes);
        bool apart = *changes || light->number < 0;
        text_print(&text, "%s", apart && i ? "; " : separator);
        if (light->number < 0)
            text_print(&text, "+%s%s", emitter_type_names[light->type], changes);
        else
            text_print(&text, "%d%s", light->number, changes);
        separator = apart ? "; " : ",";
    }
    if (emitters->sky)
        text_print(&text, "%ssky", separator);
    emitters_free(&placed);
    return text.data;
}
