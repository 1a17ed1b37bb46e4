#define _POSIX_C_SOURCE 200809L
#include "scene/placing.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/text.h"
#include "scene/node.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A word of the text: floats of the struct. */
struct word {
    const char *name;
    size_t offset;
    int count;
};

/* FRAME_RIGHT is the word that says that the frame is complete. */
enum { FRAME_RIGHT = 3 };

static const struct word camera_words[] = {
    {"eye", offsetof(struct camera, eye), 3},
    {"forward", offsetof(struct camera, forward), 3},
    {"up", offsetof(struct camera, up), 3},
    {"right", offsetof(struct camera, right), 3},
    {"fov", offsetof(struct camera, fov_y), 1},
    {"extent", offsetof(struct camera, y_extent), 1},
    {NULL, 0, 0},
};

static const struct word emitter_words[] = {
    {"position", offsetof(struct emitter, position), 3},
    {"direction", offsetof(struct emitter, direction), 3},
    {"up", offsetof(struct emitter, up), 3},
    {"right", offsetof(struct emitter, right), 3},
    {"intensity", offsetof(struct emitter, intensity), 3},
    {"size", offsetof(struct emitter, size), 2},
    {NULL, 0, 0},
};

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

/* One "name=1,2,3"; sets its bit in given. */
static bool parse_word(const struct word *words, void *target, const char *text, unsigned *given) {
    static const char *const examples[] = {"1", "1,0", "0,1,0"};
    size_t length = strcspn(text, "=");
    for (int i = 0; words[i].name; i++)
        if (strlen(words[i].name) == length && strncmp(words[i].name, text, length) == 0) {
            float *values = (float *)(void *)((char *)target + words[i].offset);
            *given |= 1U << i;
            return (text[length] == '=' &&
                    parse_floats(text + length + 1, values, words[i].count)) ||
                   error_set("'%s' wants %d number%s, as in %s=%s", text, words[i].count,
                             words[i].count > 1 ? "s" : "", words[i].name,
                             examples[words[i].count - 1]);
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

static void append_words(const struct word *words, const void *values, const void *before,
                         char text[PLACING_TEXT_SIZE]) {
    size_t used = strlen(text);
    bool moved = false;
    for (int i = 1; i <= FRAME_RIGHT; i++)
        moved |= memcmp((const char *)values + words[i].offset,
                        (const char *)before + words[i].offset, 3 * sizeof(float)) != 0;
    for (int i = 0; words[i].name; i++) {
        const float *x = (const float *)(const void *)((const char *)values + words[i].offset);
        const void *old = (const char *)before + words[i].offset;
        bool of_frame = i >= 1 && i <= FRAME_RIGHT;
        if (of_frame ? !moved : memcmp(x, old, (size_t)words[i].count * sizeof *x) == 0)
            continue;
        used += (size_t)snprintf(text + used, PLACING_TEXT_SIZE - used, " %s=%.9g", words[i].name,
                                 (double)x[0]);
        for (int c = 1; c < words[i].count; c++)
            used += (size_t)snprintf(text + used, PLACING_TEXT_SIZE - used, ",%.9g", (double)x[c]);
    }
}

static bool change_camera(struct camera *camera, const struct scene *scene, char *text, double time,
                          int *n) {
    struct camera changes = {.up = {0, 1, 0}};
    unsigned given;
    if (!parse_words(camera_words, &changes, text, &given))
        return error_prefix("camera");
    int found = *text ? camera_find(scene, text) : 0;
    if (found < 0)
        return false;
    if (n)
        *n = found;
    camera_place(camera, scene, found, time);
    take_words(camera_words, camera, &changes, given);
    if ((given & (2U | 4U)) && !(given & 1U << FRAME_RIGHT))
        camera_look(camera, camera->eye, camera->forward, given & 4U ? camera->up : changes.up);
    return true;
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
    for (int n = 0; n < emitter_node_count(scene); n++) {
        int node = node_carrying(scene, NODE_LIGHT, n);
        bool is_area = scene->lights[scene->nodes[node].light].type == EMITTER_AREA;
        marked[n] |= is_area;
        found |= is_area;
    }
    return found;
}

/* Marks the lights of a list of names and numbers: all where it is empty. The last mark is the sky's. */
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

static bool check_size(const struct emitter *changes) {
    const float *size = changes->size;
    return (size[0] >= 0 && size[1] >= 0) ||
           error_set("size=%g,%g: less than none", (double)size[0], (double)size[1]);
}

/* Picks the lights of one part of the text, with its changes. */
static bool pick_emitters(struct emitter *all, bool *picked, const struct scene *scene,
                          char *part) {
    int count = emitter_node_count(scene);
    bool *marked = mem_alloc((size_t)count + 1, sizeof *marked);
    struct emitter changes = {0};
    unsigned given;
    bool ok = ((parse_words(emitter_words, &changes, part, &given) && check_size(&changes)) ||
               error_prefix("light")) &&
              mark_emitters(scene, part, marked, count);
    for (int n = 0; ok && n < count; n++) {
        if (!marked[n])
            continue;
        picked[n] = true;
        take_words(emitter_words, &all[n], &changes, given);
        if ((given & 2U) && !(given & 1U << FRAME_RIGHT))
            emitter_aim(&all[n], all[n].direction);
    }
    picked[count] |= ok && marked[count];
    free(marked);
    return ok;
}

static bool pick_all_parts(struct emitter *all, bool *picked, const struct scene *scene,
                           const char *text) {
    char *copy = mem_strdup(text ? text : ""), *next = NULL;
    char *part = strtok_r(copy, ";", &next);
    bool ok = pick_emitters(all, picked, scene, part ? part : copy);
    while (ok && part && (part = strtok_r(NULL, ";", &next)))
        ok = pick_emitters(all, picked, scene, part + strspn(part, " "));
    free(copy);
    return ok;
}

bool emitters_from_text(struct emitters *emitters, const struct scene *scene, const char *text,
                        double time) {
    struct emitters placed = emitters_place(scene, time);
    struct emitter *all = placed.items;
    int count = placed.count, kept = 0;
    bool *picked = mem_alloc((size_t)count + 1, sizeof *picked);
    bool ok = pick_all_parts(all, picked, scene, text);
    for (int n = 0; ok && n < count; n++)
        if (picked[n])
            all[kept++] = all[n];
    bool has_sky = picked[count];
    free(picked);
    if (ok && kept == 0 && !has_sky)
        ok = error_set("light: '%s' names none", text);
    if (!ok) {
        free(all);
        return false;
    }
    emitters_free(emitters);
    *emitters = (struct emitters){all, kept, has_sky ? placed.sky : NULL};
    return true;
}

void camera_to_text(const struct camera *camera, const struct scene *scene, int n, double time,
                    char text[PLACING_TEXT_SIZE]) {
    struct camera before;
    camera_place(&before, scene, n, time);
    snprintf(text, PLACING_TEXT_SIZE, "%d", n);
    append_words(camera_words, camera, &before, text);
}

char *emitters_to_text(const struct emitters *emitters, const struct scene *scene, double time) {
    struct text text = {0};
    const char *separator = "";
    for (int i = 0; i < emitters->count; i++) {
        struct emitter before;
        char changes[PLACING_TEXT_SIZE] = "";
        emitter_place(&before, scene, emitters->items[i].number, time);
        append_words(emitter_words, &emitters->items[i], &before, changes);
        text_print(&text, "%s%d%s", *changes && i ? "; " : separator, emitters->items[i].number,
                   changes);
        separator = *changes ? "; " : ",";
    }
    if (emitters->sky)
        text_print(&text, "%ssky", separator);
    return text.data;
}
