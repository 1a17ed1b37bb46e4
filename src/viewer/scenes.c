/* Scenes come and go, cameras and lights are chosen, animations play. */
#include "viewer/viewer.h"

#include "scene/clips.h"
#include "scene/placing.h"

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
struct renderer_desc viewer_first_desc(const struct viewer *viewer,
                                       const struct document *document) {
    struct renderer_desc desc = {
        .technique = viewer->wish.technique,
        .direct = viewer->wish.direct,
        .settings = viewer->wish.settings,
        .scene = &document->scene,
        .geometry = &document->geometry,
        .keep_lights = true,
        .timed = true,
    };
    viewer_full_size(viewer, &desc.width, &desc.height);
    return desc;
}

bool viewer_init_renderer(struct viewer *viewer, struct renderer *renderer) {
    struct renderer_desc desc = viewer_first_desc(viewer, &viewer->document);
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
    if (!viewer_init_renderer(viewer, &fresh)) {
        viewer_tell_error(viewer);
        return;
    }
    renderer_free(&viewer->shown.renderer);
    viewer->shown.renderer = fresh;
    compare_forget(&viewer->shown.compare);
    viewer->shown.left = viewer->shown.right = NULL;
}

/* Lights by a text. What it moves stays there. */
bool viewer_place_lights(struct viewer *viewer, const char *text) {
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
    bool has_lights = viewer_place_lights(viewer, light_text);
    viewer_touch(viewer);
    return has_camera && has_lights;
}

/* --- sessions --- */

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

bool viewer_load_session(struct viewer *viewer, const char *path) {
    if (!viewer->has_scene) {
        messages_add(&viewer->host.messages, UI_WARNING, "Open a scene, then its settings.");
        return false;
    }
    struct session session = viewer_session(viewer);
    bool ok = session_load(&session, path, NULL) && viewer_show_session(viewer, &session);
    if (ok && path != viewer->panel.session_path)
        snprintf(viewer->panel.session_path, sizeof viewer->panel.session_path, "%s", path);
    if (!ok)
        viewer_tell_error(viewer);
    session_free(&session);
    return ok;
}
