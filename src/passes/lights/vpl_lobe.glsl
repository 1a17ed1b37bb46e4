// The lobe by which a VPL mirrors its light. VPLs emit evenly without VPL_LOBES.
#ifdef VPL_LOBES
#include "lib/lobe_albedo.glsl"
#include "lib/direction.glsl"
#include "lib/brdf.glsl"

// specular: as in lib/brdf.glsl, a part of `albedo`; cosine: of the unit direction to the light; bend: how much the VPL's
// patch bends.
void take_lobe(inout vpl v, vec4 specular, vec3 albedo, vec3 to_light, float cosine, float bend) {
    float grazing = max(cosine, BRDF_LEAST_COSINE);
    vec4 decoded = specular_decode(specular);
    float alpha = specular_alpha(decoded.a);
    v.alpha = min(sqrt(alpha * alpha + bend), 1.0);
    v.to_light = octahedral_encode(to_light);
    vec3 mirrored = specular_albedo(decoded.rgb, specular_grazing(specular), alpha, grazing);
    float share = dot(mirrored, vec3(1.0)) / max(dot(albedo, vec3(1.0)), 1e-6);
    v.lobe = uintBitsToFloat(packHalf2x16(vec2(min(share, 1.0), lobe_albedo(v.alpha, grazing).x)));
}
#else
void take_lobe(inout vpl v, vec4 specular, vec3 albedo, vec3 to_light, float cosine, float bend) {
}
#endif
