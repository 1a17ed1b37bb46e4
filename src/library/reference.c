/* The path-traced reference: as apps/reference.c has it. */
#include "base/error.h"
#include "inspect/aov.h"
#include "library/desc.h"
#include "library/door.h"
#include "library/image.h"
#include "library/scene.h"
#include "quality/picture.h"
#include "renderer/about.h"
#include "renderer/settings.h"
#include "scene/material.h"
#include "scene/lens.h"
#include "scene/medium.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct tracing {
    struct manylight_reference_desc desc;
    struct manylight_view view;
    struct settings settings;
    int materials;
    bool cancelled;
};

static bool refuse(const char *reason) {
    error_set("%s", reason);
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool find_materials(struct tracing *tracing) {
    const char *name = tracing->desc.materials;
    tracing->materials = MATERIALS_FULL;
    for (int i = 0; name && materials_names[i]; i++)
        if (strcmp(name, materials_names[i]) == 0) {
            tracing->materials = i;
            return true;
        }
    return !name || refuse("materials: it is neither full nor diffuse");
}

static bool check_numbers(const struct manylight_reference_desc *desc) {
    return desc_check("noise", (double)desc->noise, 0, 1) &&
           desc_check("samples", desc->samples, 0, INFINITY) &&
           desc_check("paths", desc->paths, 0, INFINITY) &&
           desc_check("light_paths", desc->light_paths, 0, INFINITY) &&
           desc_check("threads", desc->threads, 0, INFINITY) &&
           (desc->bounces == MANYLIGHT_ZERO || desc_check("bounces", desc->bounces, 0, 1000)) &&
           desc_check("ao_distance", (double)desc->ao_distance, 0, INFINITY);
}

static bool check(struct tracing *tracing) {
    struct manylight_reference_desc *desc = &tracing->desc;
    desc->smooth = desc->smooth || desc->light_paths > 0;
    if (desc->noise > 0 && desc->samples > 0)
        return refuse("--spp and --noise exclude each other");
    if (!check_numbers(desc) || !aov_check_surfaces(desc->outputs, desc->centers != 0))
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    if (!find_materials(tracing))
        return false;
    return !desc->smooth || tracing->materials == MATERIALS_FULL ||
           refuse(desc->light_paths > 0
                      ? "--light-paths is for --materials full, which has glass and mirrors"
                      : "--smooth is for --materials full, which has glass and mirrors");
}

/* Paths know of the medium alone. */
static bool assign(struct tracing *tracing) {
    struct settings *settings = &tracing->settings;
    const char *text = tracing->desc.settings;
    renderer_settings_init(settings);
    if (text && !renderer_settings_assign(settings, technique_default, &text, 1))
        return door_blame(MANYLIGHT_BAD_SETTING);
    for (int i = 0; i < settings->part_count; i++)
        if (settings->given[i] && settings->parts[i] != &medium_part) {
            error_set("--set %s...: for --technique vpl-raytraced; paths take settings of "
                      "the medium alone",
                      settings->parts[i]->owner);
            return door_blame(MANYLIGHT_BAD_SETTING);
        }
    return true;
}

static bool tell(struct tracing *tracing, double done, const char *note) {
    const struct manylight_view *view = &tracing->view;
    if (view->progress && view->progress(view->user, done, note) != 0)
        tracing->cancelled = true;
    return !tracing->cancelled;
}

static bool tell_paths(void *user, const struct path_tracer_progress *progress) {
    char note[PATH_NOTE_SIZE];
    path_progress_note(note, progress);
    return tell(user, progress->done, note);
}

static bool tell_light(void *user, double done) {
    return tell(user, done, "light paths");
}

/* Traces paths, with the motion that layers want. */
static bool trace_moving(const struct tracing *tracing, struct loan *loan,
                         const struct path_tracer_desc *desc, struct image *image) {
    const struct manylight_view *view = &tracing->view;
    struct path_tracer_desc paths = *desc;
    struct surface_motion motion = {.positions = {NULL}};
    struct camera others[2];
    paths.motion = &motion;
    bool ok = !surface_layers_move(desc->surface_layers) ||
              ((!view->placed || loan_place_others(view, others)) &&
               loan_find_motion(loan, view->camera, view->placed ? others : NULL, view->time,
                                view->step, &motion));
    ok = ok && picture_trace_paths(&loan->stage, &paths, image, NULL);
    surface_motion_free(&motion);
    return ok;
}

static bool trace(struct tracing *tracing, struct loan *loan, struct image *image) {
    const struct manylight_reference_desc *desc = &tracing->desc;
    int size[2];
    const struct camera *camera = &loan->stage.camera;
    if (!loan_pose(loan, &tracing->view) ||
        !loan_size(loan, tracing->view.camera, desc->width, desc->height, size))
        return false;
    if (desc->width == 0)
        lens_default_size(camera, size);
    if (!lens_check_size(camera, size[0], size[1]))
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    if (desc->light_paths > 0 && (camera_is_wide(camera) || camera_is_distorted(camera)))
        return refuse("--light-paths: for a plain pinhole, without lens=, skew and distortion");
    struct medium medium =
        medium_of(&loan->stage.scene, &tracing->settings, loan->stage.geometry.radius);
    const struct path_tracer_desc paths = {.width = size[0],
                                           .height = size[1],
                                           .bounces = desc->bounces == 0 ? 1
                                                      : desc->bounces == MANYLIGHT_ZERO
                                                          ? 0
                                                          : desc->bounces,
                                           .samples = desc->samples,
                                           .paths = desc->paths,
                                           .noise = (double)desc->noise,
                                           .seed = desc->seed,
                                           .materials = tracing->materials,
                                           .medium = medium,
                                           .smooth = desc->smooth != 0,
                                           .centers = desc->centers != 0,
                                           .seen = desc->seen != 0,
                                           .ao_distance = desc->ao_distance,
                                           .hides_sky = desc->hide_environment != 0,
                                           .denoise = desc->denoise != 0,
                                           .surface_layers = desc->outputs,
                                           .threads = desc->threads,
                                           .progress = tell_paths,
                                           .user = tracing};
    if (!trace_moving(tracing, loan, &paths, image))
        return false;
    const struct light_tracer_desc light = {.paths = desc->light_paths,
                                            .medium = medium,
                                            .seed = desc->seed,
                                            .threads = desc->threads,
                                            .progress = tell_light,
                                            .user = tracing};
    struct light_tracer_result result;
    return desc->light_paths == 0 || picture_trace_light(&loan->stage, &light, image, &result);
}

/* As apps/reference.c tells them. */
static void tell_facts(const struct tracing *tracing, const struct loan *loan,
                       struct image *image) {
    const struct manylight_view *view = &tracing->view;
    about_add(image, &(struct about){.scene = loan->stage.scene.path,
                                     .camera = view->placed ? "placed" : view->camera,
                                     .technique = "path",
                                     .placed = &loan->stage.camera,
                                     .settings = &tracing->settings,
                                     .time = view->time});
}

static bool reference(const struct manylight_scene *scene,
                      const struct manylight_reference_desc *given, struct manylight_image **out) {
    struct tracing tracing = {.cancelled = false};
    struct loan loan;
    struct image image = {0};
    if (!desc_take(&tracing.desc, sizeof tracing.desc, given, "manylight_reference_desc") ||
        !desc_take(&tracing.view, sizeof tracing.view, tracing.desc.view, "manylight_view") ||
        !check(&tracing) || !assign(&tracing))
        return false;
    if (!scene_use(scene) || !loan_take(&loan, scene)) {
        scene_leave(scene);
        return false;
    }
    bool ok = trace(&tracing, &loan, &image);
    if (ok) {
        tell_facts(&tracing, &loan, &image);
        *out = image_wrap(&image);
    } else {
        image_free(&image);
    }
    if (!ok && tracing.cancelled)
        door_blame(MANYLIGHT_CANCELLED);
    scene_leave(scene);
    loan_return(&loan);
    return ok;
}

enum manylight_status manylight_reference(const struct manylight_scene *scene,
                                          const struct manylight_reference_desc *desc,
                                          struct manylight_image **image) {
    struct door door;
    *image = NULL;
    door_enter(&door);
    return door_leave(&door, reference(scene, desc, image), MANYLIGHT_FAILED);
}
