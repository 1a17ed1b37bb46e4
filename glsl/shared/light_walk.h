/* Parameters of light walks (passes/lights/light_walk.glsl). */
#ifndef SHARED_LIGHT_WALK_H
#define SHARED_LIGHT_WALK_H

#include "shared/bindings.h"

/* Bounces before Russian roulette may end a walk. */
#define WALK_SURE 8

/* Depth by which texels of the light's RSM may be below a VPL's surface, over the scene's
 * radius. */
#define BOUNCE_START 1e-3F

#endif
