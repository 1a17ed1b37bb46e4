// float visibility(int map, vec3 position): which part of a map's light reaches a point. VISIBILITY
// picks the file: 0 none, 1 hard, 2 convolution soft shadow maps.
#include "lib/paraboloid.glsl"

layout(std140, binding = BLOCK_MAPS) uniform map_uniforms {
    map_view views[MAP_VIEWS_MAX];
};
layout(std140, binding = BLOCK_VISIBILITY) uniform visibility_uniforms {
    visibility_params lookup;
};

#if VISIBILITY == 0
#include "lib/visibility_none.glsl"
#elif VISIBILITY == 1
#include "lib/visibility_hard.glsl"
#else
#include "lib/visibility_cssm.glsl"
#endif
