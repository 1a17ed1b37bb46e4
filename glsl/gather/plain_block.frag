// The plane that a block of pixels lies on: the depth at its middle, 0 where there is no such plane; the slope; how far
// off the plane another depth may lie. And its normal.
#include "lib/plane.glsl"
#include "shared/plain.h"

layout(location = TARGET_PLAIN_PLANE) out vec4 plane_found;
layout(location = TARGET_PLAIN_NORMAL) out vec2 normal_code;

// Of what lists take for the same surface an eighth for each step, from a pixel to its block, to the next block, to a
// pixel of that: the rest is left to normals, which may differ a little.
const float STEP = 0.125;

vec2 code_of(ivec2 pixel) {
    return texelFetch(gbuffer_normals, ivec3(pixel, 0), 0).rg;
}

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * PLAIN_BLOCK, last = gbuffer_size() - 1;
    ivec2 middle = min(first + PLAIN_BLOCK / 2, last);
    normal_code = code_of(middle);
    plane p = plane_at(vec2(middle) + 0.5, gbuffer_depth(middle), octahedral_decode(normal_code));
    float height_in_pixels = length(camera.up) / length(camera.right) * float(params.width);
    float limit = STEP * PLANE_APART * height_in_pixels * p.across;
    float off = 0.0, turned = 0.0;
    for (int i = 0; i < PLAIN_BLOCK * PLAIN_BLOCK; i++) {
        ivec2 at = min(first + ivec2(i % PLAIN_BLOCK, i / PLAIN_BLOCK), last);
        vec2 turn = abs(code_of(at) - normal_code);
        off = max(off, off_plane(p, vec2(at - middle), gbuffer_depth(at)));
        turned = max(turned, turn.x + turn.y);
    }
    bool even = p.depth > 0.0 && off < limit && turned < params.code_apart;
    plane_found = vec4(even ? p.depth : 0.0, p.slope, limit);
}
