// How the surfaces of the reflective shadow map mirror light.
#include "lib/rsm.glsl"
#include "lib/specular.glsl"

layout(binding = UNIT_RSM_SPECULAR) uniform sampler2DArray rsm_speculars[LIGHT_MAP_KINDS];

// As it is stored.
vec4 rsm_specular(light_view v, ivec2 texel) {
    ivec3 place = ivec3(texel, v.layer);
    return v.kind == LIGHT_MAP_FACE ? texelFetch(rsm_speculars[LIGHT_MAP_FACE], place, 0)
                                    : texelFetch(rsm_speculars[LIGHT_MAP_SINGLE], place, 0);
}
