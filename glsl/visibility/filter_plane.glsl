// A binary lookup in one texel of a paraboloid map that knows its casters' planes. Where a texel's middle sees
// something nearer than the receiver, its plane, met in the receiver's own direction, may yet lie behind: in a
// corner the other wall does. A triangle then hides nothing there, so that neither walls beside nor the
// receiver's own surface need a depth bias.
#include "lib/octahedral.glsl"
#include "visibility/depth_maps.glsl"

layout(binding = UNIT_MAP_NORMAL) uniform sampler2DArray map_normals;

// Depths are stored in so many steps.
const float DEPTH_STEPS = 65535.0;

bool plane_hides(int map, receiver r, ivec2 texel) {
    vec3 middle = paraboloid_direction((vec2(texel) + 0.5) / lookup.map_size * 2.0 - 1.0);
    vec3 normal = octahedral_decode(texelFetch(map_normals, ivec3(texel, map), 0).rg);
    float stored = texelFetch(depth_maps, ivec3(texel, map), 0).r * r.unit;
    float there = dot(normal, middle), here = dot(normal, r.direction) * sign(there);
    float compared = r.distance * (1.0 - lookup.map_bias) - r.unit / DEPTH_STEPS;
    return stored * abs(there) < compared * here; // else met behind the receiver, or never
}

float lit(int map, receiver r, float extent) {
    ivec2 texel = ivec2(r.uv * lookup.map_size);
    return texel_sees(map, r, texel) || !plane_hides(map, r, texel) ? 1.0 : 0.0;
}
