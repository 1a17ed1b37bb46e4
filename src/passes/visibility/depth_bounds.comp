// A level of nearest and farthest depths, from the one below or, as FIRST, from the map of depth itself.
#include "shared/maps.h"

PASS_BLOCK(depth_bounds_params, 16)

layout(local_size_x = BOUNDS_GROUP, local_size_y = BOUNDS_GROUP) in;
layout(rg32f, binding = IMAGE_DEPTH_BOUNDS) uniform image2DArray bounds;

#ifdef FIRST
layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;

int below_side() {
    return params.map_size;
}

vec2 below(ivec3 texel) {
    return texelFetch(depths, texel, 0).rr;
}
#else
int below_side() {
    return bounds_side(params.base, params.level - 1);
}

vec2 below(ivec3 square) {
    int level = params.level - 1;
    return imageLoad(bounds, square + ivec3(bounds_x(params.base, level), bounds_y(params.base, level), 0)).rg;
}
#endif

void main() {
    ivec3 square = ivec3(gl_GlobalInvocationID);
    int side = bounds_side(params.base, params.level);
    if (any(greaterThanEqual(square.xy, ivec2(side))))
        return;
    // Two texels a side, the last square up to the edge.
    ivec2 first = square.xy * 2, end = ivec2(below_side() - 1);
    ivec2 last = mix(first + 1, end, equal(square.xy, ivec2(side - 1)));
    vec2 found = below(ivec3(first, square.z));
    for (int y = first.y; y <= last.y; y++)
        for (int x = first.x; x <= last.x; x++) {
            vec2 b = below(ivec3(x, y, square.z));
            found = vec2(min(found.x, b.x), max(found.y, b.y));
        }
    ivec3 place = square + ivec3(bounds_x(params.base, params.level), bounds_y(params.base, params.level), 0);
    imageStore(bounds, place, vec4(found, 0.0, 0.0));
}
