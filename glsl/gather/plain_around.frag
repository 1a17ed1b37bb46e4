// Whether a block of pixels and those around it lie on one plane, so near to each other that the blur takes all for alike;
// or with ERODE, whether all around it do.
#include "lib/camera.glsl"
#include "shared/plain.h"

layout(location = TARGET_RESULT) out float plain;

#if ERODE
layout(binding = UNIT_PLAIN_BLOCKS) uniform sampler2D plain_blocks;

bool is_plain(ivec2 from, ivec2 at) {
    return texelFetch(plain_blocks, at, 0).r > 0.5;
}
#else
layout(binding = UNIT_PLAIN_PLANES) uniform sampler2D planes;
layout(binding = UNIT_PLAIN_NORMALS) uniform sampler2D normal_codes;

bool is_same_plane(ivec2 from, ivec2 at) {
    vec4 here = texelFetch(planes, from, 0), there = texelFetch(planes, at, 0);
    vec2 pixels = vec2(at - from) * float(PLAIN_BLOCK), bent = abs(there.yz - here.yz);
    vec2 turn = abs(texelFetch(normal_codes, at, 0).rg - texelFetch(normal_codes, from, 0).rg);
    float off = abs(here.x + dot(here.yz, pixels) - there.x) + float(PLAIN_BLOCK / 2) * (bent.x + bent.y);
    return here.x > 0.0 && there.x > 0.0 && off < here.w && turn.x + turn.y < params.code_apart;
}

// No pixel that blur or lists ask for, as far along x or y, or half as far along both, is farther away than by its place
// in the picture and by its depth along the longest ray.
bool is_near(ivec2 from) {
    vec4 here = texelFetch(planes, from, 0);
    vec2 extent = vec2(length(camera.right), length(camera.up));
    float pixels = float(params.reach * PLAIN_BLOCK), aside = pixels * 2.0 * extent.x / float(params.width);
    float change = pixels * max(abs(here.y), abs(here.z)) + 2.0 * here.w;
    float along = camera.orthographic ? change * camera.far : change / max(here.x - change, 1e-30);
    return along * (1.0 + extent.x + extent.y) + aside < params.distance * 2.0 * extent.y;
}

bool is_plain(ivec2 from, ivec2 at) {
    return is_same_plane(from, at) && is_near(from);
}
#endif

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy);
#if ERODE
    ivec2 last = textureSize(plain_blocks, 0) - 1;
#else
    ivec2 last = textureSize(planes, 0) - 1;
#endif
    plain = 1.0;
    for (int y = -params.reach; y <= params.reach; y++)
        for (int x = -params.reach; x <= params.reach; x++)
            plain = is_plain(block, clamp(block + ivec2(x, y), ivec2(0), last)) ? plain : 0.0;
}
