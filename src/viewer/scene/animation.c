#include "viewer/scene/animation.h"

#include "scene/animation.h"
#include "viewer/scene/lights.h"

#include <math.h>

static void place_camera(struct viewer *viewer) {
    const struct geometry *geometry = &viewer->document.geometry;
    struct placed *placed = &viewer->placed;
    struct camera camera;
    camera_place(&camera, &viewer->document.scene, placed->camera_number, placed->time);
    orbit_start(&placed->orbit, &camera, geometry->center, geometry->radius);
}

static void pose(struct viewer *viewer) {
    struct document *document = &viewer->document;
    struct placed *placed = &viewer->placed;
    /* What a broken pose leaves cannot be drawn: back to where it began. */
    if (!geometry_pose(&document->geometry, &document->scene, placed->time)) {
        viewer_tell_error(viewer);
        viewer->wish.play.on = false;
        placed->time = 0;
        geometry_pose(&document->geometry, &document->scene, 0);
    }
    if (!placed->camera_moved)
        place_camera(viewer);
    struct emitters moved = emitters_place(&document->scene, placed->time);
    for (int i = 0; i < placed->emitters.count; i++) {
        struct emitter *light = &placed->emitters.items[i];
        if (!viewer_light_is_moved(viewer, i))
            *light = moved.items[light->number];
    }
    emitters_free(&moved);
    placed->posed_time = placed->time;
    viewer_touch(viewer);
}

/* In single precision, as a command line tells it. */
double viewer_time_in(const struct viewer *viewer, const struct scene *scene, double time) {
    double duration = scene_duration(scene);
    if (!viewer->wish.play.loops || duration <= 0)
        return (double)(float)fmin(fmax(time, 0), duration);
    double rest = fmod(time, duration);
    return (double)(float)(rest < 0 ? rest + duration : rest);
}

void viewer_go_to(struct viewer *viewer, double time) {
    viewer->placed.time = viewer_time_in(viewer, &viewer->document.scene, time);
}

void viewer_toggle_play(struct viewer *viewer) {
    double duration = scene_duration(&viewer->document.scene);
    if (!viewer->has_scene || duration <= 0)
        return;
    viewer->wish.play.on = !viewer->wish.play.on;
    if (viewer->wish.play.on && !viewer->wish.play.loops &&
        viewer->placed.time >= (double)(float)duration)
        viewer_go_to(viewer, 0);
}

void viewer_animate(struct viewer *viewer, double seconds) {
    struct playing *play = &viewer->wish.play;
    double duration = scene_duration(&viewer->document.scene);
    if (play->on)
        viewer_go_to(viewer, viewer->placed.time + seconds * (double)play->speed);
    if (!play->loops && viewer->placed.time >= (double)(float)duration)
        play->on = false;
    if (viewer->placed.time != viewer->placed.posed_time)
        pose(viewer);
}
