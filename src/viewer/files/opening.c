#include "viewer/files/opening.h"

#include "base/error.h"
#include "base/file/folder.h"
#include "base/file/image_file.h"
#include "base/log.h"
#include "scene/clips.h"
#include "viewer/picture/picture.h"
#include "viewer/reference/comparing.h"
#include "viewer/reference/tracing.h"
#include "viewer/scene/animation.h"
#include "viewer/scene/exposure.h"
#include "viewer/scene/placed.h"
#include "viewer/scene/sessions.h"
#include "viewer/scene/sky.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static void open_file(struct viewer *viewer, const char *path, const struct scene_open_desc *desc) {
    viewer->opening.reloading.asked = file_stamp_of(path);
    loader_start(&viewer->opening.loader, path, desc);
    viewer->opening.since = window_time();
}

void viewer_open(struct viewer *viewer, const char *path) {
    char *whole = path_of_user(path);
    messages_forget_errors(&viewer->host.messages);
    const struct scene_open_desc desc = {.choice = viewer->desc.choice,
                                         .light = viewer->desc.light,
                                         .environment = viewer->desc.environment,
                                         .punctual_scale = viewer->desc.punctual_scale};
    viewer->opening.reloading.on = false;
    open_file(viewer, whole, &desc);
    free(whole);
}

void viewer_reload(struct viewer *viewer) {
    struct reloading *reloading = &viewer->opening.reloading;
    if (!viewer->has_scene || viewer_is_opening(viewer))
        return;
    messages_forget_errors(&viewer->host.messages);
    reloading->on = true;
    open_file(viewer, viewer->document.scene.path, &reloading->desc);
    reloading->shown = reloading->asked; /* tried once, if it cannot be read */
}

void viewer_watch_file(struct viewer *viewer) {
    const double period = .5;
    struct reloading *reloading = &viewer->opening.reloading;
    if (!viewer->has_scene || viewer_is_scripted(viewer) || viewer_is_opening(viewer) ||
        window_time() - reloading->looked < period)
        return;
    reloading->looked = window_time();
    struct file_stamp before = reloading->seen;
    reloading->seen = file_stamp_of(viewer->document.scene.path);
    if (reloading->seen.is_file && file_stamps_same(&reloading->seen, &before) &&
        !file_stamps_same(&reloading->seen, &reloading->shown)) {
        log_detail("%s has changed", viewer->document.scene.path);
        viewer_reload(viewer);
    }
}

static void set_title(struct viewer *viewer) {
    char title[256];
    snprintf(title, sizeof title, "%s - manylight", path_name(viewer->document.scene.path));
    window_set_title(viewer->host.window, title);
}

void viewer_close_scene(struct viewer *viewer) {
    viewer_tell_error(viewer);
    viewer_forget_reference(viewer);
    compare_forget(&viewer->shown.compare);
    compiling_wait(&viewer->compiling);
    renderer_free(&viewer->shown.renderer);
    viewer_forget_sky(viewer);
    document_free(&viewer->document);
    emitters_free(&viewer->placed.emitters);
    viewer->has_scene = viewer->shown.has_pick = viewer->shown.awaits = false;
    viewer->shown.left = viewer->shown.right = NULL;
}

/* --- the scene takes its place --- */

/* What the command line says of the first scene. */
static bool place_as_given(struct viewer *viewer) {
    struct viewer_desc *desc = &viewer->desc;
    struct document *document = &viewer->document;
    bool has_clip = !desc->clip || (clips_select(&document->scene, desc->clip) &&
                                    geometry_pose(&document->geometry, &document->scene, 0));
    viewer_go_to(viewer, (double)desc->time);
    bool has_camera = viewer_place_camera(viewer, desc->camera);
    bool has_lights = viewer_place_lights(viewer, desc->light);
    return has_camera && has_lights && has_clip;
}

static void forget_given(struct viewer *viewer) {
    struct viewer_desc *desc = &viewer->desc;
    desc->camera = desc->light = desc->clip = desc->session = NULL;
    desc->choice = (struct scene_choice){0};
    desc->environment = (struct environment_desc){0};
    desc->punctual_scale = 0;
    desc->time = 0;
}

static bool is_changed(const struct settings *settings, const struct settings *usual) {
    for (struct setting setting = {0}; settings_next(settings, &setting);)
        if (setting.part != &picture_part && !setting_equal(&setting, settings, usual))
            return true;
    return false;
}

/* Technique and settings stay, and so does a comparison with a technique; a reference was of the
 * scene before. */
static void tell_what_stays(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    bool again = viewer->opening.reloading.on;
    const struct technique *first =
        viewer->desc.technique ? viewer->desc.technique : technique_default;
    bool changed = viewer->wish.technique != first || viewer->wish.direct != viewer->desc.direct ||
                   viewer->wish.passes != viewer->desc.passes ||
                   is_changed(&viewer->wish.settings, &viewer->desc.settings);
    if (compare->mode == COMPARE_REFERENCE) {
        compare->mode = COMPARE_OFF;
        viewer->shown.fixed_width = viewer->shown.fixed_height = 0;
        messages_add(&viewer->host.messages, UI_NORMAL,
                     "The comparison has ended: its reference was of the scene before.");
    }
    if (again)
        messages_add(&viewer->host.messages, UI_NORMAL, "%s is read again.",
                     path_name(viewer->document.scene.path));
    else if (changed)
        messages_add(&viewer->host.messages, UI_NORMAL,
                     "Technique and settings are those of the scene before.");
    if (compare->mode == COMPARE_TECHNIQUE)
        messages_add(&viewer->host.messages, UI_NORMAL, "The comparison goes on; C ends it.");
}

static void take_away_before(struct viewer *viewer, struct document *before,
                             struct emitters *lights) {
    compiling_wait(&viewer->compiling);
    renderer_free(&viewer->shown.renderer);
    document_free(before);
    emitters_free(lights);
}

static void begin_scene(struct viewer *viewer, const struct renderer *renderer) {
    const char *path = viewer->document.scene.path;
    viewer->wish.play.on = false;
    viewer->shown.renderer = *renderer;
    viewer->has_scene = true;
    viewer->shown.has_pick = false;
    viewer->shown.left = viewer->shown.right = NULL;
    history_forget(&viewer->history);
    viewer_begin_exposure(viewer);
    pace_forget(&viewer->shown.pace);
    viewer->opening.reloading.shown = viewer->opening.reloading.asked;
    set_title(viewer);
    snprintf(viewer->panel.scene_path, sizeof viewer->panel.scene_path, "%s", path);
    /* A file of settings is of the scene before: Save must not overwrite it. */
    snprintf(viewer->panel.session_path, sizeof viewer->panel.session_path, SESSION_PATH);
    viewer_tell_sky(viewer);
}

/* Restores the view after the same file was read again. */
static void show_as_before(struct viewer *viewer, struct session *before) {
    before->scene = viewer->document.scene.path;
    if (viewer->opening.reloading.on && !viewer_show_session(viewer, before))
        viewer_tell_error(viewer);
    viewer->opening.reloading.on = false;
    session_free(before);
}

/* The new scene takes the place of the old one when it has a renderer; the old one is kept
 * otherwise. */
static bool show_document(struct viewer *viewer, struct document *document) {
    struct document before = viewer->document;
    struct placed placed_before = viewer->placed;
    struct renderer renderer;
    struct session session_before = {0};
    if (viewer->opening.reloading.on)
        session_before = viewer_session(viewer);
    viewer->document = *document;
    viewer->placed = (struct placed){0};
    viewer_pick_camera(viewer, 0);
    viewer_place_lights(viewer, NULL);
    bool placed = place_as_given(viewer);
    if (!placed && !viewer_is_scripted(viewer))
        viewer_tell_error(viewer);
    if ((!placed && viewer_is_scripted(viewer)) || !viewer_init_renderer(viewer, &renderer)) {
        emitters_free(&viewer->placed.emitters);
        viewer->document = before;
        viewer->placed = placed_before;
        error_prefix("%s", document->scene.path);
        document_free(document);
        session_free(&session_before);
        return false;
    }
    compare_forget(&viewer->shown.compare);
    viewer_forget_reference(viewer);
    viewer_forget_sky(viewer);
    bool replaces = viewer->has_scene;
    if (replaces)
        take_away_before(viewer, &before, &placed_before.emitters);
    begin_scene(viewer, &renderer);
    const char *session = viewer->desc.session;
    if (replaces)
        tell_what_stays(viewer);
    show_as_before(viewer, &session_before);
    forget_given(viewer); /* it meant the first scene */
    return !session || viewer_load_session(viewer, session) || !viewer_is_scripted(viewer);
}

/* --- what arrives --- */

/* It goes when no shaders are being compiled for it. */
static void leave_arriving(struct viewer *viewer) {
    preview_free(&viewer->opening.preview);
    if (viewer->opening.leaving.scene.path)
        compiling_wait(&viewer->compiling);
    document_free(&viewer->opening.leaving);
    viewer->opening.leaving = viewer->opening.arriving;
    viewer->opening.arriving = (struct document){0};
    viewer->opening.is_arriving = false;
}

/* The command line's clips and time. A wrong clip is reported when the scene takes its place. */
static bool pose_as_given(struct viewer *viewer, double *time) {
    struct document *arriving = &viewer->opening.arriving;
    const struct viewer_desc *desc = &viewer->desc;
    if (desc->clip)
        clips_select(&arriving->scene, desc->clip);
    *time = viewer_time_in(viewer, &arriving->scene, (double)desc->time);
    return (*time == 0 && !desc->clip) ||
           geometry_pose(&arriving->geometry, &arriving->scene, *time);
}

/* Casters are those of time 0. */
static void pose_back(struct document *document, const struct viewer_desc *given) {
    if (given->time != 0 || given->clip)
        geometry_pose(&document->geometry, &document->scene, 0);
}

/* As the command line places camera and lights. */
static void start_preview(struct viewer *viewer) {
    const struct document *arriving = &viewer->opening.arriving;
    double time;
    const struct picture_settings *picture =
        settings_of(struct picture_settings, &viewer->wish.settings, &picture_part);
    struct preview_desc desc = {
        .scene = &arriving->scene,
        .geometry = &arriving->geometry,
        .exposure = picture->exposure,
        .auto_exposure = viewer->desc.auto_exposure,
        .wake = window_wake,
    };
    if (viewer_is_scripted(viewer) || !pose_as_given(viewer, &time) ||
        !emitters_from_text(&desc.emitters, &arriving->scene, viewer->desc.light, time))
        return;
    if (!camera_from_text(&desc.camera, &arriving->scene, viewer->desc.camera, time, NULL))
        camera_place(&desc.camera, &arriving->scene, 0, time);
    viewer_full_size(viewer, &desc.width, &desc.height);
    preview_start(&viewer->opening.preview, &desc);
    emitters_free(&desc.emitters);
}

/* The last one that was asked for. */
static void await_document(struct viewer *viewer, const struct document *document) {
    if (viewer->opening.is_arriving)
        leave_arriving(viewer);
    log_detail("the scene is read after %.2f s", window_time());
    viewer->opening.arriving = *document;
    viewer->opening.reloading.desc = viewer->opening.loader.desc;
    viewer->opening.is_arriving = true;
    viewer->opening.is_announced = false;
    start_preview(viewer);
}

/* Whether the shaders of the scene that arrives are there; an error of the description is left to
 * its renderer. */
static bool has_shaders(struct viewer *viewer) {
    const struct document *arriving = &viewer->opening.arriving;
    struct renderer_desc desc = viewer_first_desc(viewer, arriving);
    bool ok = viewer_is_scripted(viewer) ||
              !emitters_from_text(&desc.emitters, &arriving->scene, viewer->desc.light, 0);
    camera_place(&desc.camera, &arriving->scene, 0, 0);
    ok = ok || compiling_has(&viewer->compiling, &desc);
    emitters_free(&desc.emitters);
    return ok;
}

bool viewer_is_opening(struct viewer *viewer) {
    return viewer->opening.is_arriving || viewer->opening.arriving_sky ||
           loader_is_busy(&viewer->opening.loader);
}

void viewer_stop_opening(struct viewer *viewer) {
    const char *path = viewer->opening.is_arriving ? viewer->opening.arriving.scene.path
                                                   : viewer->opening.loader.path;
    if (viewer->opening.is_arriving || loader_is_busy(&viewer->opening.loader))
        messages_add(&viewer->host.messages, UI_NORMAL, "%s is not opened.", path_name(path));
    loader_abandon(&viewer->opening.loader);
    if (viewer->opening.is_arriving)
        leave_arriving(viewer);
    viewer_forget_sky(viewer);
    forget_given(viewer);
}

void viewer_tell_opening(struct viewer *viewer, char *text, size_t size) {
    int seconds = (int)(window_time() - viewer->opening.since);
    int programs = compiling_count(&viewer->compiling);
    if (viewer->opening.arriving_sky)
        snprintf(text, size, "%s\ncompiling shaders (%d so far)",
                 path_name(viewer->opening.arriving_sky->path), programs);
    else if (!viewer->opening.is_arriving)
        snprintf(text, size, "%s\nreading, %d s", path_name(viewer->opening.loader.path), seconds);
    else if (viewer->opening.is_announced)
        snprintf(text, size, "%s\npreparing %u faces, %d s",
                 path_name(viewer->opening.arriving.scene.path),
                 geometry_triangle_count(&viewer->opening.arriving.geometry), seconds);
    else
        snprintf(text, size, "%s\n%u faces; compiling shaders (%d), %d s",
                 path_name(viewer->opening.arriving.scene.path),
                 geometry_triangle_count(&viewer->opening.arriving.geometry), programs, seconds);
}

/* A turn of the loop goes by that says what takes the window's time next. */
static bool is_announced(struct viewer *viewer) {
    bool is = viewer->opening.is_announced || viewer_is_scripted(viewer);
    viewer->opening.is_announced = true;
    return is;
}

static void free_what_leaves(struct viewer *viewer) {
    bool leaves = viewer->opening.leaving.scene.path || viewer->opening.leaving_sky;
    if (!leaves || !compiling_rests(&viewer->compiling))
        return;
    document_free(&viewer->opening.leaving);
    environment_free(viewer->opening.leaving_sky);
    viewer->opening.leaving_sky = NULL;
}

bool viewer_poll_loader(struct viewer *viewer) {
    struct document document;
    free_what_leaves(viewer);
    switch (loader_poll(&viewer->opening.loader, &document)) {
    case LOADER_DONE:
        await_document(viewer, &document);
        break;
    case LOADER_FAILED:
        if (!viewer_is_scripted(viewer))
            forget_given(viewer);
        return false;
    case LOADER_IDLE:
    case LOADER_BUSY:
        break;
    }
    if (!viewer->opening.is_arriving || !has_shaders(viewer) || !is_announced(viewer))
        return true;
    log_detail("its shaders are there after %.2f s", window_time());
    preview_stop(&viewer->opening.preview);
    document = viewer->opening.arriving;
    pose_back(&document, &viewer->desc);
    viewer->opening.arriving = (struct document){0};
    viewer->opening.is_arriving = false;
    if (show_document(viewer, &document))
        return true;
    preview_free(&viewer->opening.preview); /* no picture follows */
    if (!viewer_is_scripted(viewer))
        forget_given(viewer);
    return false;
}

/* --- what a file is --- */

static bool ends_in(const char *path, const char *ending) {
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, ending) == 0;
}

/* A picture of a view has layers, or depth, or tells its passes; no panorama has. */
static bool is_render(const struct image *image) {
    bool has = image->passes || image_find_channel(image, "Z") >= 0;
    for (int i = 0; i < image->channel_count; i++)
        has |= strchr(image->names[i], '.') != NULL;
    return has;
}

/* .hdr holds no layers, and is what panoramas come as. Error: the file cannot be read. */
static bool is_sky(const char *path, bool *is) {
    struct image image;
    if (!image_read(&image, path))
        return false;
    *is = image.width == 2 * image.height && !is_render(&image);
    image_free(&image);
    return true;
}

static void take_reference(struct viewer *viewer, const char *path) {
    if (viewer_load_reference(viewer, path))
        messages_add(&viewer->host.messages, UI_NORMAL,
                     "%s: the reference to compare with. As a sky: Light, sky.", path_name(path));
}

static void take_picture(struct viewer *viewer, const char *path) {
    bool sky;
    if (!is_sky(path, &sky))
        viewer_tell_error(viewer);
    else if (!sky)
        take_reference(viewer, path);
    else if (!viewer->has_scene)
        messages_add(&viewer->host.messages, UI_WARNING, "%s is a sky: open a scene, then its sky.",
                     path_name(path));
    else
        viewer_open_sky(viewer, path);
}

void viewer_take_file(struct viewer *viewer, const char *path) {
    char *whole = path_of_user(path);
    messages_forget_errors(&viewer->host.messages);
    if (ends_in(whole, ".settings"))
        viewer_load_session(viewer, whole);
    else if (ends_in(whole, ".hdr") || ends_in(whole, ".exr") || ends_in(whole, ".pfm"))
        take_picture(viewer, whole);
    else
        viewer_open(viewer, whole);
    free(whole);
}
