// The reflective shadow map: what each texel of the lights' views sees.
#include "lib/light.glsl"
#include "lib/surface.glsl"

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
