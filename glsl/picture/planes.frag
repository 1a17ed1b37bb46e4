// The plane that a block of pixels lies on, by the pixel in its middle, and how far the others are off it
// (lib/block_plane.glsl).
#include "lib/block_plane.glsl"
#include "lib/plane.glsl"

layout(location = TARGET_BLOCK_PLANE) out vec4 plane_code;
layout(location = TARGET_BLOCK_NORMAL) out vec4 normal_code;

vec2 code_of(ivec2 pixel) {
    return texelFetch(gbuffer_normals, ivec3(pixel, 0), 0).rg;
}

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * PLANE_BLOCK, last = gbuffer_size() - 1;
    ivec2 middle = min(first + PLANE_BLOCK / 2, last);
    vec2 normal = code_of(middle);
    plane p = plane_at(vec2(middle) + 0.5, gbuffer_depth(middle), octahedral_decode(normal));
    float off = 0.0, turned = 0.0;
    for (int i = 0; i < PLANE_BLOCK * PLANE_BLOCK; i++) {
        ivec2 at = min(first + ivec2(i % PLANE_BLOCK, i / PLANE_BLOCK), last);
        vec2 turn = abs(code_of(at) - normal);
        off = max(off, off_plane(p, vec2(at - middle), gbuffer_depth(at)));
        turned = max(turned, turn.x + turn.y);
    }
    plane_code = vec4(p.depth, p.slope, p.across);
    normal_code = vec4(normal, off / max(p.across, 1e-30) / BLOCK_OFF_MOST, turned);
}
