// float visibility(int map, vec3 position, vec3 normal): which part of a map's light reaches a point of a
// surface. VISIBILITY picks the file, as enum visibility_lookup.
#include "visibility/map_views.glsl"
#include "visibility/paraboloid.glsl"
#include "shared/visibility.h"

layout(std140, binding = BLOCK_VISIBILITY) uniform visibility_uniforms {
    visibility_params lookup;
};

#if VISIBILITY == 1 || VISIBILITY == 3
#include "visibility/depth_maps.glsl"
#endif

#if VISIBILITY == 0
#include "visibility/visibility_none.glsl"
#elif VISIBILITY == 1
#include "visibility/visibility_hard.glsl"
#elif VISIBILITY == 2
#include "visibility/visibility_cssm.glsl"
#else
#include "visibility/visibility_pcss.glsl"
#endif
