/* Lights, cameras and materials as clips change them: KHR_animation_pointer. Without a clip that does, each is as the
 * file has it. */
#ifndef SCENE_ANIMATED_H
#define SCENE_ANIMATED_H

#include "scene/scene.h"

struct scene_light animated_light(const struct scene *scene, int light, double time);
struct scene_camera animated_camera(const struct scene *scene, int camera, double time);

/* What a change of materials makes another. */
enum animated_change {
    ANIMATED_NOTHING,
    ANIMATED_COLORS,  /* colours and numbers */
    ANIMATED_OPACITY, /* where surfaces have holes, too */
};

/* Keeps the file's materials where clips change some, and makes those as bright as they ever get: lamps are found by
 * that. */
void animated_keep_materials(struct scene *scene);

/* Lets lamps shine as their materials do. Lamps of several materials stay as they are. */
void animated_follow_materials(struct scene *scene);

/* Makes the scene's materials those of a time. */
enum animated_change animated_pose_materials(struct scene *scene, double time);

#endif
