#include "quality/picture.h"

#include "inspect/lights.h"
#include "reference/vpl_sum.h"
#include "scene/caustics.h"
#include "scene/material.h"
#include "scene/medium.h"
#include "techniques/many_lights.h"

#include <stdio.h>

bool picture_render(const struct measure_desc *desc, struct image *image) {
    struct renderer renderer;
    *image = (struct image){0};
    if (!measure_start(&renderer, desc))
        return false;
    renderer_render(&renderer);
    bool ok = renderer_read_layers(&renderer, image);
    renderer_free(&renderer);
    return ok;
}

/* The VPLs do not depend on the picture's size, and a frame of few pixels costs little. Sums over
 * them know no medium, and so do they. */
static bool make_lights(const struct measure_desc *desc, struct lights *lights) {
    struct measure_desc small = *desc;
    struct renderer renderer;
    small.width = small.height = 16;
    if (!settings_assign(&small.settings, "medium.scatter=0 medium.absorb=0 medium.scene=off") ||
        !measure_start(&renderer, &small))
        return false;
    renderer_render(&renderer);
    bool ok = lights_read(lights, &renderer);
    renderer_free(&renderer);
    return ok;
}

static bool show(void *user, double done) {
    if (user)
        progress_show(user, done, "");
    return true;
}

/* Of shapes of light that only the gather knows, the disk. */
static const enum geometry_bound bounds[] = {
    [GATHER_CLAMP_NONE] = GEOMETRY_UNBOUNDED, [GATHER_CLAMP_VALUE] = GEOMETRY_CLAMPED,
    [GATHER_CLAMP_DISK] = GEOMETRY_DISK,      [GATHER_CLAMP_NEAR] = GEOMETRY_DISK,
    [GATHER_CLAMP_SPHERE] = GEOMETRY_DISK,    [GATHER_CLAMP_RECTANGLE] = GEOMETRY_DISK,
    [GATHER_CLAMP_PATCH] = GEOMETRY_DISK,     [GATHER_CLAMP_RECTANGLE_NEAR] = GEOMETRY_DISK,
};

bool picture_trace(const struct measure_desc *desc, struct progress *progress,
                   struct image *image) {
    const struct stage *stage = desc->stage;
    struct lights lights;
    *image = (struct image){0};
    if (!make_lights(desc, &lights))
        return false;
    const struct gather_settings *gather =
        settings_of(struct gather_settings, &desc->settings, &gather_part);
    const struct material_settings *surface =
        settings_of(struct material_settings, &desc->settings, &material_part);
    float radius = stage->geometry.radius;
    bool ok = vpl_sum_render(
        &(struct vpl_sum_desc){.scene = &stage->scene,
                               .geometry = &stage->geometry,
                               .camera = &stage->camera,
                               .emitters = stage->emitters,
                               .vpls = lights.vpls,
                               .vpl_count = lights.vpl_count,
                               .width = desc->width,
                               .height = desc->height,
                               .term = {.bound = bounds[gather->clamp],
                                        .clamp_value = many_lights_clamp_value / (radius * radius)},
                               .materials = surface->materials,
                               .progress = show,
                               .user = progress},
        image);
    lights_free(&lights);
    return ok;
}

struct path_tracer_desc picture_paths(const struct measure_desc *desc) {
    const struct stage *stage = desc->stage;
    return (struct path_tracer_desc){
        .width = desc->width,
        .height = desc->height,
        .bounces = measure_bounces(desc),
        .materials =
            settings_of(struct material_settings, &desc->settings, &material_part)->materials,
        .smooth = caustics_shown(&stage->scene, &desc->settings),
        .medium = medium_of(&stage->scene, &desc->settings, stage->geometry.radius)};
}

bool picture_trace_paths(const struct stage *stage, const struct path_tracer_desc *desc,
                         struct image *image, struct path_tracer_progress *reached) {
    struct path_tracer_desc placed = *desc;
    placed.scene = &stage->scene;
    placed.geometry = &stage->geometry;
    placed.camera = &stage->camera;
    placed.emitters = stage->emitters;
    return path_tracer_render(&placed, image, reached);
}

bool picture_trace_light(const struct stage *stage, const struct light_tracer_desc *desc,
                         struct image *image, struct light_tracer_result *result) {
    struct light_tracer_desc placed = *desc;
    placed.scene = &stage->scene;
    placed.geometry = &stage->geometry;
    placed.camera = &stage->camera;
    placed.emitters = stage->emitters;
    placed.width = image->width;
    placed.height = image->height;
    return light_tracer_render(&placed, image, result);
}

void path_progress_note(char note[PATH_NOTE_SIZE], const struct path_tracer_progress *progress) {
    *note = '\0';
    if (progress->samples > 0)
        snprintf(note, PATH_NOTE_SIZE, "%d samples, noise %.2f %%", progress->samples,
                 100 * progress->noise);
}

bool path_progress_show(void *user, const struct path_tracer_progress *progress) {
    char note[PATH_NOTE_SIZE];
    path_progress_note(note, progress);
    progress_show(user, progress->done, note);
    return true;
}
