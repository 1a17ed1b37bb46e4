#include "scene/placing.h"

#include "base/error.h"

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

static const struct word light_words[] = {
    {"position", offsetof(struct emitter, position), 3},
    {"direction", offsetof(struct emitter, direction), 3},
    {"up", offsetof(struct emitter, up), 3},
    {"right", offsetof(struct emitter, right), 3},
    {"intensity", offsetof(struct emitter, intensity), 3},
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
    size_t length = strcspn(text, "=");
    for (int i = 0; words[i].name; i++)
        if (strlen(words[i].name) == length && strncmp(words[i].name, text, length) == 0) {
            float *values = (float *)(void *)((char *)target + words[i].offset);
            *given |= 1U << i;
            return parse_floats(text + length + 1, values, words[i].count) ||
                   error_set("'%s' wants %d number%s, as in %s=%s", text, words[i].count,
                             words[i].count > 1 ? "s" : "", words[i].name,
                             words[i].count > 1 ? "0,1,0" : "1");
        }
    return error_set("'%s' is not understood", text);
}

/* Splits off the words with "="; what comes before them is left in name. */
static bool parse_words(const struct word *words, void *target, const char *text, char *name,
                        size_t name_size, unsigned *given) {
    char copy[1024], *rest = copy;
    *given = 0;
    name[0] = '\0';
    snprintf(copy, sizeof copy, "%s", text);
    const char *equals = strchr(copy, '=');
    while (equals && rest < equals) { /* the start of the first word with "=" */
        char *space = strchr(rest, ' ');
        if (!space || space > equals)
            break;
        rest = space + 1;
    }
    if (!equals)
        rest = copy + strlen(copy);
    snprintf(name, name_size, "%.*s", (int)(rest - copy), copy);
    for (size_t end = strlen(name); end > 0 && name[end - 1] == ' '; end--)
        name[end - 1] = '\0';
    for (char *word = strtok(rest, " "); word; word = strtok(NULL, " "))
        if (!parse_word(words, target, word, given))
            return false;
    return true;
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

bool camera_from_text(struct camera *camera, const struct scene *scene, const char *text,
                      double time, int *n) {
    char name[SCENE_NAME_SIZE];
    struct camera changes = {.up = {0, 1, 0}};
    unsigned given = 0;
    if (text && !parse_words(camera_words, &changes, text, name, sizeof name, &given))
        return error_prefix("camera");
    int found = text && *name ? camera_find(scene, name) : 0;
    if (found < 0)
        return false;
    if (n)
        *n = found;
    camera_place(camera, scene, found, time);
    for (int i = 0; camera_words[i].name; i++)
        if (given & 1U << i)
            memcpy((char *)camera + camera_words[i].offset,
                   (char *)&changes + camera_words[i].offset,
                   (size_t)camera_words[i].count * sizeof(float));
    if ((given & (2U | 4U)) && !(given & 1U << FRAME_RIGHT))
        camera_look(camera, camera->eye, camera->forward, given & 4U ? camera->up : changes.up);
    return true;
}

bool emitter_from_text(struct emitter *light, const struct scene *scene, const char *text,
                       double time, int *n) {
    char name[SCENE_NAME_SIZE];
    struct emitter changes = {0};
    unsigned given = 0;
    if (text && !parse_words(light_words, &changes, text, name, sizeof name, &given))
        return error_prefix("light");
    int found = text && *name ? emitter_find(scene, name) : 0;
    if (found < 0)
        return false;
    if (n)
        *n = found;
    emitter_place(light, scene, found, time);
    for (int i = 0; light_words[i].name; i++)
        if (given & 1U << i)
            memcpy((char *)light + light_words[i].offset, (char *)&changes + light_words[i].offset,
                   (size_t)light_words[i].count * sizeof(float));
    if ((given & 2U) && !(given & 1U << FRAME_RIGHT))
        emitter_aim(light, light->direction);
    return true;
}

void camera_to_text(const struct camera *camera, const struct scene *scene, int n, double time,
                    char text[PLACING_TEXT_SIZE]) {
    struct camera before;
    camera_place(&before, scene, n, time);
    snprintf(text, PLACING_TEXT_SIZE, "%d", n);
    append_words(camera_words, camera, &before, text);
}

void emitter_to_text(const struct emitter *light, const struct scene *scene, int n, double time,
                     char text[PLACING_TEXT_SIZE]) {
    struct emitter before;
    emitter_place(&before, scene, n, time);
    snprintf(text, PLACING_TEXT_SIZE, "%d", n);
    append_words(light_words, light, &before, text);
}
