#define _XOPEN_SOURCE 700
#include "viewer/scene/sessions.h"

#include "scene/clips.h"
#include "scene/placing.h"
#include "viewer/picture/picture.h"
#include "viewer/scene/animation.h"
#include "viewer/scene/placed.h"
#include "viewer/scene/sky.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Camera and lights by texts; those that are not understood stay what they were. */
static bool place(struct viewer *viewer, const char *camera_text, const char *light_text) {
    bool has_camera = viewer_place_camera(viewer, camera_text);
    bool has_lights = viewer_place_lights(viewer, light_text);
    viewer_touch(viewer);
    return has_camera && has_lights;
}

struct session viewer_session(const struct viewer *viewer) {
    const struct scene *scene = &viewer->document.scene;
    struct session session = {
        .scene = scene->path,
        .technique = viewer->wish.technique,
        .direct = viewer->wish.direct,
        .passes = viewer->wish.passes,
        .settings = viewer->wish.settings,
        .layer = viewer->shown.layer,
        .time = (float)viewer->placed.time,
    };
    choice_to_text(&scene->scenes, session.shown_scene);
    choice_to_text(&scene->variants, session.variant);
    clips_to_text(scene, session.clip);
    session_set_sky(&session, scene->environment);
    viewer_full_size(viewer, &session.width, &session.height);
    camera_to_text(&viewer->placed.orbit.camera, scene, viewer->placed.camera_number,
                   viewer->placed.time, session.camera);
    memcpy(session.views, viewer->placed.views, sizeof session.views);
    session.lights = emitters_to_text(&viewer->placed.emitters, scene, viewer->placed.time);
    return session;
}

bool viewer_show_session(struct viewer *viewer, const struct session *session) {
    memcpy(viewer->placed.views, session->views, sizeof session->views);
    viewer->wish.technique = session->technique;
    viewer->wish.direct = session->direct;
    viewer->wish.passes = session->passes;
    viewer->wish.settings = session->settings;
    viewer->shown.layer = session->layer;
    viewer->wish.play.on = false;
    char clips[CLIPS_TEXT_SIZE];
    clips_to_text(&viewer->document.scene, clips);
    /* A file of settings may name clip 0 of a scene that has none. */
    if (viewer->document.scene.clip_count > 0 && strcmp(session->clip, clips) != 0)
        viewer_pick_clips(viewer, session->clip);
    viewer_go_to(viewer, (double)session->time);
    viewer->shown.recompose = true;
    return viewer_show_sky(viewer, session) && place(viewer, session->camera, session->lights);
}

void viewer_save_session(struct viewer *viewer) {
    if (!viewer->has_scene)
        return;
    struct session session = viewer_session(viewer);
    const char *path = viewer->panel.session_path;
    if (session_save(&session, path)) {
        char *whole = realpath(path, NULL);
        messages_add_result(&viewer->host.messages, "saved: %s", whole ? whole : path);
        free(whole);
    } else
        viewer_tell_error(viewer);
    session_free(&session);
}

bool viewer_load_session(struct viewer *viewer, const char *path) {
    if (!viewer->has_scene) {
        messages_add(&viewer->host.messages, UI_WARNING, "Open a scene, then its settings.");
        return false;
    }
    struct session session = viewer_session(viewer);
    bool ok = session_load(&session, path) && viewer_show_session(viewer, &session);
    if (ok && path != viewer->panel.session_path)
        snprintf(viewer->panel.session_path, sizeof viewer->panel.session_path, "%s", path);
    if (!ok)
        viewer_tell_error(viewer);
    session_free(&session);
    return ok;
}

/* --- undo --- */

/* While something is dragged, typed, played or flown through there is no step yet. */
static bool is_settled(const struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    for (int i = 0; i < BUTTON_COUNT; i++)
        if (input->held[i])
            return false;
    return viewer->has_scene && !viewer->shown.moving && !viewer->shown.dirty &&
           !viewer->wish.play.on && !viewer_is_scripted(viewer);
}

static void note(struct viewer *viewer) {
    struct session session = viewer_session(viewer);
    history_note(&viewer->history, &session);
    session_free(&session);
}

void viewer_note_step(struct viewer *viewer) {
    if (is_settled(viewer))
        note(viewer);
}

void viewer_undo(struct viewer *viewer, int by) {
    if (!viewer->has_scene)
        return;
    note(viewer);
    const struct session *step = history_step(&viewer->history, by);
    if (!step) {
        messages_add(&viewer->host.messages, UI_NORMAL,
                     by < 0 ? "Nothing to undo." : "Nothing to redo.");
        return;
    }
    struct session taken = *step;
    memcpy(taken.views, viewer->placed.views, sizeof taken.views); /* what was kept stays */
    if (!viewer_show_session(viewer, &taken))
        viewer_tell_error(viewer);
    struct session shown = viewer_session(viewer);
    history_correct(&viewer->history, &shown);
    session_free(&shown);
}
