#include "viewer/viewer.h"

#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "gl/glsl.h"
#include "gl/screen.h"
#include "viewer/files/opening.h"
#include "viewer/files/screenshot.h"
#include "viewer/files/start.h"
#include "viewer/panel/panel.h"
#include "viewer/picture/budget.h"
#include "viewer/picture/look.h"
#include "viewer/picture/picture.h"
#include "viewer/reference/comparing.h"
#include "viewer/reference/tracing.h"
#include "viewer/scene/animation.h"
#include "viewer/scene/exposure.h"
#include "viewer/scene/sessions.h"
#include "viewer/scene/sky.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How long after the last change the picture counts as at rest, seconds. */
static const double rest_after = .25;

/* How long widgets are drawn anew after the last thing that happened, seconds. */
static const double awake_for = 1.5;

/* How often a caret is drawn, which blinks in 1.2 s, seconds. */
static const double caret_period = .4;

/* How often what is opened tells how far it is, seconds. */
static const double opening_period = .25;

enum { PANEL_WIDTH = 340 }; /* pixels of a monitor of scale 1 */

/* --- the loop --- */

static void lay_out(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    int panel = viewer->panel.is_open ? (int)(PANEL_WIDTH * input->scale) : 0;
    if (panel > input->width * 2 / 3)
        panel = input->width * 2 / 3;
    int height = input->height - (int)timeline_height(viewer);
    viewer->shown.area = (struct rectangle){0, 0, input->width - panel, height};
}

/* The timeline takes its room from the screen and gives it back: pictures keep their size from
 * scene to scene. */
static void make_room_for_timeline(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    int bar = (int)timeline_height(viewer), more = bar - viewer->host.timeline_room;
    if (!viewer->has_scene || !viewer->panel.is_open || more == 0 || viewer_is_scripted(viewer) ||
        window_is_full_screen(viewer->host.window))
        return;
    viewer->host.timeline_room = bar;
    window_set_size(viewer->host.window, input->width, input->height + more);
}

static void tell_start(struct viewer *viewer) {
    if (!viewer->host.window_shown)
        log_detail("the window is there after %.2f s", window_time());
    if (!viewer->host.coarse_shown && viewer->opening.preview.has_texture)
        log_detail("a coarse picture is there after %.2f s", window_time());
    if (!viewer->host.picture_shown && viewer->shown.frame_count > 0)
        log_detail("the first picture is there after %.2f s", window_time());
    viewer->host.window_shown = true;
    viewer->host.coarse_shown |= viewer->opening.preview.has_texture;
    viewer->host.picture_shown = viewer->shown.frame_count > 0;
}

/* Whether all that was asked for is shown; what goes on by itself has no end to wait for. */
static bool is_settled(struct viewer *viewer) {
    const struct shown *shown = &viewer->shown;
    if (viewer->wish.play.on || viewer_is_measuring(viewer))
        return true;
    bool pending = shown->dirty || shown->recompose || shown->moving || shown->coarse ||
                   shown->awaits || viewer_is_accumulating(viewer);
    return !viewer_is_opening(viewer) && !(viewer->has_scene && pending);
}

/* For scripts that press widgets: where each of them is, whenever one has moved. F9 asks whether
 * all that happened before it is shown; the last line counts those that were answered. */
static void write_places(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    struct panel *panel = &viewer->panel;
    if (!viewer->desc.places)
        return;
    for (int i = 0; i < input->key_count; i++)
        panel->places_asked += input->keys[i] == KEY_F9;
    if (is_settled(viewer)) {
        panel->places_answered += panel->places_asked;
        panel->places_asked = 0;
    }
    char *places = mem_printf("%s0 0 0 0 answered %d\n", ui_places(), panel->places_answered);
    bool known = panel->places && strcmp(panel->places, places) == 0;
    if (!known && !output_file_write(viewer->desc.places, places, strlen(places)))
        viewer_tell_error(viewer);
    free(panel->places);
    panel->places = places;
}

/* The coarse picture of a scene that arrives stands in for its first one. */
static const struct texture *coarse_picture(struct viewer *viewer) {
    if (viewer->opening.is_arriving || !viewer->shown.left)
        return preview_picture(&viewer->opening.preview);
    preview_free(&viewer->opening.preview);
    return NULL;
}

static void draw(struct viewer *viewer) {
    static const struct texture nothing = {0};
    const struct input *input = viewer->host.input;
    struct screen_pictures pictures = {.left = &nothing};
    struct rectangle place = viewer->shown.picture;
    const struct texture *coarse = coarse_picture(viewer);
    if (coarse) {
        pictures.left = coarse;
        place = screen_fit(viewer->shown.area, coarse->desc.width, coarse->desc.height);
    } else if (viewer->shown.left)
        pictures = viewer_pictures(viewer);
    screen_draw(&viewer->host.screen, input->height, &place, &pictures);
    ui_frame_end();
    window_swap(viewer->host.window);
    viewer->host.last_drawn = window_time();
    write_places(viewer);
    tell_start(viewer);
}

static bool is_busy(const struct viewer *viewer) {
    return viewer->shown.dirty || viewer->shown.recompose || viewer->shown.moving ||
           viewer->shown.coarse || viewer->wish.play.on || viewer_is_scripted(viewer) ||
           viewer_is_accumulating(viewer) || viewer_is_measuring(viewer) || ui_is_opening_field();
}

/* Seconds are shown while a scene is opened. */
static bool is_due(struct viewer *viewer) {
    return viewer_is_opening(viewer) && window_time() - viewer->host.last_drawn >= opening_period;
}

/* What changes without the user: the loader, what threads have made, and messages, which come from
 * other threads and go with time. */
static bool has_news(struct viewer *viewer) {
    struct host *host = &viewer->host;
    struct message recent[MESSAGES_SHOWN];
    int count = messages_recent(&host->messages, recent);
    double newest = count > 0 ? recent[count - 1].time : 0;
    int loader = atomic_load(&viewer->opening.loader.state);
    bool news = loader == LOADER_DONE || loader == LOADER_FAILED || count != host->message_count ||
                preview_has_news(&viewer->opening.preview) ||
                (viewer->opening.is_arriving && viewer->opening.is_announced) ||
                newest != host->newest_message || compiling_has_news(&viewer->compiling) ||
                reference_tracer_has_news(&viewer->tracing.tracer) || viewer->dialog.answer;
    host->message_count = count;
    host->newest_message = newest;
    return news;
}

/* Whether there is something to draw. Widgets go on for a while after what the user did: tooltips
 * come late. */
static bool is_awake(struct viewer *viewer) {
    struct host *host = &viewer->host;
    const struct input *input = host->input;
    double now = window_time();
    bool resized = input->width != host->width || input->height != host->height;
    host->width = input->width;
    host->height = input->height;
    if (input->any || input->close || resized || is_busy(viewer) || has_news(viewer))
        host->awake_until = now + awake_for;
    return now < host->awake_until || (ui_wants_keys() && now - host->last_drawn >= caret_period) ||
           is_due(viewer);
}

static double waiting_time(const struct viewer *viewer) {
    const struct host *host = &viewer->host;
    if (host->input->width == 0)
        return .5; /* minimised */
    if (is_busy(viewer))
        return 0;
    double now = window_time(), caret = host->last_drawn + caret_period - now;
    if (now < host->awake_until)
        return .05;
    return ui_wants_keys() && caret < .25 ? fmax(caret, .01) : .25;
}

static void update(struct viewer *viewer) {
    double now = window_time(), seconds = now - viewer->hand.last_update;
    viewer->hand.last_update = now;
    viewer_note_step(viewer);
    controls_update(viewer, seconds < .25 ? seconds : .25);
    if (viewer->panel.is_open)
        panel_draw(viewer);
    if (!viewer->has_scene)
        return;
    viewer_follow_sky(viewer);
    viewer_animate(viewer, seconds);
    viewer->shown.moving = window_time() - viewer->shown.pace.last_motion < rest_after;
    viewer->shown.dirty |= viewer_is_scripted(viewer);
    if (!viewer_update_picture(viewer)) {
        viewer_close_scene(viewer);
        return;
    }
    viewer_note_reference_view(viewer);
    viewer_follow_exposure(viewer);
    viewer_follow_reference(viewer);
}

bool viewer_turn(struct viewer *viewer) {
    viewer->host.input =
        window_poll(viewer->host.window, waiting_time(viewer), ui_is_opening_field());
    viewer->done |= viewer->host.input->close;
    viewer_watch_file(viewer);
    if (viewer->host.input->width == 0 || !is_awake(viewer)) {
        viewer->hand.last_update = window_time();
        return true;
    }
    ui_frame_begin(viewer->host.input);
    lay_out(viewer);
    /* The window shows itself before the scene takes its time. */
    bool ok = !viewer->host.window_shown || viewer_poll_loader(viewer);
    make_room_for_timeline(viewer);
    if (!ok && !viewer_is_scripted(viewer)) {
        viewer_tell_error(viewer);
        ok = true;
    }
    update(viewer);
    if (viewer->shown.left)
        look_place(viewer);
    overlay_draw(viewer);
    inspector_draw(viewer);
    timeline_draw(viewer);
    draw(viewer);
    return ok;
}

static bool finish_script(struct viewer *viewer) {
    int wanted = viewer->desc.frames > 0 ? viewer->desc.frames : 1;
    if (!viewer_is_scripted(viewer) || viewer->shown.frame_count < wanted)
        return true;
    viewer->done = true;
    return !viewer->desc.screenshot || viewer_write_picture(viewer, viewer->desc.screenshot);
}

/* --- beginning and end --- */

static bool open_window(struct viewer *viewer) {
    const struct viewer_desc *desc = &viewer->desc;
    viewer->host.window =
        window_create(&(struct window_desc){.title = "manylight",
                                            .margin = desc->no_panel ? 0 : PANEL_WIDTH,
                                            .width = desc->width,
                                            .height = desc->height,
                                            .scale = desc->scale,
                                            .debug = desc->debug});
    if (!viewer->host.window)
        return false;
    if (desc->full_screen)
        window_toggle_full_screen(viewer->host.window);
    screen_set_way((enum screen_way)desc->screen);
    viewer->host.context = context_adopt(window_getproc, desc->debug);
    viewer->host.input = window_poll(viewer->host.window, 0, false);
    compiling_init(&viewer->compiling, viewer->host.context, window_wake);
    return viewer->host.context &&
           ui_init(window_native(viewer->host.window), viewer->host.input->scale) &&
           screen_init(&viewer->host.screen) && inspect_init(&viewer->shown.inspect);
}

static void close_window(struct viewer *viewer) {
    viewer_forget_reference(viewer);
    start_free(viewer);
    preview_free(&viewer->opening.preview);
    compiling_free(&viewer->compiling);
    document_free(&viewer->opening.leaving);
    environment_free(viewer->opening.arriving_sky);
    environment_free(viewer->opening.leaving_sky);
    document_free(&viewer->opening.arriving);
    if (viewer->has_scene) {
        renderer_free(&viewer->shown.renderer);
        document_free(&viewer->document);
    }
    if (viewer->host.context) {
        compare_free(&viewer->shown.compare);
        screen_free(&viewer->host.screen);
        inspect_free(&viewer->shown.inspect);
        probe_free(&viewer->shown.probe);
        ui_free();
    }
    context_free(viewer->host.context);
    window_free(viewer->host.window);
}

/* Error: of what a script needs; else it is shown. */
static bool begin(struct viewer *viewer) {
    const struct viewer_desc *desc = &viewer->desc;
    viewer->shown.compare.settings = desc->settings;
    viewer_set_budget(viewer, desc->budget);
    if (desc->places)
        ui_note_places();
    if (desc->scene)
        viewer_open(viewer, desc->scene);
    return !desc->reference || viewer_load_reference(viewer, desc->reference) ||
           !viewer_is_scripted(viewer);
}

bool viewer_begin(struct viewer *viewer, const struct viewer_desc *desc) {
    *viewer = (struct viewer){
        .desc = *desc,
        .wish = {.technique = desc->technique ? desc->technique : technique_default,
                 .direct = desc->direct,
                 .settings = desc->settings,
                 .passes = desc->passes,
                 .play = {.loops = true, .speed = 1}},
        .hand = {.last_escape = -INFINITY}, /* the first Esc of all quits nothing */
        .shown = {.layer = desc->layer,
                  .choice = {.layer = -1, .chosen = -1},
                  .compare = {.split = .5F, .technique = technique_baseline}},
        .panel = {.is_open = !desc->no_panel, .session_path = SESSION_PATH},
    };
    glsl_set_folder(desc->glsl);
    messages_init(&viewer->host.messages);
    if (open_window(viewer) && begin(viewer))
        return true;
    viewer_end(viewer);
    return false;
}

/* The window goes first: threads and the driver may take seconds to end. */
void viewer_end(struct viewer *viewer) {
    window_hide(viewer->host.window);
    loader_free(&viewer->opening.loader);
    close_window(viewer);
    emitters_free(&viewer->placed.emitters);
    mem_free(viewer->panel.places, viewer->shown.reference_view);
    file_dialog_close(&viewer->dialog);
    history_forget(&viewer->history);
    messages_free(&viewer->host.messages);
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
