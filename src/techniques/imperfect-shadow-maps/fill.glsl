// What the steps of pull and push have in common. Depths are the map's, and 1 where nothing is.
#include "passes/visibility/map_views.glsl"
#include "passes/visibility/paraboloid.glsl"
#include "shared/splat.h"

PASS_BLOCK(fill_params, 16)

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray fine_depths;

flat in int instance; // the map

float fine_depth(ivec2 texel) {
    return texelFetch(fine_depths, ivec3(texel, instance), 0).r;
}

// Depths that far apart may be of one surface, in texels of a level.
float interval(int level) {
    return 2.0 * params.radius * float(1 << level) / map_view_at(instance).z_far;
}
