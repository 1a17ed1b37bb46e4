#define _POSIX_C_SOURCE 200809L
#include "apps/bench_reference.h"

#include "apps/bench_picture.h"
#include "base/error.h"
#include "base/folder.h"
#include "base/image_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "reference/path_tracer.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

const char *const bench_reference_names[] = {"none", "path", "centers", "vpls", NULL};

/* FNV-1a, 64 bits. */
static uint64_t hash_byte(uint64_t hash, int byte) {
    return (hash ^ (uint64_t)byte) * 0x100000001b3u;
}

static bool hash_file(const char *path, uint64_t *hash) {
    FILE *file = fopen(path, "rb");
    if (!file)
        return error_set("cannot open %s: %s", path, strerror(errno));
    *hash = 0xcbf29ce484222325u;
    for (int c; (c = fgetc(file)) != EOF;)
        *hash = hash_byte(*hash, c);
    fclose(file);
    return true;
}

static uint64_t hash_text(uint64_t hash, const char *text) {
    for (const char *c = text ? text : ""; *c; c++)
        hash = hash_byte(hash, *c);
    return hash_byte(hash, 0);
}

/* What a rendered reference depends on beside the scene. */
static uint64_t hash_settings(uint64_t hash) {
    struct settings settings;
    renderer_settings_init(&settings);
    for (struct setting s = {0}; settings_next(&settings, &s);) {
        char text[128];
        snprintf(text, sizeof text, "%s.%s=%g ", s.part->owner, s.option->name,
                 s.option->default_value);
        hash = hash_text(hash, text);
    }
    return hash;
}

/* $XDG_CACHE_HOME/manylight, or ~/.cache/manylight. */
static char *default_folder(void) {
    const char *cache = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    if (cache && *cache)
        return mem_printf("%s/manylight", cache);
    if (home && *home)
        return mem_printf("%s/.cache/manylight", home);
    error_set("no folder for references: neither XDG_CACHE_HOME nor HOME is set");
    return NULL;
}

char *bench_reference_path(const struct bench_reference_desc *desc) {
    uint64_t hash = 0;
    if (!hash_file(desc->scene_path, &hash))
        return NULL;
    if (desc->stage->camera_text || desc->stage->light_text)
        hash = hash_text(hash_text(hash, desc->stage->camera_text), desc->stage->light_text);
    char *folder = desc->cache ? mem_strdup(desc->cache) : default_folder();
    if (!folder)
        return NULL;
    char how[32];
    if (desc->kind == BENCH_REFERENCE_VPLS) {
        snprintf(how, sizeof how, "vpls");
        hash = hash_settings(hash);
    } else {
        snprintf(how, sizeof how, "%s-%g", bench_reference_names[desc->kind], desc->noise);
    }
    char *path = mem_printf("%s/%s-%dx%d-%s-%016llx.exr", folder, desc->stage->name, desc->width,
                            desc->height, how, (unsigned long long)hash);
    free(folder);
    return path;
}

bool bench_reference_trace(const struct bench_reference_desc *desc, struct image *image) {
    return path_tracer_render(
        &(struct path_tracer_desc){.scene = &desc->stage->scene,
                                   .geometry = &desc->stage->geometry,
                                   .camera = &desc->stage->camera,
                                   .emitters = desc->stage->emitters,
                                   .width = desc->width,
                                   .height = desc->height,
                                   .bounces = 1,
                                   .noise = desc->noise,
                                   .centers = desc->kind == BENCH_REFERENCE_CENTERS},
        image, NULL);
}

static bool render_all_vpls(const struct bench_reference_desc *desc, struct image *image) {
    struct bench_case all = {.series = "reference", .width = desc->width, .height = desc->height};
    snprintf(all.scene, sizeof all.scene, "%s", desc->stage->name);
    renderer_settings_init(&all.settings);
    return bench_assign_all(&all, "technique=instant-radiosity,interleave=1,blur-radius=0") &&
           bench_picture_render(&all, desc->stage, desc->software, image);
}

bool bench_reference_get(const struct bench_reference_desc *desc, struct image *image) {
    *image = (struct image){0};
    char *path = bench_reference_path(desc);
    if (!path)
        return false;
    struct stat status;
    bool ok;
    if (stat(path, &status) == 0) {
        log_detail("reference %s", path);
        ok = image_read(image, path);
    } else {
        log_note("making reference %s", path);
        ok = folder_make_for(path) &&
             (desc->kind == BENCH_REFERENCE_VPLS ? render_all_vpls(desc, image)
                                                 : bench_reference_trace(desc, image)) &&
             image_write(image, path);
    }
    if (!ok)
        image_free(image), *image = (struct image){0};
    free(path);
    return ok;
}
