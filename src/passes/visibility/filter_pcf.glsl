// Percentage-closer filtering [Reeves et al. 1987] over the four nearest texels: a hard shadow whose edge
// is a texel wide and not stepped. So near to it, the receiver is as far everywhere.
#include "passes/visibility/depth_maps.glsl"

float lit(int map, receiver r, float extent) {
    vec2 at = r.uv * lookup.map_size - 0.5;
    ivec2 base = ivec2(floor(at)), last = ivec2(lookup.map_size) - 1;
    vec2 weight = at - vec2(base);
    vec4 sees;
    for (int i = 0; i < 4; i++) {
        ivec2 texel = clamp(base + ivec2(i & 1, i >> 1), ivec2(0), last);
        float stored = texelFetch(depth_maps, ivec3(texel, map), 0).r;
        sees[i] = r.distance <= map_depth(r, stored) * r.unit ? 1.0 : 0.0;
    }
    vec2 row = mix(sees.xz, sees.yw, weight.x);
    return mix(row.x, row.y, weight.y);
}
