/* What a frame starts from: views of camera and lights, medium and emission. */
#include "renderer/views.h"

#include "base/halton.h"
#include "renderer/airlight.h"
#include "renderer/caustics.h"
#include "renderer/sky_pieces.h"
#include "scene/material.h"

#include <math.h>

bool renderer_has_specular(const struct renderer_desc *desc) {
    const struct material_settings *own =
        settings_of(struct material_settings, &desc->settings, &material_part);
    return own->materials == MATERIALS_FULL && !materials_are_plain(desc->scene) &&
           desc->direct->specular;
}

struct medium renderer_medium(const struct renderer_desc *desc) {
    return medium_of(desc->scene, &desc->settings, desc->geometry->radius);
}

/* Where in its pixel a pass looks, from -1/2 to 1/2: the first in the middle. */
static float place_in_pixel(uint32_t base, int pass) {
    return (float)(fmod(radical_inverse(base, (uint32_t)pass) + .5, 1) - .5);
}

/* Reflective shadow maps of each pass lie elsewhere, by a texel of 1024 or less, and see other
 * things. */
static void shift_light_samples(struct renderer *renderer) {
    const struct light_block *block = renderer->sample_block;
    const float ndc[2] = {place_in_pixel(5, renderer->pass) / 512,
                          place_in_pixel(7, renderer->pass) / 512};
    for (int i = 0; i < block->single_count + block->face_count; i++)
        view_shift(&renderer->sample_block->views[i].view, ndc);
}

static void place_light_samples(struct renderer *renderer) {
    struct light_plan *plan = &renderer->plan;
    plan->light_samples.flux = renderer->sampled.flux;
    light_samples_place(&renderer->light_samples, &plan->mapped,
                        &(struct light_samples_sky){&plan->sky, &plan->sky_samples},
                        &plan->light_samples, renderer->pass);
    renderer->sample_emitters = light_samples_emitters(&renderer->light_samples);
}

/* Looks at triangles, so only where another view may cut others. */
static void follow_range(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    const float aspect = (float)desc->width / (float)desc->height;
    struct ranged *of = &renderer->ranged;
    if (of->geometry == desc->geometry && of->pose == desc->geometry->pose_count &&
        of->aspect == aspect && cameras_same(&of->camera, &desc->camera))
        return;
    *of = (struct ranged){desc->geometry, desc->geometry->pose_count, aspect, desc->camera};
    renderer->camera_range = camera_range_of(&desc->camera, desc->geometry, aspect);
}

void renderer_write_views(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    const float place[2] = {2 * place_in_pixel(2, renderer->pass) / (float)desc->width,
                            2 * place_in_pixel(3, renderer->pass) / (float)desc->height};
    view_of_camera(&renderer->camera_view, &desc->camera, desc->geometry,
                   (float)desc->width / (float)desc->height);
    follow_range(renderer);
    if (renderer->pass > 0)
        view_shift(&renderer->camera_view, place);
    views_of_emitters(renderer->light_block, &renderer->plan.mapped, desc->geometry);
    place_light_samples(renderer);
    views_of_emitters(renderer->sample_block, &renderer->sample_emitters, desc->geometry);
    sky_pieces_write(renderer);
    if (renderer->pass > 0)
        shift_light_samples(renderer);
    buffer_write(&renderer->view_buffer, 0, sizeof renderer->camera_view, &renderer->camera_view);
    buffer_write(&renderer->light_buffer, 0, sizeof *renderer->light_block, renderer->light_block);
    buffer_write(&renderer->sample_buffer, 0, sizeof *renderer->sample_block,
                 renderer->sample_block);
    struct medium medium = renderer_medium(desc);
    airlight_set_medium(&renderer->airlight, &medium, desc->geometry);
    scene_gpu_set_smooth_black(&renderer->scene, renderer_has_caustics(desc));
    scene_gpu_set_glow(&renderer->scene, &desc->emitters, renderer_has_specular(desc),
                       renderer_irradiance_scale(renderer));
}
