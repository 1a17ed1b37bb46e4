#include "viewer/viewer.h"

#include "base/error.h"
#include "base/log.h"
#include "gl/glsl.h"
#include "shared/composite.h"
#include "viewer/ui.h"

/* How long after the last change the picture counts as at rest, seconds. */
static const double rest_after = .25;

enum { PANEL_WIDTH = 340 }; /* pixels of a monitor of scale 1 */

bool viewer_is_scripted(const struct viewer *viewer) {
    return viewer->desc.frames > 0 || viewer->desc.screenshot;
}

void viewer_touch(struct viewer *viewer) {
    viewer->dirty = true;
    viewer->pace.last_motion = window_time();
}

void viewer_tell_error(struct viewer *viewer) {
    messages_add(&viewer->messages, UI_ERROR, "%s", error_get());
}

void viewer_reload_shaders(struct viewer *viewer) {
    struct inspect inspect;
    struct screen screen;
    if (!viewer->desc.glsl) {
        messages_add(&viewer->messages, UI_WARNING,
                     "The shaders are those in the program; start it with --glsl DIR.");
        return;
    }
    bool ok = inspect_init(&inspect);
    if (ok && !screen_init(&screen)) {
        inspect_free(&inspect);
        ok = false;
    }
    if (ok) {
        inspect_free(&viewer->inspect);
        screen_free(&viewer->screen);
        viewer->inspect = inspect;
        viewer->screen = screen;
    }
    if (ok && (!viewer->has_scene || renderer_reload_shaders(&viewer->renderer)))
        messages_add(&viewer->messages, UI_NORMAL, "shaders read from %s", viewer->desc.glsl);
    else
        viewer_tell_error(viewer);
    probe_free(&viewer->probe);
    compare_forget(&viewer->compare);
    viewer->left = viewer->right = NULL;
    viewer->dirty = true;
}

/* --- the loop --- */

static void lay_out(struct viewer *viewer) {
    const struct input *input = viewer->input;
    int panel = viewer->show_panel ? (int)(PANEL_WIDTH * input->scale) : 0;
    if (panel > input->width * 2 / 3)
        panel = input->width * 2 / 3;
    viewer->area = (struct rectangle){0, 0, input->width - panel, input->height};
}

/* A picture that was rendered smaller is shown in the full size; sheets have their own shape. */
static void fit_picture(struct viewer *viewer) {
    const struct renderer_desc *desc = &viewer->renderer.desc;
    int width = viewer->left->desc.width, height = viewer->left->desc.height;
    if (width == desc->width && height == desc->height)
        viewer_full_size(viewer, &width, &height);
    viewer->picture = screen_fit(viewer->area, width, height);
}

static void tell_start(struct viewer *viewer) {
    if (!viewer->shown)
        log_detail("the window is there after %.2f s", window_time());
    if (!viewer->shown_picture && viewer->frame_count > 0)
        log_detail("the first picture is there after %.2f s", window_time());
    viewer->shown = true;
    viewer->shown_picture = viewer->frame_count > 0;
}

static void draw(struct viewer *viewer) {
    static const struct texture nothing = {0};
    const struct input *input = viewer->input;
    struct screen_pictures pictures = {.left = &nothing};
    if (viewer->left) {
        fit_picture(viewer);
        pictures = viewer_pictures(viewer);
    }
    screen_draw(&viewer->screen, input->height, &viewer->picture, &pictures);
    ui_frame_end();
    window_swap(viewer->window);
    tell_start(viewer);
}

static double waiting_time(const struct viewer *viewer) {
    if (viewer->input->width == 0)
        return .1; /* minimised */
    bool busy = viewer->dirty || viewer->recompose || viewer->moving || viewer->play.on ||
                viewer_is_scripted(viewer);
    return busy ? 0 : .05;
}

static void update(struct viewer *viewer) {
    double now = window_time(), seconds = now - viewer->last_update;
    viewer->last_update = now;
    controls_update(viewer, seconds < .25 ? seconds : .25);
    if (viewer->show_panel)
        panel_draw(viewer);
    if (!viewer->has_scene)
        return;
    viewer_animate(viewer, seconds);
    viewer->moving = window_time() - viewer->pace.last_motion < rest_after;
    viewer->dirty |= viewer_is_scripted(viewer);
    viewer_update_picture(viewer);
}

bool viewer_turn(struct viewer *viewer) {
    viewer->input = window_poll(viewer->window, waiting_time(viewer));
    viewer->done |= viewer->input->close;
    if (viewer->input->width == 0)
        return true; /* minimised */
    ui_frame_begin(viewer->input->taps, viewer->input->tap_count);
    lay_out(viewer);
    /* The window shows itself before the scene takes its time. */
    bool ok = !viewer->shown || viewer_poll_loader(viewer);
    if (!ok && !viewer_is_scripted(viewer)) {
        viewer_tell_error(viewer);
        ok = true;
    }
    update(viewer);
    overlay_draw(viewer);
    draw(viewer);
    return ok;
}

static bool finish_script(struct viewer *viewer) {
    int wanted = viewer->desc.frames > 0 ? viewer->desc.frames : 1;
    if (!viewer_is_scripted(viewer) || viewer->frame_count < wanted)
        return true;
    viewer->done = true;
    return !viewer->desc.screenshot || viewer_write_picture(viewer, viewer->desc.screenshot);
}

/* --- beginning and end --- */

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
    return viewer->context && ui_init(window_native(viewer->window), viewer->input->scale) &&
           screen_init(&viewer->screen) && inspect_init(&viewer->inspect);
}

static void close_window(struct viewer *viewer) {
    if (viewer->has_scene) {
        renderer_free(&viewer->renderer);
        document_free(&viewer->document);
    }
    if (viewer->context) {
        compare_free(&viewer->compare);
        screen_free(&viewer->screen);
        inspect_free(&viewer->inspect);
        probe_free(&viewer->probe);
        ui_free();
    }
    context_free(viewer->context);
    window_free(viewer->window);
}

static void begin(struct viewer *viewer) {
    const struct viewer_desc *desc = &viewer->desc;
    viewer->compare.settings = desc->settings;
    if (desc->scene)
        viewer_open(viewer, desc->scene);
    if (desc->reference)
        viewer_load_reference(viewer, desc->reference);
}

bool viewer_begin(struct viewer *viewer, const struct viewer_desc *desc) {
    *viewer = (struct viewer){
        .desc = *desc,
        .technique = desc->technique ? desc->technique : technique_default,
        .settings = desc->settings,
        .layer = desc->layer,
        .play = {.loops = true, .speed = 1},
        .choice = {.layer = -1, .chosen = -1},
        .compare = {.split = .5F, .technique = technique_baseline},
        .session_path = "manylight.settings",
        .show_panel = true,
        .show_overlay = true,
    };
    glsl_set_folder(desc->glsl);
    messages_init(&viewer->messages);
    if (!open_window(viewer)) {
        viewer_end(viewer);
        return false;
    }
    begin(viewer);
    return true;
}

void viewer_end(struct viewer *viewer) {
    loader_free(&viewer->loader);
    close_window(viewer);
    messages_free(&viewer->messages);
}

bool viewer_run(const struct viewer_desc *desc) {
    struct viewer viewer;
    if (!viewer_begin(&viewer, desc))
        return false;
    bool ok = true;
    while (ok && !viewer.done)
        ok = viewer_turn(&viewer) && finish_script(&viewer);
    viewer_end(&viewer);
    return ok;
}
