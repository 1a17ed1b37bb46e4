// The reflective shadow map: what each texel of the light's views sees.
#include "lib/light.glsl"
#include "lib/surface.glsl"

layout(binding = UNIT_RSM_DEPTH) uniform sampler2DArray rsm_depths;
layout(binding = UNIT_RSM_NORMAL) uniform sampler2DArray rsm_normals;
layout(binding = UNIT_RSM_ALBEDO) uniform sampler2DArray rsm_albedos;

surface rsm_surface(ivec3 texel) {
    return surface_fetch(light.views[texel.z], rsm_depths, rsm_normals, texel);
}

vec3 rsm_albedo(ivec3 texel) {
    return albedo_fetch(rsm_albedos, texel);
}
