// Direct light of a point, of all lights: each through its shadow map.
#define POINTS_ONLY
#include "lib/medium.glsl"
#include "lib/unshadowed.glsl"

layout(binding = UNIT_VOLUME_SHADOWS) uniform sampler2DArray shadow_maps[LIGHT_MAP_KINDS];

const float LIFT = 1.5; // of a point off its surface, texels

// 1 if the view sees the point; also where it does not look.
float point_seen(light_view v, vec3 position, vec3 normal) {
    vec2 size = vec2(v.kind == LIGHT_MAP_FACE ? textureSize(shadow_maps[LIGHT_MAP_FACE], 0).xy
                                              : textureSize(shadow_maps[LIGHT_MAP_SINGLE], 0).xy);
    float spread = v.view.orthographic ? 1.0 : max(dot(position - v.view.origin, v.view.forward), 0.0);
    float texel_width = 2.0 * length(v.view.right) * spread / size.x;
    vec4 clip = v.view.world_to_clip * vec4(position + normal * (LIFT * texel_width), 1.0);
    if (clip.w <= 0.0)
        return 1.0;
    ivec2 texel = clamp(ivec2((clip.xy / clip.w * 0.5 + 0.5) * size), ivec2(0), ivec2(size) - 1);
    float stored = v.kind == LIGHT_MAP_FACE
                       ? texelFetch(shadow_maps[LIGHT_MAP_FACE], ivec3(texel, v.layer), 0).r
                       : texelFetch(shadow_maps[LIGHT_MAP_SINGLE], ivec3(texel, v.layer), 0).r;
    return stored <= clip.z / clip.w ? 1.0 : 0.0;
}

// Times irradiance_scale.
vec3 point_irradiance_at(vec3 position, vec3 normal) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count; i++) {
        light l = light_at(i);
        vec3 from_light = position - l.position;
        float distance2 = dot(from_light, from_light);
        vec3 direction = l.type == LIGHT_TYPE_DIRECTIONAL ? l.direction : from_light * inversesqrt(distance2);
        float share = point_irradiance(l, normal, direction, distance2) * light_in_range(l, distance2);
        if (share > 0.0)
            sum += l.radiance * light_slide(l, direction) *
                   medium_passes_light(position, direction, l.type != LIGHT_TYPE_DIRECTIONAL, distance2) *
                   (share * point_seen(light_view_at(light_view_index(l, direction)), position, normal));
    }
    return sum * (3.1415927 * params.irradiance_scale);
}
