#include "viewer/viewer.h"

#include "base/error.h"
#include "base/image_file.h"
#include "base/log.h"
#include "gl/glsl.h"
#include "scene/placing.h"
#include "shared/params.h"
#include "viewer/ui.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* How long after the last change the picture counts as at rest, seconds. */
static const double rest_after = .25;

/* A moving picture on software OpenGL: what a frame may take. */
static const double moving_ms = 60;

enum { PANEL_WIDTH = 340 }; /* pixels of a monitor of scale 1 */

static bool is_scripted(const struct viewer *viewer) {
    return viewer->desc.frames > 0 || viewer->desc.screenshot;
}

static void tell_error(struct viewer *viewer) {
    messages_add(&viewer->messages, UI_ERROR, "%s", error_get());
}

void viewer_touch(struct viewer *viewer) {
    viewer->dirty = true;
    viewer->pace.last_motion = window_time();
}

/* --- scenes --- */

void viewer_pick_camera(struct viewer *viewer, int n) {
    const struct geometry *geometry = &viewer->document.geometry;
    struct camera camera;
    camera_place(&camera, &viewer->document.scene, n, 0);
    viewer->camera = n;
    orbit_start(&viewer->orbit, &camera, geometry->center, geometry->radius);
    viewer_touch(viewer);
}

void viewer_pick_light(struct viewer *viewer, int n) {
    light_place(&viewer->placed_light, &viewer->document.scene, n, 0);
    viewer->light = n;
    viewer_touch(viewer);
}

/* Those that the command line asks for, or the first. */
static void place_first(struct viewer *viewer) {
    const struct scene *scene = &viewer->document.scene;
    struct camera camera;
    struct light light;
    viewer_pick_camera(viewer, 0);
    viewer_pick_light(viewer, 0);
    if (camera_from_text(&camera, scene, viewer->desc.camera, 0, &viewer->camera))
        orbit_start(&viewer->orbit, &camera, viewer->document.geometry.center,
                    viewer->document.geometry.radius);
    else
        tell_error(viewer);
    if (light_from_text(&light, scene, viewer->desc.light, 0, &viewer->light))
        viewer->placed_light = light;
    else
        tell_error(viewer);
}

void viewer_open(struct viewer *viewer, const char *path) {
    loader_start(&viewer->loader, path);
}

/* The size of the picture at rest. */
static void full_size(const struct viewer *viewer, int *width, int *height) {
    *width = is_scripted(viewer) ? viewer->desc.width : viewer->area.width;
    *height = is_scripted(viewer) ? viewer->desc.height : viewer->area.height;
    *width = *width < 16 ? 16 : *width;
    *height = *height < 16 ? 16 : *height;
}

static struct renderer_desc describe(const struct viewer *viewer, const struct document *document) {
    struct renderer_desc desc = {
        .technique = viewer->technique,
        .settings = viewer->settings,
        .scene = &document->scene,
        .geometry = &document->geometry,
        .timed = true,
        .software = context_is_software(viewer->context),
    };
    full_size(viewer, &desc.width, &desc.height);
    return desc;
}

/* The new scene takes the place of the old one when it has a renderer; the old one is kept
 * otherwise. */
static bool show_document(struct viewer *viewer, struct document *document) {
    struct viewer before = *viewer;
    struct renderer renderer;
    viewer->document = *document;
    place_first(viewer);
    struct renderer_desc desc = describe(viewer, &viewer->document);
    desc.camera = viewer->orbit.camera;
    desc.light = viewer->placed_light;
    if (!renderer_init(&renderer, &desc)) {
        viewer->document = before.document;
        viewer->camera = before.camera;
        viewer->light = before.light;
        viewer->orbit = before.orbit;
        viewer->placed_light = before.placed_light;
        document_free(document);
        return error_prefix("%s", document->scene.path);
    }
    if (before.has_scene) {
        renderer_free(&viewer->renderer);
        document_free(&before.document);
    }
    viewer->renderer = renderer;
    viewer->has_scene = true;
    viewer->desc.camera = viewer->desc.light = NULL; /* they meant the first scene */
    pace_forget(&viewer->pace);
    const char *name = strrchr(document->scene.path, '/');
    char title[256];
    snprintf(title, sizeof title, "%s - manylight", name ? name + 1 : document->scene.path);
    window_set_title(viewer->window, title);
    return true;
}

/* False: what was to be loaded cannot be shown. */
static bool poll_loader(struct viewer *viewer) {
    struct document document;
    switch (loader_poll(&viewer->loader, &document)) {
    case LOADER_DONE:
        return show_document(viewer, &document);
    case LOADER_FAILED:
        return false;
    case LOADER_IDLE:
    case LOADER_BUSY:
        break;
    }
    return true;
}

/* --- rendering --- */

/* What is wanted of the renderer, where it differs from what it has. A setting that it refuses goes
 * back to what it was. */
static void follow_wishes(struct viewer *viewer) {
    struct renderer *renderer = &viewer->renderer;
    int technique = renderer->desc.technique;
    if (!renderer_configure(renderer, viewer->technique, &viewer->settings)) {
        tell_error(viewer);
        viewer->technique = technique;
        viewer->settings = renderer->desc.settings;
    }
    if (technique != viewer->technique)
        pace_forget(&viewer->pace);
    if (!renderer_set_light(renderer, &viewer->placed_light)) {
        tell_error(viewer);
        viewer->placed_light = renderer->desc.light;
    }
    renderer_set_camera(renderer, &viewer->orbit.camera);
}

/* Lower while things move and the machine is slow. */
static void choose_size(struct viewer *viewer, int *width, int *height) {
    full_size(viewer, width, height);
    bool slow = context_is_software(viewer->context) || viewer->pace.fixed_ms > moving_ms / 2;
    if (is_scripted(viewer) || !viewer->moving || !slow || viewer->pace.frame_count == 0)
        return;
    double scale = pace_scale(&viewer->pace, (double)*width * *height, moving_ms);
    *width = (int)lround(*width * scale);
    *height = (int)lround(*height * scale);
}

static void render(struct viewer *viewer) {
    struct renderer *renderer = &viewer->renderer;
    int width, height;
    choose_size(viewer, &width, &height);
    bool resized = width != renderer->desc.width || height != renderer->desc.height;
    if (!viewer->dirty && !resized)
        return;
    follow_wishes(viewer);
    if (resized) {
        if (!renderer_resize(renderer, width, height))
            tell_error(viewer);
        pace_forget(&viewer->pace);
    }
    renderer_render(renderer);
    pace_add(&viewer->pace, &renderer->timers, (double)width * height, window_time());
    viewer->dirty = false;
    viewer->recompose = true;
    viewer->frame_count++;
}

/* Makes what is shown of the frame. */
static void compose(struct viewer *viewer) {
    struct renderer *renderer = &viewer->renderer;
    struct inspect_choice *choice = &viewer->choice;
    bool resized = choice->width != viewer->area.width || choice->height != viewer->area.height;
    if (!viewer->recompose && !resized)
        return;
    viewer->recompose = false;
    choice->width = viewer->area.width;
    choice->height = viewer->area.height;
    choice->scale = viewer->input->scale;
    int layers = inspect_layers(renderer, choice->kind);
    if (layers == 0) /* the technique before had it */
        choice->kind = SHOW_PICTURE;
    if (choice->layer >= layers)
        choice->layer = -1;
    renderer_compose(renderer, viewer->layer);
    if (choice->kind != SHOW_PICTURE && !inspect_draw(&viewer->inspect, renderer, choice)) {
        tell_error(viewer);
        choice->kind = SHOW_PICTURE;
    }
}

void viewer_step_buffer(struct viewer *viewer, int step) {
    struct inspect_choice *choice = &viewer->choice;
    do
        choice->kind = (enum inspect_kind)((choice->kind + SHOW_COUNT + step) % SHOW_COUNT);
    while (inspect_layers(&viewer->renderer, choice->kind) == 0);
    choice->layer = -1;
    viewer->recompose = true;
}

/* --- screenshots --- */

static bool write_screenshot(struct viewer *viewer, const char *path) {
    bool is_float, ok;
    if (!image_format_is_float(path, &is_float))
        return false;
    if (is_float) {
        struct image image;
        ok = renderer_read_layers(&viewer->renderer, &image) && image_write(&image, path);
        image_free(&image);
    } else {
        struct bitmap bitmap;
        renderer_read_display(&viewer->renderer, &bitmap);
        ok = bitmap_write(&bitmap, path);
        bitmap_free(&bitmap);
    }
    return ok;
}

void viewer_take_screenshot(struct viewer *viewer) {
    if (!viewer->has_scene)
        return;
    char png[64], exr[64];
    for (int i = 1; i < 10000; i++) {
        snprintf(png, sizeof png, "manylight-%04d.png", i);
        snprintf(exr, sizeof exr, "manylight-%04d.exr", i);
        if (access(png, F_OK) != 0 && access(exr, F_OK) != 0)
            break;
    }
    if (write_screenshot(viewer, png) && write_screenshot(viewer, exr))
        messages_add(&viewer->messages, UI_NORMAL, "written: %s, and %s with all layers", png, exr);
    else
        tell_error(viewer);
}

/* --- the loop --- */

static void lay_out(struct viewer *viewer) {
    const struct input *input = viewer->input;
    int panel = viewer->show_panel ? (int)(PANEL_WIDTH * input->scale) : 0;
    viewer->area = (struct rectangle){0, 0, input->width - panel, input->height};
}

static void draw(struct viewer *viewer) {
    const struct renderer *renderer = &viewer->renderer;
    static const struct texture nothing = {0};
    const struct input *input = viewer->input;
    struct screen_pictures pictures = {.left = &nothing};
    if (viewer->has_scene) {
        int width, height;
        full_size(viewer, &width, &height);
        pictures.left = &renderer->composite.display;
        if (viewer->choice.kind != SHOW_PICTURE) {
            const struct texture *canvas = pictures.left = &viewer->inspect.canvas;
            if (canvas->desc.width != renderer->desc.width ||
                canvas->desc.height != renderer->desc.height) {
                width = canvas->desc.width;
                height = canvas->desc.height;
            }
        }
        viewer->picture = screen_fit(viewer->area, width, height);
    }
    screen_draw(&viewer->screen, input->width, input->height, &viewer->picture, &pictures);
    ui_frame_end();
    window_swap(viewer->window);
}

static double waiting_time(const struct viewer *viewer) {
    bool busy = viewer->dirty || viewer->moving || is_scripted(viewer) ||
                !context_is_software(viewer->context);
    return busy ? 0 : .05;
}

/* One turn. False ends all with an error. */
static bool turn(struct viewer *viewer) {
    viewer->input = window_poll(viewer->window, waiting_time(viewer));
    viewer->done |= viewer->input->close;
    if (viewer->input->width == 0)
        return true; /* minimised */
    ui_frame_begin();
    lay_out(viewer);
    bool ok = poll_loader(viewer);
    if (!ok && !is_scripted(viewer)) {
        tell_error(viewer);
        ok = true;
    }
    controls_update(viewer);
    if (viewer->show_panel)
        panel_draw(viewer);
    viewer->moving = window_time() - viewer->pace.last_motion < rest_after;
    if (viewer->has_scene) {
        if (!context_is_software(viewer->context) || is_scripted(viewer))
            viewer->dirty = true;
        render(viewer);
        compose(viewer);
    }
    overlay_draw(viewer);
    draw(viewer);
    return ok;
}

static bool finish_script(struct viewer *viewer) {
    int wanted = viewer->desc.frames > 0 ? viewer->desc.frames : 1;
    if (!is_scripted(viewer) || viewer->frame_count < wanted)
        return true;
    viewer->done = true;
    return !viewer->desc.screenshot || write_screenshot(viewer, viewer->desc.screenshot);
}

static bool open_window(struct viewer *viewer) {
    const struct viewer_desc *desc = &viewer->desc;
    viewer->window = window_create(&(struct window_desc){.title = "manylight",
                                                         .margin = PANEL_WIDTH,
                                                         .width = desc->width,
                                                         .height = desc->height,
                                                         .debug = desc->debug});
    if (!viewer->window)
        return false;
    viewer->context = context_adopt(window_getproc, desc->debug);
    viewer->input = window_poll(viewer->window, 0);
    if (!viewer->context || !ui_init(window_native(viewer->window), viewer->input->scale))
        return false;
    return screen_init(&viewer->screen) && inspect_init(&viewer->inspect);
}

static void close_window(struct viewer *viewer) {
    if (viewer->has_scene) {
        renderer_free(&viewer->renderer);
        document_free(&viewer->document);
    }
    if (viewer->context) {
        screen_free(&viewer->screen);
        inspect_free(&viewer->inspect);
        ui_free();
    }
    context_free(viewer->context);
    window_free(viewer->window);
}

bool viewer_run(const struct viewer_desc *desc) {
    struct viewer viewer = {
        .desc = *desc,
        .technique = desc->technique,
        .settings = desc->settings,
        .layer = LAYER_BEAUTY,
        .choice = {.layer = -1, .chosen = -1},
        .show_panel = true,
        .show_overlay = true,
    };
    glsl_set_folder(desc->glsl);
    messages_init(&viewer.messages);
    if (desc->scene)
        viewer_open(&viewer, desc->scene);
    bool ok = open_window(&viewer);
    while (ok && !viewer.done)
        ok = turn(&viewer) && finish_script(&viewer);
    loader_free(&viewer.loader);
    close_window(&viewer);
    messages_free(&viewer.messages);
    return ok;
}
