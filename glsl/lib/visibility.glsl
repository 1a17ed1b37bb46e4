// float visibility(int map, vec3 position, vec3 normal): which part of a map's light reaches a point of a
// surface. VISIBILITY picks the file, as enum visibility_lookup.
#include "lib/map_views.glsl"
#include "lib/paraboloid.glsl"
#include "shared/visibility.h"

layout(std140, binding = BLOCK_VISIBILITY) uniform visibility_uniforms {
    visibility_params lookup;
};

#if VISIBILITY == 1 || VISIBILITY == 3
#include "lib/depth_maps.glsl"
#endif

#if VISIBILITY == 0
#include "lib/visibility_none.glsl"
#elif VISIBILITY == 1
#include "lib/visibility_hard.glsl"
#elif VISIBILITY == 2
#include "lib/visibility_cssm.glsl"
#else
#include "lib/visibility_pcss.glsl"
#endif
