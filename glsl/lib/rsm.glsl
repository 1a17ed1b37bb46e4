// The reflective shadow map: what each texel of the lights' views sees, and reflects of the light.
#include "lib/light.glsl"
#include "lib/brdf.glsl"
#include "lib/medium.glsl"

layout(binding = UNIT_RSM_DEPTH) uniform sampler2DArray rsm_depths[LIGHT_MAP_KINDS];
layout(binding = UNIT_RSM_NORMAL) uniform sampler2DArray rsm_normals[LIGHT_MAP_KINDS];
layout(binding = UNIT_RSM_ALBEDO) uniform sampler2DArray rsm_albedos[LIGHT_MAP_KINDS];

// Of the kind's maps, texels.
ivec2 rsm_size(int kind) {
    return kind == LIGHT_MAP_FACE ? textureSize(rsm_depths[LIGHT_MAP_FACE], 0).xy
                                  : textureSize(rsm_depths[LIGHT_MAP_SINGLE], 0).xy;
}

surface rsm_surface(light_view v, ivec2 texel) {
    ivec3 place = ivec3(texel, v.layer);
    if (v.kind == LIGHT_MAP_FACE)
        return surface_fetch(v.view, rsm_depths[LIGHT_MAP_FACE], rsm_normals[LIGHT_MAP_FACE], place);
    return surface_fetch(v.view, rsm_depths[LIGHT_MAP_SINGLE], rsm_normals[LIGHT_MAP_SINGLE], place);
}

// As they are stored.
float rsm_depth(light_view v, ivec2 texel) {
    ivec3 place = ivec3(texel, v.layer);
    return v.kind == LIGHT_MAP_FACE ? texelFetch(rsm_depths[LIGHT_MAP_FACE], place, 0).r
                                    : texelFetch(rsm_depths[LIGHT_MAP_SINGLE], place, 0).r;
}

vec2 rsm_normal_code(light_view v, ivec2 texel) {
    ivec3 place = ivec3(texel, v.layer);
    return v.kind == LIGHT_MAP_FACE ? texelFetch(rsm_normals[LIGHT_MAP_FACE], place, 0).rg
                                    : texelFetch(rsm_normals[LIGHT_MAP_SINGLE], place, 0).rg;
}

vec3 rsm_albedo(light_view v, ivec2 texel) {
    ivec3 place = ivec3(texel, v.layer);
    return v.kind == LIGHT_MAP_FACE ? albedo_fetch(rsm_albedos[LIGHT_MAP_FACE], place)
                                    : albedo_fetch(rsm_albedos[LIGHT_MAP_SINGLE], place);
}

// How the surfaces of the reflective shadow map mirror light.
layout(binding = UNIT_RSM_SPECULAR) uniform sampler2DArray rsm_speculars[LIGHT_MAP_KINDS];

// Returns the stored code.
vec4 rsm_specular(light_view v, ivec2 texel) {
    ivec3 place = ivec3(texel, v.layer);
    return v.kind == LIGHT_MAP_FACE ? texelFetch(rsm_speculars[LIGHT_MAP_FACE], place, 0)
                                    : texelFetch(rsm_speculars[LIGHT_MAP_SINGLE], place, 0);
}

// What a light sends where a texel of its view sees a surface, or by chance to a pane before it.
struct rsm_light {
    surface s;
    vec3 power; // reflected, per solid angle, or per area of a directional light
    float cosine, distance2; // distance2 1: a directional light
    bool at_pane;
};

rsm_light rsm_light_at(light l, light_view view, ivec2 texel, uvec2 seed) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    surface s = rsm_surface(view, texel);
    vec3 seen = s.position, albedo = rsm_albedo(view, texel);
    vec3 direction = directional ? l.direction : normalize(s.position - l.position);
    vec3 arrives = medium_sends(l.position, direction, !directional, seed, s, albedo), from_light = s.position - l.position;
    float distance2 = directional ? 1.0 : dot(from_light, from_light);
    vec3 power = directional ? l.intensity : light_intensity(l, direction) * light_in_range(l, distance2);
    return rsm_light(s, albedo * power * arrives, -dot(s.normal, direction), distance2, s.position != seen);
}
