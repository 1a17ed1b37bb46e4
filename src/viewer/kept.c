/* What outlives the window: settings that the user saves, and how each scene was left. */
#define _XOPEN_SOURCE 700
#include "viewer/viewer.h"

#include "base/error.h"
#include "base/file/folder.h"
#include "base/memory.h"
#include "scene/hash.h"

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
    free(folder);
    free(whole);
    return path;
}

/* Whether the user has changed something: an exposure that came by itself is nothing. */
static bool is_changed(struct viewer *viewer, const struct session *now) {
    struct session fresh = session_copy(&viewer->kept.fresh);
    struct picture_settings *picture = settings_edit(&fresh.settings, &picture_part);
    picture->exposure = viewer->exposing.usual;
    bool changed = !history_same(&fresh, now);
    for (int i = 0; i < SESSION_VIEWS; i++)
        changed |= *now->views[i] != '\0';
    session_free(&fresh);
    return changed;
}

void kept_save(struct viewer *viewer) {
    if (!viewer->has_scene || !viewer->kept.on)
        return;
    struct session session = viewer_session(viewer);
    char *path = state_path(session.scene);
    /* What is not kept is no reason to stop the user. */
    if (path && !viewer->kept.was_restored && !is_changed(viewer, &session))
        remove(path);
    else if (path && folder_make_for(path))
        session_save(&session, path);
    session_free(&session);
    free(path);
}

static void show_fresh(struct viewer *viewer) {
    if (!viewer_show_session(viewer, &viewer->kept.fresh))
        viewer_tell_error(viewer);
    viewer->kept.was_restored = false;
    viewer_begin_exposure(viewer);
}

static bool restore(struct viewer *viewer, const char *path) {
    struct session session = session_copy(&viewer->kept.fresh);
    session.scene = viewer->document.scene.path;
    bool ok = session_load(&session, path) && viewer_show_session(viewer, &session);
    session_free(&session);
    return ok;
}

void kept_begin(struct viewer *viewer) {
    struct kept *kept = &viewer->kept;
    session_free(&kept->fresh);
    kept->was_restored = false;
    kept->on = !viewer_is_scripted(viewer) && !viewer->opening.is_told;
    if (!kept->on)
        return;
    struct session fresh = viewer_session(viewer);
    kept->fresh = session_copy(&fresh);
    session_free(&fresh);
    char *path = state_path(viewer->document.scene.path);
    if (path && access(path, R_OK) == 0) {
        kept->was_restored = restore(viewer, path);
        if (kept->was_restored) {
            viewer_keep_exposure(viewer);
            messages_add(&viewer->host.messages, UI_NORMAL,
                         "The scene is as you left it; Scene, Afresh: as its file has it.");
        } else {
            messages_add(&viewer->host.messages, UI_WARNING, "The scene is not as you left it: %s",
                         error_get());
            show_fresh(viewer);
        }
    }
    free(path);
}

void kept_begin_afresh(struct viewer *viewer) {
    show_fresh(viewer);
}

void kept_free(struct viewer *viewer) {
    session_free(&viewer->kept.fresh);
}
