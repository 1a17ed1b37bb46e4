#define _XOPEN_SOURCE 700
#include "viewer/files/kept.h"

#include "base/error.h"
#include "base/file/folder.h"
#include "base/memory.h"
#include "scene/hash.h"
#include "viewer/picture/budget.h"
#include "viewer/scene/exposure.h"
#include "viewer/scene/sessions.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void viewer_tell_saved(struct viewer *viewer, bool ok, const char *path) {
    char *whole = ok ? realpath(path, NULL) : NULL;
    if (ok)
        messages_add_result(&viewer->host.messages, "saved: %s", whole ? whole : path);
    else
        viewer_tell_error(viewer);
    free(whole);
}

void viewer_save_session(struct viewer *viewer) {
    if (!viewer->has_scene)
        return;
    struct session session = viewer_session(viewer);
    viewer_tell_saved(viewer, session_save(&session, viewer->panel.session_path),
                      viewer->panel.session_path);
    session_free(&session);
}

/* --- how scenes were left --- */

/* NULL: the user has no folder for it. */
static char *state_path(const char *scene) {
    char *folder = folder_of_user("XDG_STATE_HOME", ".local/state"), *whole = realpath(scene, NULL);
    char *path = NULL;
    if (folder && whole) {
        uint64_t hash = 0;
        hash_bytes(&hash, whole, strlen(whole));
        path = mem_printf("%s/scenes/%016llx.settings", folder, (unsigned long long)hash);
    }
    mem_free(folder, whole);
    return path;
}

/* Whether the user has changed something since: an exposure that came by itself is nothing. */
static bool is_changed(struct viewer *viewer, const struct session *since,
                       const struct session *now) {
    struct session before = session_copy(since);
    struct picture_settings picture =
        *settings_of(struct picture_settings, &before.settings, &picture_part);
    picture.exposure = viewer->exposing.usual;
    settings_set(&before.settings, &picture_part, &picture);
    bool changed = !history_same(&before, now);
    for (int i = 0; i < SESSION_VIEWS; i++)
        changed |= strcmp(before.views[i], now->views[i]) != 0;
    session_free(&before);
    return changed;
}

/* The file keeps a sky that could not be read, until the user changes something. */
static bool is_left_alone(struct viewer *viewer, const struct session *now) {
    return viewer->kept.is_incomplete && !is_changed(viewer, &viewer->kept.shown, now);
}

void kept_save(struct viewer *viewer) {
    if (!viewer->has_scene || !viewer->kept.on)
        return;
    struct session session = viewer_session(viewer);
    char *path = is_left_alone(viewer, &session) ? NULL : state_path(session.scene);
    /* What is not kept is no reason to stop the user. */
    if (path && !viewer->kept.was_restored && !is_changed(viewer, &viewer->kept.fresh, &session))
        remove(path);
    else if (path && folder_make_for(path))
        session_save(&session, path);
    session_free(&session);
    free(path);
}

static struct session copy_session(const struct viewer *viewer) {
    struct session now = viewer_session(viewer), copy = session_copy(&now);
    session_free(&now);
    return copy;
}

/* The sky comes last in a text of lights. Of none, all of the scene's shine. */
static void drop_sky(char *lights) {
    size_t length = strlen(lights);
    if (length < 3 || strcmp(lights + length - 3, "sky") != 0)
        return;
    for (length -= 3; length > 0 && strchr("; ,", lights[length - 1]); length--)
        ;
    lights[length] = '\0';
}

/* A sky that cannot be read any more: the scene's own is there in its place. */
static void show_without_sky(struct viewer *viewer, struct session *session) {
    const struct environment *own = viewer->document.scene.environment;
    free(session->sky);
    session_set_sky(session, own);
    if (!own)
        drop_sky(session->lights);
    if (!viewer_show_session(viewer, session))
        viewer_tell_error(viewer);
}

/* As much of it as can be shown. */
static void show_left(struct viewer *viewer, struct session *session) {
    struct kept *kept = &viewer->kept;
    kept->was_restored = true;
    kept->is_incomplete = !viewer_show_session(viewer, session);
    if (kept->is_incomplete) {
        struct session now = viewer_session(viewer);
        messages_add(&viewer->host.messages, UI_WARNING,
                     "Not all of the scene is as you left it: %s", error_get());
        if (!session_same_sky(&now, session))
            show_without_sky(viewer, session);
        session_free(&now);
    } else
        messages_add(&viewer->host.messages, UI_NORMAL,
                     "The scene is as you left it; Scene, Afresh: as its file has it.");
    viewer_keep_exposure(viewer);
}

static void restore(struct viewer *viewer, const char *path) {
    struct session session = session_copy(&viewer->kept.fresh);
    session.scene = viewer->document.scene.path;
    int left_out = 0;
    if (session_load(&session, path, &left_out)) {
        if (left_out > 0)
            messages_add(&viewer->host.messages, UI_WARNING,
                         "%d lines of how you left the scene are left out: %s", left_out,
                         error_get());
        show_left(viewer, &session);
        viewer->kept.is_incomplete |= left_out > 0;
    } else {
        viewer->kept.is_incomplete = true;
        messages_add(&viewer->host.messages, UI_WARNING, "The scene is not as you left it: %s",
                     error_get());
    }
    session_free(&session);
    viewer->kept.shown = copy_session(viewer);
}

void kept_begin(struct viewer *viewer) {
    struct kept *kept = &viewer->kept;
    kept_free(viewer);
    kept->was_restored = kept->is_incomplete = false;
    kept->on = !viewer_is_scripted(viewer) && !viewer->opening.is_given;
    if (!kept->on)
        return;
    kept->fresh = copy_session(viewer);
    char *path = state_path(viewer->document.scene.path);
    if (path && access(path, R_OK) == 0)
        restore(viewer, path);
    free(path);
}

/* Technique and settings may have come from the scene before: as the command line has them. */
void kept_begin_afresh(struct viewer *viewer) {
    const struct viewer_desc *desc = &viewer->desc;
    struct session *fresh = &viewer->kept.fresh;
    fresh->technique = desc->technique ? desc->technique : technique_default;
    fresh->direct = desc->direct;
    fresh->passes = desc->passes;
    fresh->settings = desc->settings;
    fresh->layer = desc->layer;
    if (!viewer_show_session(viewer, fresh))
        viewer_tell_error(viewer);
    viewer_set_budget(viewer, desc->budget);
    viewer->kept.was_restored = viewer->kept.is_incomplete = false;
    viewer_begin_exposure(viewer);
}

void kept_free(struct viewer *viewer) {
    session_free(&viewer->kept.fresh);
    session_free(&viewer->kept.shown);
}
