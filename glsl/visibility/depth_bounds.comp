// A level of nearest and farthest depths, from the one below or, as FIRST, from the map of depth itself.
#include "shared/depth_bounds.h"

layout(local_size_x = BOUNDS_GROUP, local_size_y = BOUNDS_GROUP) in;
layout(rg32f, binding = IMAGE_DEPTH_BOUNDS) writeonly uniform image2DArray bounds;

#ifdef FIRST
layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;

vec2 below(ivec3 texel) {
    return texelFetch(depths, texel, 0).rr;
}
#else
layout(binding = UNIT_DEPTH_BOUNDS) uniform sampler2DArray lower;

vec2 below(ivec3 texel) {
    return texelFetch(lower, texel, params.level - 1).rg;
}
#endif

void main() {
    ivec3 square = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(square.xy, ivec2(params.size))))
        return;
    // Two texels a side, the last square up to the edge.
    ivec2 first = square.xy * 2;
    ivec2 last = mix(min(first + 1, params.below - 1), ivec2(params.below - 1), equal(square.xy, ivec2(params.size - 1)));
    vec2 found = below(ivec3(first, square.z));
    for (int y = first.y; y <= last.y; y++)
        for (int x = first.x; x <= last.x; x++) {
            vec2 b = below(ivec3(x, y, square.z));
            found = vec2(min(found.x, b.x), max(found.y, b.y));
        }
    imageStore(bounds, square, vec4(found, 0.0, 0.0));
}
