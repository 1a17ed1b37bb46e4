#define _DEFAULT_SOURCE
#include "scene/clips.h"

#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/names.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the default ------------------------------------------------------------------------------ */

enum { NODE_PATHS = CHANNEL_VISIBLE + 1 };

/* Everything that channels move has a place in a row: of all nodes, all lights, all cameras, all
 * materials. */
static size_t place_of(const struct scene *scene, const struct channel *channel) {
    const size_t target = (size_t)channel->target, lights = (size_t)scene->node_count * NODE_PATHS,
                 cameras = lights + (size_t)scene->light_count * sizeof(struct scene_light),
                 materials = cameras + (size_t)scene->camera_count * sizeof(struct scene_camera);
    switch (channel->path) {
    case CHANNEL_LIGHT:
        return lights + target * sizeof(struct scene_light) + channel->offset;
    case CHANNEL_CAMERA:
        return cameras + target * sizeof(struct scene_camera) + channel->offset;
    case CHANNEL_MATERIAL:
        return materials + target * sizeof(struct material) + channel->offset;
    default:
        return target * NODE_PATHS + channel->path;
    }
}

/* Whether none of its channels moves what is taken. */
static bool is_free(const struct scene *scene, const struct clip *clip, const bool *taken) {
    for (int i = 0; i < clip->channel_count; i++)
        if (taken[place_of(scene, &clip->channels[i])])
            return false;
    return true;
}

/* Into room for all clips. */
static int find_default(const struct scene *scene, int *playing) {
    const struct channel end = {.path = CHANNEL_MATERIAL, .target = scene->material_count};
    bool *taken = mem_alloc(place_of(scene, &end), sizeof *taken);
    int count = 0;
    for (int n = 0; n < scene->clip_count; n++) {
        const struct clip *clip = &scene->clips[n];
        if (!is_free(scene, clip, taken))
            continue;
        for (int i = 0; i < clip->channel_count; i++)
            taken[place_of(scene, &clip->channels[i])] = true;
        playing[count++] = n;
    }
    free(taken);
    return count;
}

/* Takes the array. */
static void play(struct scene *scene, int *playing, int count, bool by_default) {
    free(scene->playing);
    scene->playing = playing;
    scene->playing_count = count;
    scene->plays_default = by_default;
    scene->clip_choice++;
}

void clips_play_default(struct scene *scene) {
    int *playing = mem_alloc((size_t)scene->clip_count, sizeof *playing);
    play(scene, playing, find_default(scene, playing), true);
}

int clips_default_count(const struct scene *scene) {
    int *playing = mem_alloc((size_t)scene->clip_count, sizeof *playing);
    int count = find_default(scene, playing);
    free(playing);
    return count;
}

static void add_name(struct names *names, const struct scene *scene, int n) {
    char name[SCENE_NAME_SIZE + 16];
    snprintf(name, sizeof name, "%d%s%s", n, *scene->clips[n].name ? "=" : "",
             scene->clips[n].name);
    names_add(names, ", ", name);
}

void clips_note_left_out(const struct scene *scene) {
    struct names left_out = {0};
    for (int n = 0; n < scene->clip_count; n++)
        if (!clip_plays(scene, n))
            add_name(&left_out, scene, n);
    if (left_out.length)
        log_note("%s: these clips move what one before them moves, so they do not play: %s; --clip "
                 "picks some",
                 scene->path, left_out.text);
}

/* --- a choice --------------------------------------------------------------------------------- */

/* -1: there is none such. */
static int find_clip(const struct scene *scene, const char *text) {
    char *end;
    long number = strtol(text, &end, 10);
    for (int n = 0; n < scene->clip_count; n++)
        if (*text && strcmp(scene->clips[n].name, text) == 0)
            return n;
    bool is_number = *text && !*end && number >= 0 && number < scene->clip_count;
    return is_number ? (int)number : -1;
}

static bool refuse(const struct scene *scene, const char *text) {
    enum { MOST_LISTED = 20 };
    char list[MOST_LISTED * (SCENE_NAME_SIZE + 16)] = "";
    for (int n = 0; n < scene->clip_count && n < MOST_LISTED; n++) {
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, " %d%s%s", n, *scene->clips[n].name ? "=" : "",
                 scene->clips[n].name);
    }
    return error_set("no clip '%s' (there is:%s)", text, *list ? list : " none");
}

/* Each once; a name may hold commas. */
static bool add_clip(const struct scene *scene, const char *text, int *playing, int *count) {
    int n = find_clip(scene, text);
    if (n < 0)
        return refuse(scene, text);
    for (int i = 0; i < *count; i++)
        if (playing[i] == n)
            return true;
    playing[(*count)++] = n;
    return true;
}

static bool add_list(const struct scene *scene, const char *text, int *playing, int *count) {
    if (find_clip(scene, text) >= 0 || !strchr(text, ','))
        return add_clip(scene, text, playing, count);
    char *copy = mem_strdup(text), *rest = copy, *name;
    bool ok = true;
    while (ok && (name = strsep(&rest, ",")))
        ok = add_clip(scene, name + strspn(name, " "), playing, count);
    free(copy);
    return ok;
}

bool clips_select(struct scene *scene, const char *text) {
    bool by_default = !*text || (strcmp(text, "all") == 0 && find_clip(scene, text) < 0);
    if (by_default) {
        clips_play_default(scene);
        return true;
    }
    int *playing = mem_alloc((size_t)scene->clip_count, sizeof *playing), count = 0;
    if (!add_list(scene, text, playing, &count)) {
        free(playing);
        return false;
    }
    play(scene, playing, count, false);
    return true;
}

bool clip_plays(const struct scene *scene, int n) {
    for (int i = 0; i < scene->playing_count; i++)
        if (scene->playing[i] == n)
            return true;
    return false;
}

void clips_to_text(const struct scene *scene, char text[CLIPS_TEXT_SIZE]) {
    size_t used = 0;
    *text = '\0';
    for (int i = 0; !scene->plays_default && i < scene->playing_count; i++) {
        char number[16];
        int length = snprintf(number, sizeof number, "%s%d", i ? "," : "", scene->playing[i]);
        if (used + (size_t)length >= CLIPS_TEXT_SIZE)
            break;
        memcpy(text + used, number, (size_t)length + 1);
        used += (size_t)length;
    }
}
