/* Lights, cameras and materials that clips change (KHR_animation_pointer). Each returns the file's
 * value if no playing clip changes it. time: seconds. */
#ifndef SCENE_ANIMATED_H
#define SCENE_ANIMATED_H

#include "scene/scene.h"

struct scene_light animated_light(const struct scene *scene, int light, double time);
struct scene_camera animated_camera(const struct scene *scene, int camera, double time);

/* Effect of a change of materials. */
enum animated_change {
    ANIMATED_NOTHING,
    ANIMATED_COLORS,  /* colours and numbers */
    ANIMATED_OPACITY, /* also the holes of surfaces */
};

/* Keeps a copy of the file's materials if clips change some. It gives each its greatest emission,
 * because lamps are found by emission. */
void animated_keep_materials(struct scene *scene);

/* Sets lamps to their materials' emission. Lamps of several materials stay unchanged. */
void animated_follow_materials(struct scene *scene);

/* Sets the scene's materials to a time, seconds. Returns the greatest change. */
enum animated_change animated_pose_materials(struct scene *scene, double time);

#endif
