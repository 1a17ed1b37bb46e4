/* A camera and lights for files without them. */
#ifndef SCENE_FRAMING_H
#define SCENE_FRAMING_H

#include "scene/mesh/geometry.h"

/* Nodes of the added camera and lights; -1: the scene has its own. */
struct framing {
    int camera, light, fill;
};

/* Adds nodes for a camera, and with wants_light for a spot and a dim fill light, if the scene lacks
 * them. It logs this. The lights move with the file's camera, if there is one. */
void framing_add(struct framing *framing, struct scene *scene, bool wants_light);

/* Adds the lights to a scene whose own leave it dark (scene/darkness.h), and logs it. Call
 * framing_place again afterwards. */
void framing_add_lights(struct framing *framing, struct scene *scene);

/* Places the added nodes. The camera shows the whole scene over its clip, from above its front
 * right corner. The spot is above the camera's left shoulder and covers more; the fill light is
 * above the right. In a room the camera is at one end of the longest free line, and the lights are
 * below the ceiling. */
void framing_place(const struct framing *framing, struct scene *scene,
                   const struct geometry *geometry);

/* True if the scene's n-th light was added by framing. */
bool framing_made_light(const struct scene *scene, int n);

#endif
