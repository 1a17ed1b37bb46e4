/* Scenes come and go, cameras and lights are chosen, animations play. */
#include "viewer/viewer.h"

#include "base/error.h"
#include "scene/animation.h"
#include "scene/placing.h"

#include <math.h>
#include <stdio.h>
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

void viewer_pick_light(struct viewer *viewer, int n) {
    light_place(&viewer->placed.light, &viewer->document.scene, n, viewer->placed.time);
    viewer->placed.light_number = n;
    viewer->placed.light_moved = false;
    viewer_touch(viewer);
}

/* Camera and light by texts; those that are not understood stay what they were. */
static bool place(struct viewer *viewer, const char *camera_text, const char *light_text) {
    const struct scene *scene = &viewer->document.scene;
    const struct geometry *geometry = &viewer->document.geometry;
    struct camera camera;
    struct light light;
    bool has_camera = camera_from_text(&camera, scene, camera_text, viewer->placed.time,
                                       &viewer->placed.camera_number);
    if (has_camera) {
        orbit_start(&viewer->placed.orbit, &camera, geometry->center, geometry->radius);
        viewer->placed.camera_moved = camera_text && strchr(camera_text, '=');
    }
    bool has_light = light_from_text(&light, scene, light_text, viewer->placed.time,
                                     &viewer->placed.light_number);
    if (has_light) {
        viewer->placed.light = light;
        viewer->placed.light_moved = light_text && strchr(light_text, '=');
    }
    viewer_touch(viewer);
    return has_camera && has_light;
}

/* --- opening --- */

void viewer_open(struct viewer *viewer, const char *path) {
    loader_start(&viewer->loader, path);
}

static bool init_renderer(struct viewer *viewer, struct renderer *renderer) {
    struct renderer_desc desc = {
        .technique = viewer->technique,
        .settings = viewer->settings,
        .scene = &viewer->document.scene,
        .geometry = &viewer->document.geometry,
        .camera = viewer->placed.orbit.camera,
        .light = viewer->placed.light,
        .keep_lights = true,
        .timed = true,
        .software = context_is_software(viewer->context),
    };
    viewer_full_size(viewer, &desc.width, &desc.height);
    return renderer_init(renderer, &desc);
}

static void set_title(struct viewer *viewer) {
    const char *path = viewer->document.scene.path, *slash = strrchr(path, '/');
    char title[256];
    snprintf(title, sizeof title, "%s - manylight", slash ? slash + 1 : path);
    window_set_title(viewer->window, title);
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
    viewer_pick_light(viewer, 0);
    bool placed = place(viewer, viewer->desc.camera, viewer->desc.light);
    if (!placed && !viewer_is_scripted(viewer))
        viewer_tell_error(viewer);
    if ((!placed && viewer_is_scripted(viewer)) || !init_renderer(viewer, &renderer)) {
        viewer->document = before;
        viewer->placed = placed_before;
        error_prefix("%s", document->scene.path);
        document_free(document);
        return false;
    }
    compare_forget(&viewer->compare);
    if (viewer->has_scene) {
        renderer_free(&viewer->renderer);
        document_free(&before);
    }
    viewer->renderer = renderer;
    viewer->has_scene = true;
    viewer->has_pick = false;
    viewer->left = viewer->right = NULL;
    viewer->desc.camera = viewer->desc.light = NULL; /* they meant the first scene */
    pace_forget(&viewer->pace);
    set_title(viewer);
    return true;
}

bool viewer_poll_loader(struct viewer *viewer) {
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

/* --- animation --- */

static void pose(struct viewer *viewer) {
    struct document *document = &viewer->document;
    if (!viewer->placed.camera_moved) {
        const struct geometry *geometry = &document->geometry;
        struct camera camera;
        camera_place(&camera, &document->scene, viewer->placed.camera_number, viewer->placed.time);
        orbit_start(&viewer->placed.orbit, &camera, geometry->center, geometry->radius);
    }
    if (!viewer->placed.light_moved)
        light_place(&viewer->placed.light, &document->scene, viewer->placed.light_number,
                    viewer->placed.time);
    /* What a broken pose leaves cannot be drawn: back to where it began. */
    if (!geometry_pose(&document->geometry, &document->scene, viewer->placed.time)) {
        viewer_tell_error(viewer);
        viewer->plays = false;
        viewer->placed.time = 0;
        geometry_pose(&document->geometry, &document->scene, 0);
    }
    viewer->placed.posed_time = viewer->placed.time;
    viewer_touch(viewer);
}

void viewer_animate(struct viewer *viewer, double seconds) {
    double duration = scene_duration(&viewer->document.scene);
    if (viewer->plays && duration > 0)
        viewer->placed.time = fmod(viewer->placed.time + seconds, duration);
    if (viewer->placed.time != viewer->placed.posed_time)
        pose(viewer);
}

/* --- sessions --- */

struct session viewer_session(const struct viewer *viewer) {
    const struct scene *scene = &viewer->document.scene;
    struct session session = {
        .scene = scene->path,
        .technique = viewer->technique,
        .settings = viewer->settings,
        .time = viewer->placed.time,
    };
    viewer_full_size(viewer, &session.width, &session.height);
    camera_to_text(&viewer->placed.orbit.camera, scene, viewer->placed.camera_number,
                   viewer->placed.time, session.camera);
    light_to_text(&viewer->placed.light, scene, viewer->placed.light_number, viewer->placed.time,
                  session.light);
    return session;
}

void viewer_apply_session(struct viewer *viewer, const struct session *session) {
    viewer->technique = session->technique;
    viewer->settings = session->settings;
    if (!place(viewer, session->camera, session->light))
        viewer_tell_error(viewer);
}
