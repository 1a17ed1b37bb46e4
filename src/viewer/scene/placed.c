#include "viewer/scene/placed.h"

#include "scene/clips.h"
#include "scene/placing.h"
#include "viewer/picture/picture.h"
#include "viewer/scene/animation.h"

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

void viewer_take_renderer(struct viewer *viewer, const struct renderer *renderer) {
    compare_forget(&viewer->shown.compare);
    renderer_free(&viewer->shown.renderer);
    viewer->shown.renderer = *renderer;
    viewer->shown.left = viewer->shown.right = NULL;
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
    viewer_take_renderer(viewer, &fresh);
}

bool viewer_place_lights(struct viewer *viewer, const char *text) {
    const struct scene *scene = &viewer->document.scene;
    struct placed *placed = &viewer->placed;
    if (!emitters_from_text(&placed->emitters, scene, text, placed->time))
        return false;
    struct emitters before = emitters_place(scene, placed->time);
    placed->chosen_light = 0;
    for (int i = 0; i < placed->emitters.count; i++) {
        struct emitter *light = &placed->emitters.items[i];
        light->moved =
            light->number < 0 || memcmp(&before.items[light->number], light, sizeof *light) != 0;
    }
    emitters_free(&before);
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

/* --- views that are kept, to come back to --- */

int views_free(const struct viewer *viewer) {
    int i = 0;
    while (i < SESSION_VIEWS - 1 && *viewer->placed.views[i])
        i++;
    return i;
}

void views_keep(struct viewer *viewer, int i) {
    struct placed *placed = &viewer->placed;
    if (!viewer->has_scene)
        return;
    camera_to_text(&placed->orbit.camera, &viewer->document.scene, placed->camera_number,
                   placed->time, placed->views[i]);
    messages_add(&viewer->host.messages, UI_NORMAL, "view %d kept: Alt %d goes there", i + 1,
                 i + 1);
}

void views_go(struct viewer *viewer, int i) {
    const char *text = viewer->placed.views[i];
    if (!viewer->has_scene)
        return;
    if (!*text)
        messages_add(&viewer->host.messages, UI_NORMAL, "no view %d yet: Ctrl %d keeps one", i + 1,
                     i + 1);
    else if (!viewer_place_camera(viewer, text))
        viewer_tell_error(viewer);
}
