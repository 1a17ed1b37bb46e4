// The lobe by which a VPL mirrors its light, as the light's map has the surface.
#include "lib/lobe_albedo.glsl"
#include "lib/octahedral.glsl"
#include "lib/rsm_specular.glsl"

void take_lobe(inout vpl v, light l, light_view view, ivec2 texel, float cosine) {
    vec4 code = rsm_specular(view, texel), specular = specular_decode(code);
    float grazing = max(cosine, BRDF_LEAST_COSINE);
    v.alpha = specular_alpha(specular.a);
    v.to_light = octahedral_encode(l.type == LIGHT_TYPE_DIRECTIONAL ? -l.direction : normalize(l.position - v.position));
    vec3 mirrored = specular_albedo(specular.rgb, specular_grazing(code), v.alpha, grazing);
    float share = dot(mirrored, vec3(1.0)) / max(dot(rsm_albedo(view, texel), vec3(1.0)), 1e-6);
    v.lobe = uintBitsToFloat(packHalf2x16(vec2(min(share, 1.0), lobe_albedo(v.alpha, grazing).x)));
}
