/* A camera and a light for files that bring none. */
#ifndef SCENE_FRAMING_H
#define SCENE_FRAMING_H

#include "scene/mesh/geometry.h"

/* The nodes that carry them; -1 = the scene has its own. */
struct framing {
    int camera, light, fill;
};

/* Adds nodes for a camera, and for a spot and a dim light beside it where wants_light, where the scene
 * has none, and notes it on stderr. The lights hang on a camera that the file brings. */
void framing_add(struct framing *framing, struct scene *scene, bool wants_light);

/* Adds the lights to a scene that has some, which leave it dark (scene/darkness.h), and notes it. Once more
 * framing_place follows. */
void framing_add_lights(struct framing *framing, struct scene *scene);

/* Places what was added. The camera sees the whole scene, as far as its clip reaches, from above its
 * front right corner; the spot shines from above over the camera's left shoulder and lights more than
 * that, the dim light comes over the right one. In a room all are inside: the camera at one end of its
 * longest line, the lights below the ceiling. */
void framing_place(const struct framing *framing, struct scene *scene,
                   const struct geometry *geometry);

/* Whether the scene's n-th light is one of them. */
bool framing_made_light(const struct scene *scene, int n);

#endif
