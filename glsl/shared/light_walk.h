/* What light that walks from surface to surface reads (lights/light_walk.glsl). */
#ifndef SHARED_LIGHT_WALK_H
#define SHARED_LIGHT_WALK_H

#include "shared/bindings.h"

/* Up to so many bounces chance ends no walk. */
#define WALK_SURE 8

/* Where the light's own map has a VPL, its texels may lie below the surface by as much: over the scene's radius. */
#define BOUNCE_START 1e-3F

#endif
