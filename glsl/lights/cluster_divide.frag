// Sums become means. An empty cluster keeps its centre, or begins again from its seed [Prutkin 2012
// §4]; a mean normal of zero keeps the old one.
#include "lights/val_seed.glsl"

layout(binding = UNIT_VAL_POSITION) uniform sampler2D old_positions;
layout(binding = UNIT_VAL_NORMAL) uniform sampler2D old_normals;
layout(binding = UNIT_SUM_POSITION) uniform sampler2D sum_positions;
layout(binding = UNIT_SUM_NORMAL) uniform sampler2D sum_normals;
layout(binding = UNIT_SUM_FLUX) uniform sampler2D sum_fluxes;

layout(location = TARGET_VAL_POSITION) out vec4 val_position; // w: count
layout(location = TARGET_VAL_NORMAL) out vec4 val_normal;
layout(location = TARGET_VAL_FLUX) out vec4 val_flux;

void main() {
    ivec2 k = ivec2(gl_FragCoord.xy);
    vec4 position = texelFetch(sum_positions, k, 0);
    vec4 normal = texelFetch(sum_normals, k, 0);
    float count = position.w, strength = length(normal.xyz);
    vec3 empty_position = texelFetch(old_positions, k, 0).xyz, empty_normal = texelFetch(old_normals, k, 0).xyz;
    if (count == 0.0 && params.reseed) {
        vpl seed = seed_vpl(k.x);
        empty_position = seed.position;
        empty_normal = seed.normal;
    }
    val_position = vec4(count > 0.0 ? position.xyz / normal.w : empty_position, count);
    val_normal = vec4(strength > 1e-6 * normal.w ? normal.xyz / strength : empty_normal, 0.0);
    val_flux = vec4(texelFetch(sum_fluxes, k, 0).rgb, 0.0);
}
