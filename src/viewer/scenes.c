/* Scenes come and go, cameras and lights are chosen, animations play. */
#include "viewer/viewer.h"

#include "base/error.h"
#include "base/memory.h"
#include "scene/animation.h"
#include "scene/clips.h"
#include "scene/placing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void viewer_pick_camera(struct viewer *viewer, int n) {
    const struct geometry *geometry = &viewer->document.geometry;
    struct camera camera;
    camera_place(&camera, &viewer->document.scene, n, viewer->placed.time);
    viewer->placed.camera_number = n;
    viewer->placed.camera_moved = false;
    orbit_start(&viewer->placed.orbit, &camera, geometry->center, geometry->radius);
    viewer_touch(viewer);
}

/* Without camera and lights. */
static struct renderer_desc first_desc(const struct viewer *viewer,
                                       const struct document *document) {
    struct renderer_desc desc = {
        .technique = viewer->wish.technique,
        .direct = viewer->desc.direct,
        .settings = viewer->wish.settings,
        .scene = &document->scene,
        .geometry = &document->geometry,
        .keep_lights = true,
        .timed = true,
    };
    viewer_full_size(viewer, &desc.width, &desc.height);
    return desc;
}

static bool init_renderer(struct viewer *viewer, struct renderer *renderer) {
    struct renderer_desc desc = first_desc(viewer, &viewer->document);
    desc.camera = viewer->placed.orbit.camera;
    desc.emitters = viewer->placed.emitters;
    return renderer_init(renderer, &desc);
}

/* The renderer is made anew, as one that begins with these clips would be. */
void viewer_pick_clips(struct viewer *viewer, const char *text) {
    struct document *document = &viewer->document;
    struct renderer fresh;
    if (!clips_select(&document->scene, text)) {
        viewer_tell_error(viewer);
        return;
    }
    viewer->placed.time = 0;
    viewer->placed.posed_time = -1;
    viewer_animate(viewer, 0);
    if (!init_renderer(viewer, &fresh)) {
        viewer_tell_error(viewer);
        return;
    }
    renderer_free(&viewer->shown.renderer);
    viewer->shown.renderer = fresh;
    compare_forget(&viewer->shown.compare);
    viewer->shown.left = viewer->shown.right = NULL;
}

/* Lights by a text. What it moves stays there. */
static bool place_lights(struct viewer *viewer, const char *text) {
    const struct scene *scene = &viewer->document.scene;
    struct placed *placed = &viewer->placed;
    if (!emitters_from_text(&placed->emitters, scene, text, placed->time))
        return false;
    placed->chosen_light = 0;
    placed->lights_moved = 0;
    for (int i = 0; i < placed->emitters.count && i < LIGHTS_MAX; i++) {
        const struct emitter *light = &placed->emitters.items[i];
        struct emitter before;
        if (light->number >= 0)
            emitter_place(&before, scene, light->number, placed->time);
        bool moved = light->number < 0 || memcmp(&before, light, sizeof before) != 0;
        placed->lights_moved |= (uint64_t)moved << i;
    }
    return true;
}

bool viewer_place_camera(struct viewer *viewer, const char *text) {
    const struct geometry *geometry = &viewer->document.geometry;
    struct placed *placed = &viewer->placed;
    struct camera camera;
    if (!camera_from_text(&camera, &viewer->document.scene, text, placed->time,
                          &placed->camera_number))
        return false;
    orbit_start(&placed->orbit, &camera, geometry->center, geometry->radius);
    placed->camera_moved = text && strchr(text, '=');
    viewer_touch(viewer);
    return true;
}

/* Camera and lights by texts; those that are not understood stay what they were. */
static bool place(struct viewer *viewer, const char *camera_text, const char *light_text) {
    bool has_camera = viewer_place_camera(viewer, camera_text);
    bool has_lights = place_lights(viewer, light_text);
    viewer_touch(viewer);
    return has_camera && has_lights;
}

/* --- opening --- */

/* "~/" is what a shell takes it for. */
void viewer_open(struct viewer *viewer, const char *path) {
    const char *home = strncmp(path, "~/", 2) == 0 ? getenv("HOME") : NULL;
    char *whole = mem_printf("%s%s", home ? home : "", home ? path + 1 : path);
    loader_start(&viewer->loader, whole, &viewer->desc.environment);
    free(whole);
}

static void set_title(struct viewer *viewer) {
    const char *path = viewer->document.scene.path, *slash = strrchr(path, '/');
    char title[256];
    snprintf(title, sizeof title, "%s - manylight", slash ? slash + 1 : path);
    window_set_title(viewer->host.window, title);
}

void viewer_close_scene(struct viewer *viewer) {
    recorder_stop(viewer);
    viewer_forget_truth(viewer);
    compare_forget(&viewer->shown.compare);
    compiling_wait(&viewer->compiling);
    renderer_free(&viewer->shown.renderer);
    document_free(&viewer->document);
    emitters_free(&viewer->placed.emitters);
    viewer->has_scene = viewer->shown.has_pick = viewer->shown.awaits = false;
    viewer->shown.left = viewer->shown.right = NULL;
}

/* What the command line says of the first scene. */
static bool place_as_told(struct viewer *viewer) {
    struct viewer_desc *desc = &viewer->desc;
    struct document *document = &viewer->document;
    bool ok = !desc->clip || (clips_select(&document->scene, desc->clip) &&
                              geometry_pose(&document->geometry, &document->scene, 0));
    viewer_go_to(viewer, (double)desc->time);
    return place(viewer, desc->camera, desc->light) && ok;
}

/* The new scene takes the place of the old one when it has a renderer; the old one is kept
 * otherwise. */
static bool show_document(struct viewer *viewer, struct document *document) {
    struct document before = viewer->document;
    struct placed placed_before = viewer->placed;
    struct renderer renderer;
    viewer->document = *document;
    viewer->placed = (struct placed){0};
    viewer_pick_camera(viewer, 0);
    place_lights(viewer, NULL);
    bool placed = place_as_told(viewer);
    if (!placed && !viewer_is_scripted(viewer))
        viewer_tell_error(viewer);
    if ((!placed && viewer_is_scripted(viewer)) || !init_renderer(viewer, &renderer)) {
        emitters_free(&viewer->placed.emitters);
        viewer->document = before;
        viewer->placed = placed_before;
        error_prefix("%s", document->scene.path);
        document_free(document);
        return false;
    }
    compare_forget(&viewer->shown.compare);
    viewer_forget_truth(viewer);
    if (viewer->has_scene) {
        compiling_wait(&viewer->compiling);
        renderer_free(&viewer->shown.renderer);
        document_free(&before);
        emitters_free(&placed_before.emitters);
    }
    viewer->wish.play.on = false;
    recorder_stop(viewer);
    viewer->shown.renderer = renderer;
    viewer->has_scene = true;
    viewer->shown.has_pick = false;
    viewer->shown.left = viewer->shown.right = NULL;
    /* They meant the first scene. */
    viewer->desc.camera = viewer->desc.light = viewer->desc.clip = NULL;
    viewer->desc.environment = (struct environment_desc){0};
    viewer->desc.time = 0;
    history_forget(&viewer->history);
    if (!viewer_is_scripted(viewer))
        recent_add(&viewer->start.recent, document->scene.path);
    viewer_begin_exposure(viewer);
    pace_forget(&viewer->shown.pace);
    set_title(viewer);
    snprintf(viewer->panel.scene_path, sizeof viewer->panel.scene_path, "%s", document->scene.path);
    const char *told = viewer->desc.session; /* of the first scene, too */
    viewer->desc.session = NULL;
    return !told || viewer_load_session(viewer, told) || !viewer_is_scripted(viewer);
}

/* The last one that was asked for. */
static void await_document(struct viewer *viewer, const struct document *document) {
    if (viewer->is_arriving)
        compiling_wait(&viewer->compiling);
    document_free(&viewer->arriving);
    viewer->arriving = *document;
    viewer->is_arriving = true;
}

/* Whether the shaders of the scene that arrives are there; where it cannot be told, its renderer tells why. */
static bool has_shaders(struct viewer *viewer) {
    const struct document *arriving = &viewer->arriving;
    struct renderer_desc desc = first_desc(viewer, arriving);
    bool ok = viewer_is_scripted(viewer) ||
              !emitters_from_text(&desc.emitters, &arriving->scene, viewer->desc.light, 0);
    camera_place(&desc.camera, &arriving->scene, 0, 0);
    ok = ok || compiling_has(&viewer->compiling, &desc);
    emitters_free(&desc.emitters);
    return ok;
}

bool viewer_is_opening(const struct viewer *viewer) {
    return viewer->is_arriving || atomic_load(&viewer->loader.state) != LOADER_IDLE;
}

bool viewer_poll_loader(struct viewer *viewer) {
    struct document document;
    switch (loader_poll(&viewer->loader, &document)) {
    case LOADER_DONE:
        await_document(viewer, &document);
        break;
    case LOADER_FAILED:
        return false;
    case LOADER_IDLE:
    case LOADER_BUSY:
        break;
    }
    if (!viewer->is_arriving || !has_shaders(viewer))
        return true;
    document = viewer->arriving;
    viewer->arriving = (struct document){0};
    viewer->is_arriving = false;
    return show_document(viewer, &document);
}

/* --- sessions --- */

struct session viewer_session(const struct viewer *viewer) {
    const struct scene *scene = &viewer->document.scene;
    struct session session = {
        .scene = scene->path,
        .environment = scene->environment,
        .technique = viewer->wish.technique,
        .direct = viewer->desc.direct,
        .passes = viewer->desc.passes,
        .settings = viewer->wish.settings,
        .layer = viewer->shown.layer,
        .time = (float)viewer->placed.time,
    };
    clips_to_text(scene, session.clip);
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
    viewer->desc.direct = session->direct;
    viewer->desc.passes = session->passes;
    viewer->wish.settings = session->settings;
    viewer->shown.layer = session->layer;
    viewer->wish.play.on = false;
    char clips[CLIPS_TEXT_SIZE];
    clips_to_text(&viewer->document.scene, clips);
    if (strcmp(session->clip, clips) != 0)
        viewer_pick_clips(viewer, session->clip);
    viewer_go_to(viewer, (double)session->time);
    viewer->shown.recompose = true;
    return place(viewer, session->camera, session->lights);
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
