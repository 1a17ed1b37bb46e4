/* Renders what is wanted and composes what is shown of it. */
#include "viewer/viewer.h"

#include "base/error.h"
#include "shared/composite.h"

#include <math.h>

/* A moving picture on a slow machine: what a frame may take. */
static const double moving_ms = 60;

void viewer_full_size(const struct viewer *viewer, int *width, int *height) {
    bool scripted = viewer_is_scripted(viewer), fixed = viewer->fixed_width > 0;
    *width = fixed ? viewer->fixed_width : scripted ? viewer->desc.width : viewer->area.width;
    *height = fixed ? viewer->fixed_height : scripted ? viewer->desc.height : viewer->area.height;
    *width = *width < 16 ? 16 : *width;
    *height = *height < 16 ? 16 : *height;
}

/* --- rendering --- */

/* What is wanted of the renderer, where it differs from what it has. What it refuses goes back to
 * what it was. */
static void follow_wishes(struct viewer *viewer) {
    struct renderer *renderer = &viewer->renderer;
    const struct technique *technique = renderer->desc.technique;
    struct settings wanted = viewer->settings;
    if (viewer->coarse)
        renderer_settings_roughen(&wanted);
    if (!renderer_configure(renderer, viewer->technique, &wanted)) {
        viewer_tell_error(viewer);
        viewer->technique = technique;
        renderer_settings_copy_but_samples(&viewer->settings, &renderer->desc.settings);
    }
    if (technique != viewer->technique)
        pace_forget(&viewer->pace);
    if (!renderer_set_light(renderer, &viewer->placed.light)) {
        viewer_tell_error(viewer);
        viewer->placed.light = renderer->desc.light;
    }
    renderer_set_camera(renderer, &viewer->placed.orbit.camera);
    if (!compare_follow(&viewer->compare, renderer, viewer->coarse))
        viewer_tell_error(viewer);
}

/* Whether a renderer is about to make its technique, and casters with it. */
static bool makes_technique(const struct viewer *viewer) {
    const struct compare *compare = &viewer->compare;
    return renderer_makes_technique(&viewer->renderer, viewer->technique, &viewer->settings) ||
           (compare->mode == COMPARE_TECHNIQUE &&
            (!compare->has_other ||
             renderer_makes_technique(&compare->other, compare->technique, &compare->settings)));
}

/* Casters are those of time 0, as a picture rendered offscreen has them. */
static void follow_wishes_from_start(struct viewer *viewer) {
    struct document *document = &viewer->document;
    bool away = viewer->placed.posed_time != 0 && makes_technique(viewer) &&
                geometry_pose(&document->geometry, &document->scene, 0);
    follow_wishes(viewer);
    if (away)
        geometry_pose(&document->geometry, &document->scene, viewer->placed.posed_time);
}

/* Lower while things move and the machine is slow. */
static void choose_size(struct viewer *viewer, int *width, int *height) {
    const struct pace *pace = &viewer->pace;
    viewer_full_size(viewer, width, height);
    viewer->coarse = false;
    if (viewer_is_scripted(viewer))
        return;
    if (pace->frame_count == 0) /* the first picture is to come soon */
        viewer->coarse = context_is_software(viewer->context);
    if (pace->frame_count == 0 || !viewer->moving)
        return;
    double scale = pace_scale(pace, (double)*width * *height, moving_ms);
    viewer->coarse = scale < 1;
    *width = (int)lround(*width * scale);
    *height = (int)lround(*height * scale);
}

static void render(struct viewer *viewer) {
    struct renderer *renderer = &viewer->renderer;
    int width, height;
    bool was_coarse = viewer->coarse;
    choose_size(viewer, &width, &height);
    bool resized = width != renderer->desc.width || height != renderer->desc.height;
    if (!viewer->dirty && !resized && viewer->coarse == was_coarse)
        return;
    follow_wishes_from_start(viewer);
    if (resized) {
        if (!renderer_resize(renderer, width, height))
            viewer_tell_error(viewer);
        pace_forget(&viewer->pace);
    }
    if (!renderer_update(renderer, &viewer->placed.light, &viewer->placed.orbit.camera)) {
        viewer_tell_error(viewer);
        viewer_close_scene(viewer);
        return;
    }
    renderer_render(renderer);
    if (!compare_render(&viewer->compare, renderer))
        viewer_tell_error(viewer);
    pace_add(&viewer->pace, &renderer->timers, (double)width * height, window_time());
    viewer->dirty = false;
    viewer->recompose = true;
    viewer->frame_count++;
}

/* --- composing --- */

static bool prepare_choice(struct viewer *viewer) {
    struct inspect_choice *choice = &viewer->choice;
    choice->width = viewer->area.width;
    choice->height = viewer->area.height;
    choice->scale = viewer->input->scale;
    int layers = inspect_layers(&viewer->renderer, choice->output);
    if (layers == 0) /* the technique before had it */
        choice->output = NULL;
    if (choice->layer >= layers)
        choice->layer = -1;
    return choice->output;
}

static void compose(struct viewer *viewer) {
    struct renderer *renderer = &viewer->renderer;
    const struct inspect_choice *choice = &viewer->choice;
    bool resized = choice->width != viewer->area.width || choice->height != viewer->area.height;
    if (!viewer->recompose && !resized)
        return;
    viewer->recompose = false;
    renderer_compose(renderer, viewer->layer);
    viewer->left = &renderer->composite.display;
    viewer->right = compare_compose(&viewer->compare, renderer, viewer->layer);
    if (!prepare_choice(viewer))
        return;
    viewer->right = NULL;
    if (inspect_draw(&viewer->inspect, renderer, choice)) {
        viewer->left = &viewer->inspect.canvas;
    } else {
        viewer_tell_error(viewer);
        viewer->choice.output = NULL;
    }
}

/* Errors of a picture at rest. */
static void measure(struct viewer *viewer, bool all) {
    struct compare *compare = &viewer->compare;
    if (!viewer->right || (viewer->moving && !viewer_is_scripted(viewer)) ||
        (compare->measured && !all))
        return;
    if (!compare_measure(compare, &viewer->renderer, viewer->layer, all))
        viewer_tell_error(viewer);
    viewer->recompose = true; /* reading layers used the display's framebuffer state */
}

/* What was clicked on may have moved, and another light may shine on it: at rest, the place where
 * it was is read again. */
static void follow_pick(struct viewer *viewer) {
    const struct renderer_desc *desc = &viewer->renderer.desc;
    float place[2], aspect = (float)desc->width / (float)desc->height;
    if (viewer->moving || !viewer->has_pick || viewer->pick_motion == viewer->pace.last_motion)
        return;
    viewer->has_pick = camera_project(&desc->camera, viewer->pick.position, aspect, place) &&
                       place[0] >= 0 && place[0] < 1 && place[1] >= 0 && place[1] < 1;
    if (viewer->has_pick)
        viewer_pick_surface(viewer, place[0], place[1]);
}

void viewer_update_picture(struct viewer *viewer) {
    render(viewer);
    if (!viewer->has_scene)
        return;
    compose(viewer);
    measure(viewer, false);
    follow_pick(viewer);
}

void viewer_measure_all(struct viewer *viewer) {
    measure(viewer, true);
}

void viewer_step_output(struct viewer *viewer, int step) {
    struct inspect_choice *choice = &viewer->choice;
    struct output_list outputs;
    renderer_outputs(&viewer->renderer, &outputs);
    const struct output *shown = output_find(&outputs, choice->output);
    int places = outputs.count + 1; /* 0: the picture */
    int at = shown ? (int)(shown - outputs.items) + 1 : 0;
    at = (at + places + step) % places;
    choice->output = at > 0 ? outputs.items[at - 1].name : NULL;
    choice->layer = -1;
    viewer->recompose = true;
}

void viewer_pick_surface(struct viewer *viewer, float x, float y) {
    struct pick pick;
    if (!probe_pick(&viewer->probe, &viewer->renderer, x, y, &pick)) {
        viewer_tell_error(viewer);
        return;
    }
    viewer->pick = pick;
    viewer->has_pick = pick.present;
    viewer->pick_motion = viewer->pace.last_motion;
}

void viewer_load_reference(struct viewer *viewer, const char *path) {
    struct compare *compare = &viewer->compare;
    if (!reference_load(&compare->reference, path)) {
        viewer_tell_error(viewer);
        return;
    }
    compare->mode = COMPARE_REFERENCE;
    compare->measured = false;
    /* Errors need pictures of one size. */
    viewer->fixed_width = compare->reference.picture.width;
    viewer->fixed_height = compare->reference.picture.height;
    viewer->dirty = true;
}

struct screen_pictures viewer_pictures(const struct viewer *viewer) {
    const struct compare *compare = &viewer->compare;
    bool heat = viewer->right && compare->heat && compare->heat_map.id;
    return (struct screen_pictures){
        .left = heat ? &compare->heat_map : viewer->left,
        .right = viewer->right,
        .split = compare->only_right ? 0 : compare->split,
    };
}
