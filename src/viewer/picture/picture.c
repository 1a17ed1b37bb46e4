#include "viewer/picture/picture.h"

#include "viewer/picture/budget.h"
#include "viewer/picture/legend.h"

#include <cglm/cglm.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A moving picture on a slow machine: what a frame may take. */
static const double moving_ms = 60;

/* A first picture on software OpenGL. */
static const double first_pixels = 40000;

const char busy_compiling[] = "compiling shaders \xe2\x80\xa6";

/* What takes longer is announced. */
static const double long_ms = 300;

void viewer_full_size(const struct viewer *viewer, int *width, int *height) {
    bool scripted = viewer_is_scripted(viewer), fixed = viewer->shown.fixed_width > 0;
    *width = fixed      ? viewer->shown.fixed_width
             : scripted ? viewer->desc.width
                        : viewer->shown.area.width;
    *height = fixed      ? viewer->shown.fixed_height
              : scripted ? viewer->desc.height
                         : viewer->shown.area.height;
    *width = *width < 16 ? 16 : *width;
    *height = *height < 16 ? 16 : *height;
}

/* --- rendering --- */

/* The renderer always has a method; one that its lights ask for by themselves need not be named. */
static void take_direct_back(struct viewer *viewer) {
    const struct renderer_desc *desc = &viewer->shown.renderer.desc;
    const struct direct_method *by_lights = direct_for(&desc->emitters);
    const struct direct_method *wanted = viewer->wish.direct ? viewer->wish.direct : by_lights;
    if (wanted != desc->direct)
        viewer->wish.direct = desc->direct == by_lights ? NULL : desc->direct;
}

/* What the renderer refuses goes back to what it was. */
static void take_wishes_back(struct viewer *viewer) {
    const struct renderer_desc *desc = &viewer->shown.renderer.desc;
    viewer_tell_error(viewer);
    viewer->wish.technique = desc->technique;
    renderer_settings_copy_but_samples(&viewer->wish.settings, &desc->settings);
    emitters_free(&viewer->placed.emitters);
    viewer->placed.emitters = emitters_copy(&desc->emitters);
    take_direct_back(viewer);
    if (viewer->placed.chosen_light >= desc->emitters.count)
        viewer->placed.chosen_light = 0;
}

/* What is wanted of the renderer. */
static struct renderer_desc wished(const struct viewer *viewer) {
    struct renderer_desc desc = viewer->shown.renderer.desc;
    desc.technique = viewer->wish.technique;
    desc.direct = viewer->wish.direct;
    desc.settings = viewer->wish.settings;
    desc.emitters = viewer->placed.emitters;
    desc.camera = viewer->placed.orbit.camera;
    return desc;
}

/* As far as shaders are there for it. */
static struct renderer_desc possible(const struct viewer *viewer) {
    const struct renderer_desc *now = &viewer->shown.renderer.desc;
    struct renderer_desc desc = wished(viewer);
    if (viewer->shown.awaits) {
        desc.technique = now->technique;
        desc.direct = now->direct;
        desc.emitters = now->emitters;
        renderer_settings_copy_but_samples(&desc.settings, &now->settings);
        settings_copy(&desc.settings, &viewer->wish.settings, &picture_part);
    }
    return desc;
}

static bool follow_wishes(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    struct renderer_desc desc = possible(viewer);
    /* While a setting is dragged, passes are not made anew at each step. */
    desc.progressive &= !renderer_makes_technique(&shown->renderer, desc.technique, &desc.settings);
    if (shown->coarse)
        renderer_settings_roughen(&desc.settings);
    if (desc.technique != shown->renderer.desc.technique)
        pace_forget(&shown->pace);
    return renderer_follow(&shown->renderer, &desc);
}

/* Whether a renderer is about to make its technique, and casters with it. */
static bool makes_technique(const struct viewer *viewer) {
    const struct shown *shown = &viewer->shown;
    const struct compare *compare = &shown->compare;
    return renderer_makes_technique(&shown->renderer, viewer->wish.technique,
                                    &viewer->wish.settings) ||
           (compare->mode == COMPARE_TECHNIQUE &&
            (!compare->has_other ||
             renderer_makes_technique(&compare->other, compare->technique, &compare->settings)));
}

bool viewer_pose_start(struct viewer *viewer) {
    struct document *document = &viewer->document;
    return viewer->placed.posed_time != 0 &&
           geometry_pose(&document->geometry, &document->scene, 0);
}

void viewer_pose_back(struct viewer *viewer, bool away) {
    struct document *document = &viewer->document;
    if (away)
        geometry_pose(&document->geometry, &document->scene, viewer->placed.posed_time);
}

static void follow_wishes_from_start(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    bool away = makes_technique(viewer) && viewer_pose_start(viewer);
    if (!follow_wishes(viewer)) {
        take_wishes_back(viewer);
        follow_wishes(viewer); /* the camera */
    }
    if (!compare_follow(&shown->compare, &shown->renderer, shown->coarse, shown->awaits))
        viewer_tell_error(viewer);
    viewer_pose_back(viewer, away);
}

static void scale_to(double scale, int *width, int *height) {
    *width = (int)fmax(lround(*width * scale), 16);
    *height = (int)fmax(lround(*height * scale), 16);
}

/* Lower while things move and the machine is slow. */
static void choose_size(struct viewer *viewer, int *width, int *height) {
    struct shown *shown = &viewer->shown;
    const struct pace *pace = &shown->pace;
    viewer_full_size(viewer, width, height);
    shown->coarse = false;
    if (viewer_is_scripted(viewer))
        return;
    if (pace->frame_count == 0 && gl.software) { /* the first picture is to come soon */
        shown->coarse = true;
        scale_to(fmin(sqrt(first_pixels / ((double)*width * *height)), 1), width, height);
    }
    /* A budget first takes what settings can give. */
    bool has_budget = viewer->wish.budget > 0;
    if (pace->frame_count == 0 || !shown->moving || (has_budget && shown->budget.level > 0))
        return;
    double scale = pace_scale(pace, (double)*width * *height,
                              has_budget ? (double)viewer->wish.budget : moving_ms);
    shown->coarse = scale < 1;
    scale_to(scale, width, height);
}

/* What is about to take so long that one would wonder; NULL = nothing. */
static const char *what_takes_long(const struct viewer *viewer, double pixels) {
    const struct shown *shown = &viewer->shown;
    const struct pace *pace = &shown->pace;
    const struct direct_method *direct =
        viewer->wish.direct ? viewer->wish.direct : direct_for(&viewer->placed.emitters);
    if (viewer_is_scripted(viewer) || viewer->wish.budget > 0)
        return NULL;
    bool makes = makes_technique(viewer) || direct != shown->renderer.desc.direct;
    if (pace->frame_count == 0)
        return "the first picture \xe2\x80\xa6";
    if (makes && !shown->awaits)
        return busy_compiling;
    if (shown->moving || viewer->wish.play.on)
        return NULL;
    return pace->fixed_ms + pace->ms_per_pixel * pixels > long_ms ? "rendering \xe2\x80\xa6" : NULL;
}

/* Lets a turn of the loop go by that shows a sign before what takes long; whether to wait for it */
static bool announce(struct viewer *viewer, double pixels) {
    struct shown *shown = &viewer->shown;
    const char *before = shown->busy;
    shown->busy = before ? NULL : what_takes_long(viewer, pixels);
    return shown->busy;
}

/* --- shaders --- */

/* Passes are to be there when the picture rests. */
static bool has_shaders(struct viewer *viewer, struct renderer_desc desc) {
    desc.progressive = viewer_passes(viewer) > 1;
    return compiling_has(&viewer->compiling, &desc);
}

static bool has_shaders_of_right(struct viewer *viewer) {
    const struct compare *compare = &viewer->shown.compare;
    struct renderer_desc desc = wished(viewer);
    if (compare->mode != COMPARE_TECHNIQUE)
        return true;
    desc.technique = compare->technique;
    desc.settings = compare->settings;
    return (compare->has_other && !renderer_makes_programs(&compare->other, &desc)) ||
           has_shaders(viewer, desc);
}

/* Whether what is wanted waits for shaders, which are compiled in the background. */
static bool awaits_shaders(struct viewer *viewer) {
    struct renderer_desc desc = wished(viewer);
    if (viewer_is_scripted(viewer))
        return false;
    bool left =
        !renderer_makes_programs(&viewer->shown.renderer, &desc) || has_shaders(viewer, desc);
    return !has_shaders_of_right(viewer) || !left;
}

/* Whether nothing else has changed: the picture stays as it is. */
static bool is_still(const struct viewer *viewer) {
    const struct renderer *renderer = &viewer->shown.renderer;
    return cameras_same(&renderer->desc.camera, &viewer->placed.orbit.camera) &&
           renderer->scene.pose == viewer->document.geometry.pose_count;
}

/* Error: the renderer must be freed. */
static bool render(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    struct renderer *renderer = &shown->renderer;
    int width, height;
    bool was_coarse = shown->coarse;
    choose_size(viewer, &width, &height);
    bool resized = width != renderer->desc.width || height != renderer->desc.height;
    shown->dirty |= shown->awaits && compiling_has_news(&viewer->compiling);
    if (!shown->dirty && !resized && shown->coarse == was_coarse)
        return true;
    shown->awaits = awaits_shaders(viewer);
    bool rests = shown->awaits && is_still(viewer) && shown->frame_count > 0;
    if (rests || announce(viewer, (double)width * height)) {
        shown->coarse = was_coarse;
        shown->dirty = !rests;
        return true;
    }
    if (resized) {
        struct renderer_desc desc = renderer->desc;
        desc.width = width;
        desc.height = height;
        if (!renderer_follow(renderer, &desc))
            viewer_tell_error(viewer);
        pace_begin_medians(&shown->pace);
    }
    follow_wishes_from_start(viewer);
    if (!renderer_update(renderer))
        return false;
    renderer_render(renderer);
    if (!compare_render(&shown->compare))
        viewer_tell_error(viewer);
    pace_add(&shown->pace, &renderer->timers, (double)width * height, window_time());
    shown->dirty = false;
    shown->recompose = true;
    shown->frame_count++;
    if (!shown->awaits)
        viewer_follow_budget(viewer);
    return true;
}

void viewer_retone(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    /* Both pictures are shown alike. */
    settings_copy(&shown->compare.settings, &viewer->wish.settings, &picture_part);
    if (!viewer->has_scene)
        return;
    if (!follow_wishes(viewer) ||
        !compare_follow(&shown->compare, &shown->renderer, shown->coarse, shown->awaits))
        viewer_tell_error(viewer);
    shown->compare.measured = false;
    shown->recompose = true;
}

/* --- at rest --- */

int viewer_passes(const struct viewer *viewer) {
    int asked = viewer->wish.passes, usual = gl.software ? 1 : PASSES_AT_REST;
    return asked > 0 ? asked : usual;
}

/* Outputs and comparisons are of a frame. */
bool viewer_is_accumulating(const struct viewer *viewer) {
    const struct shown *shown = &viewer->shown;
    int passes = viewer_passes(viewer);
    return viewer->has_scene && !viewer_is_scripted(viewer) && !shown->dirty && !shown->moving &&
           !shown->coarse && !viewer->wish.play.on && shown->compare.mode == COMPARE_OFF &&
           !shown->choice.output && passes > 1 && renderer_pass_count(&shown->renderer) < passes;
}

/* Casters of passes, too, are those of time 0. Error: the renderer must be freed. */
static bool make_progressive(struct viewer *viewer) {
    struct renderer *renderer = &viewer->shown.renderer;
    struct renderer_desc desc = renderer->desc;
    bool away = viewer_pose_start(viewer);
    desc.progressive = true;
    if (!renderer_follow(renderer, &desc)) {
        viewer_tell_error(viewer);
        viewer->wish.passes = 1;
    }
    viewer_pose_back(viewer, away);
    return renderer_update(renderer);
}

/* One more pass. Error: the renderer must be freed. */
static bool accumulate(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    struct renderer *renderer = &shown->renderer;
    if (!viewer_is_accumulating(viewer))
        return true;
    if (!renderer->desc.progressive && !make_progressive(viewer))
        return false;
    if (!renderer->desc.progressive)
        return true;
    renderer_add_pass(renderer, renderer_pass_count(renderer));
    shown->recompose = true;
    return true;
}

/* --- composing --- */

/* For a sheet: a legend stands below it. */
static int sheet_height(const struct viewer *viewer) {
    return viewer->shown.area.height - (int)legend_height(viewer);
}

static bool prepare_choice(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    struct inspect_choice *choice = &shown->choice;
    choice->width = shown->area.width;
    choice->height = sheet_height(viewer);
    choice->scale = viewer->host.input->scale;
    int layers = inspect_layers(&shown->renderer, choice->output);
    if (layers == 0) /* the technique before had it */
        choice->output = NULL;
    if (choice->layer >= layers)
        choice->layer = -1;
    return choice->output;
}

static void compose(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    struct renderer *renderer = &shown->renderer;
    const struct inspect_choice *choice = &shown->choice;
    bool resized = choice->width != shown->area.width || choice->height != sheet_height(viewer);
    if ((!shown->recompose && !resized) || shown->frame_count == 0)
        return;
    shown->recompose = false;
    renderer_compose(renderer, shown->layer);
    shown->left = &renderer->composite.display;
    shown->right = compare_compose(&shown->compare, renderer, shown->layer);
    if (!prepare_choice(viewer))
        return;
    shown->right = NULL;
    if (inspect_draw(&shown->inspect, renderer, choice)) {
        shown->left = &shown->inspect.canvas;
    } else {
        viewer_tell_error(viewer);
        shown->choice.output = NULL;
    }
}

/* Whether what was rendered is the picture at rest, and not the smaller one before it. */
static bool is_full(const struct viewer *viewer) {
    const struct renderer_desc *desc = &viewer->shown.renderer.desc;
    int width, height;
    viewer_full_size(viewer, &width, &height);
    return desc->width == width && desc->height == height;
}

/* Errors of a picture at rest. */
static void measure(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    struct compare *compare = &shown->compare;
    bool at_rest = !shown->moving && !shown->dirty && is_full(viewer);
    if (!shown->right || (!at_rest && !viewer_is_scripted(viewer)) ||
        (compare->measured && compare->heat_drawn))
        return;
    if (!compare_measure(compare, &shown->renderer, shown->layer))
        viewer_tell_error(viewer);
    shown->recompose = true; /* reading layers used the display's framebuffer state */
}

/* What was clicked on may have moved, and another light may shine on it: at rest, the place where
 * it was is read again. */
static void follow_pick(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    const struct renderer_desc *desc = &shown->renderer.desc;
    float place[2], before[3], aspect = (float)desc->width / (float)desc->height;
    if (shown->moving || shown->dirty || !shown->has_pick ||
        shown->pick_motion == shown->pace.last_motion)
        return;
    shown->has_pick = camera_project(&desc->camera, shown->pick.position, aspect, place) &&
                      place[0] >= 0 && place[0] < 1 && place[1] >= 0 && place[1] < 1;
    if (!shown->has_pick)
        return;
    memcpy(before, shown->pick.position, sizeof before);
    viewer_pick_surface(viewer, place[0], place[1]);
    /* The pixel's middle is not quite the place that was clicked on. */
    if (shown->has_pick &&
        glm_vec3_distance(before, shown->pick.position) < .02F * viewer->document.geometry.radius)
        memcpy(shown->pick.position, before, sizeof before);
}

bool viewer_update_picture(struct viewer *viewer) {
    if (!render(viewer) || !accumulate(viewer))
        return false;
    compose(viewer);
    measure(viewer);
    follow_pick(viewer);
    return true;
}

void viewer_show_layer(struct viewer *viewer, int layer) {
    viewer->shown.layer = layer;
    viewer->shown.choice.output = NULL;
    viewer->shown.compare.measured = false;
    viewer->shown.recompose = true;
}

void viewer_step_output(struct viewer *viewer, int step) {
    struct inspect_choice *choice = &viewer->shown.choice;
    struct output_list outputs;
    if (!viewer->has_scene)
        return;
    renderer_outputs(&viewer->shown.renderer, &outputs);
    const struct output *shown = output_find(&outputs, choice->output);
    int places = outputs.count + 1; /* 0: the picture */
    int at = shown ? (int)(shown - outputs.items) + 1 : 0;
    at = (at + places + step) % places;
    choice->output = at > 0 ? outputs.items[at - 1].name : NULL;
    choice->layer = -1;
    viewer->shown.recompose = true;
}

void viewer_pick_surface(struct viewer *viewer, float x, float y) {
    struct shown *shown = &viewer->shown;
    struct pick pick;
    if (!probe_pick(&shown->probe, &shown->renderer, x, y, &pick)) {
        viewer_tell_error(viewer);
        return;
    }
    shown->pick = pick;
    shown->has_pick = pick.present;
    shown->pick_motion = shown->pace.last_motion;
}

void viewer_reload_shaders(struct viewer *viewer) {
    struct inspect inspect;
    struct screen screen;
    if (!viewer->desc.glsl) {
        messages_add(&viewer->host.messages, UI_WARNING,
                     "The shaders are those in the program; start it with --glsl DIR.");
        return;
    }
    bool ok = inspect_init(&inspect);
    if (ok && !screen_init(&screen)) {
        inspect_free(&inspect);
        ok = false;
    }
    if (ok) {
        inspect_free(&viewer->shown.inspect);
        screen_free(&viewer->host.screen);
        viewer->shown.inspect = inspect;
        viewer->host.screen = screen;
    }
    if (ok && (!viewer->has_scene || renderer_reload_shaders(&viewer->shown.renderer)))
        messages_add(&viewer->host.messages, UI_NORMAL, "shaders read from %s", viewer->desc.glsl);
    else
        viewer_tell_error(viewer);
    probe_free(&viewer->shown.probe);
    compare_forget(&viewer->shown.compare);
    viewer->shown.left = viewer->shown.right = NULL;
    viewer->shown.dirty = true;
}

struct screen_pictures viewer_pictures(const struct viewer *viewer) {
    const struct shown *shown = &viewer->shown;
    const struct compare *compare = &shown->compare;
    bool heat = shown->right && compare->heat && compare->heat_map.id;
    return (struct screen_pictures){
        .left = heat ? &compare->heat_map : shown->left,
        .right = shown->right,
        .layout = compare->only_right ? SCREEN_WIPE : viewer->look.layout,
        .split = compare->only_right ? 0 : compare->split,
        .beside = shown->room.width,
    };
}
