#define _POSIX_C_SOURCE 200809L
#include "lab/measure/reference.h"

#include "base/error.h"
#include "base/file/folder.h"
#include "base/file/image_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/progress.h"
#include "lab/measure/variants.h"
#include "quality/picture.h"
#include "scene/caustics.h"
#include "scene/hash.h"
#include "scene/material.h"
#include "scene/medium.h"

#include "sources.h"

#include <math.h>
#include <unistd.h>

const char *const reference_names[] = {"none", "path", "centers", "vpls", "seen", "ao", NULL};

const char reference_vpls[] = "R:technique=instant-radiosity,interleave=1,blur-radius=0";

static int materials_of(const struct measure_desc *desc) {
    const struct material_settings *surface =
        settings_of(struct material_settings, &desc->settings, &material_part);
    return surface->materials;
}

static float ao_distance_of(const struct measure_desc *desc) {
    return renderer_ao_distance(&desc->settings, &desc->stage->geometry);
}

static struct medium medium_shown(const struct measure_desc *desc) {
    const struct stage *stage = desc->stage;
    return medium_of(&stage->scene, &desc->settings, stage->geometry.radius);
}

static bool has_smooth(const struct measure_desc *desc) {
    return caustics_shown(&desc->stage->scene, &desc->settings);
}

/* --- where it is kept ------------------------------------------------------------------------- */

/* Of all that the reference depends on; the renderer's own picture on all sources. */
static uint64_t hash_of(const struct measure_desc *desc, enum reference_kind kind) {
    static const char tracer[] = MANYLIGHT_TRACER, all[] = MANYLIGHT_SOURCES;
    const struct stage *stage = desc->stage;
    int materials = materials_of(desc);
    float ao_distance = ao_distance_of(desc);
    uint64_t sum = scene_hash(&stage->scene, &stage->geometry, &stage->camera, &stage->emitters);
    hash_bytes(&sum, kind == REFERENCE_VPLS ? all : tracer,
               kind == REFERENCE_VPLS ? sizeof all : sizeof tracer);
    if (materials != MATERIALS_FULL)
        hash_bytes(&sum, &materials, sizeof materials);
    if (kind == REFERENCE_AO)
        hash_bytes(&sum, &ao_distance, sizeof ao_distance);
    bool smooth = has_smooth(desc);
    if (smooth)
        hash_bytes(&sum, &smooth, sizeof smooth);
    struct medium medium = medium_shown(desc);
    if (medium_exists(&medium))
        hash_bytes(&sum, &medium, sizeof medium);
    return sum;
}

static char *default_folder(void) {
    char *folder = folder_of_user("XDG_CACHE_HOME", ".cache");
    if (!folder)
        error_prefix("no folder for references");
    return folder;
}

char *reference_path(const struct reference_desc *reference, const struct measure_desc *desc) {
    char *folder = reference->cache ? mem_strdup(reference->cache) : default_folder(),
         noise[32] = "", bounces[32] = "";
    if (!folder)
        return NULL;
    if (measure_bounces(desc) > 1)
        snprintf(bounces, sizeof bounces, "-%d-bounces", measure_bounces(desc));
    if (reference->kind != REFERENCE_VPLS)
        snprintf(noise, sizeof noise, "-%g", reference->noise);
    char *path = mem_printf("%s/%s-%dx%d-%s%s%s-%016llx.exr", folder, desc->stage->name,
                            desc->width, desc->height, reference_names[reference->kind], bounces,
                            noise, (unsigned long long)hash_of(desc, reference->kind));
    free(folder);
    return path;
}

/* --- how it is made --------------------------------------------------------------------------- */

static struct path_tracer_desc tracer_of(const struct reference_desc *reference,
                                         const struct measure_desc *desc) {
    bool seen = reference->kind == REFERENCE_SEEN, ao = reference->kind == REFERENCE_AO;
    return (struct path_tracer_desc){.width = desc->width,
                                     .height = desc->height,
                                     .bounces = seen || ao ? 0 : measure_bounces(desc),
                                     .noise = reference->noise,
                                     .materials = materials_of(desc),
                                     .medium = medium_shown(desc),
                                     .smooth = has_smooth(desc),
                                     .centers = seen || reference->kind == REFERENCE_CENTERS,
                                     .ao_distance = ao ? ao_distance_of(desc) : 0,
                                     .ao_alone = ao,
                                     .seen = seen};
}

bool reference_trace(const struct reference_desc *reference, const struct measure_desc *desc,
                     struct image *image) {
    struct path_tracer_desc tracer = tracer_of(reference, desc);
    return picture_trace_paths(desc->stage, &tracer, image, NULL);
}

static bool show(void *user, const struct path_tracer_progress *progress) {
    progress_show(user, progress->done, "reference");
    return true;
}

/* The same, with a line of progress. */
static bool trace_file(const struct reference_desc *reference, const struct measure_desc *desc,
                       struct image *image) {
    struct progress progress;
    struct path_tracer_desc tracer = tracer_of(reference, desc);
    tracer.progress = show;
    tracer.user = &progress;
    progress_start(&progress, "reference");
    bool ok = picture_trace_paths(desc->stage, &tracer, image, NULL);
    progress_end(&progress);
    return ok;
}

static bool render_all_vpls(const struct measure_desc *desc, struct image *image) {
    struct measure_desc all = measure_default(desc->stage, desc->width, desc->height);
    char bounces[32];
    snprintf(bounces, sizeof bounces, "bounces=%d", measure_bounces(desc));
    settings_copy(&all.settings, &desc->settings, &material_part);
    settings_copy(&all.settings, &desc->settings, &medium_part);
    return variant_apply(&all, reference_vpls) && measure_assign(&all, bounces) &&
           picture_render(&all, image);
}

static bool make_file(const struct reference_desc *reference, const struct measure_desc *desc,
                      const char *path) {
    struct image image = {0};
    log_note("making reference %s", path);
    bool ok = folder_make_for(path) &&
              (reference->kind == REFERENCE_VPLS ? render_all_vpls(desc, &image)
                                                 : trace_file(reference, desc, &image)) &&
              image_write(&image, path);
    image_free(&image);
    return ok;
}

/* Also what was made now comes from its file, which has half floats: figures are the same the first
 * time. */
bool reference_get(const struct reference_desc *reference, const struct measure_desc *desc,
                   struct image *image) {
    *image = (struct image){0};
    char *path = reference_path(reference, desc);
    if (!path)
        return false;
    log_detail("reference %s", path);
    bool ok =
        (access(path, F_OK) == 0 || make_file(reference, desc, path)) && image_read(image, path);
    free(path);
    return ok;
}

/* Alpha: the channel by which pixels count, or -1. */
static double noise_of(const struct image *image, int alpha) {
    int indirect[3], error[3];
    if (!image_find_layer(image, "indirect", indirect) ||
        !image_find_layer(image, "standard_error", error))
        return 0;
    double sum = 0, square_sum = 0, values = 3.0 * image->width * image->height;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int c = 0; c < 3; c++) {
                const float *pixel = image_at(image, x, y);
                double share = alpha < 0 ? 1 : (double)pixel[alpha];
                sum += share * (double)pixel[indirect[c]];
                square_sum += pow(share * (double)pixel[error[c]], 2);
            }
    return sum > 0 ? sqrt(square_sum / values) / (sum / values) : 0;
}

double reference_noise(const struct image *image) {
    return noise_of(image, -1);
}

double reference_noise_covered(const struct image *image) {
    return noise_of(image, image_find_channel(image, "A"));
}
