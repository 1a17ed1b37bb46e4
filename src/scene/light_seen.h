/* How much of the light that lamps send has a short way into the picture: little where they shine next door. */
#ifndef SCENE_LIGHT_SEEN_H
#define SCENE_LIGHT_SEEN_H

#include "scene/lights/emitter.h"
#include "scene/surface_rays.h"

/* Of the flux that surfaces get from the emitters but their sky, the fraction on places that something seen faces, with
 * nothing between: each of some 256 places has eight of 64 seen ones to face. Reflectances count as equal. Where none has a
 * way, up to 4096 places are tried, and the answer is 1 where it stays so. The same inputs give the same bits. Cost: two
 * thousand rays; sixteen times as many where no light comes. */
float light_seen(const struct surface_rays *rays, const struct emitters *emitters,
                 const struct camera *camera, float aspect);

#endif
