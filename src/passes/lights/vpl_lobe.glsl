// The lobe by which a VPL mirrors its light, as the light's map has the surface.
#include "lib/lobe_albedo.glsl"
#include "lib/octahedral.glsl"
#include "lib/rsm_specular.glsl"

float bend_towards(vpl v, light_view view, ivec2 texel) {
    return surface_bend(v.normal, rsm_surface(view, clamp(texel, ivec2(0), rsm_size(view.kind) - 1)));
}

// How much the patch that the VPL stands for bends. Along each axis the side that differs less counts: across an edge
// lies another surface.
float patch_bend(vpl v, light_view view, ivec2 texel) {
    int size = rsm_size(view.kind).x;
    float depth = view.view.orthographic ? 1.0 : dot(v.position - view.view.origin, view.view.forward);
    float reach = 0.5 * sqrt(v.area) * float(size) / (2.0 * length(view.view.right) * depth);
    ivec2 right = ivec2(int(clamp(reach, 1.0, 0.125 * float(size))), 0), up = right.yx;
    float across = min(bend_towards(v, view, texel - right), bend_towards(v, view, texel + right));
    float along = min(bend_towards(v, view, texel - up), bend_towards(v, view, texel + up));
    return across + along;
}

void take_lobe(inout vpl v, light l, light_view view, ivec2 texel, float cosine) {
    vec4 code = rsm_specular(view, texel), specular = specular_decode(code);
    float grazing = max(cosine, BRDF_LEAST_COSINE);
    float alpha = specular_alpha(specular.a);
    v.alpha = min(sqrt(alpha * alpha + patch_bend(v, view, texel)), 1.0);
    v.to_light = octahedral_encode(l.type == LIGHT_TYPE_DIRECTIONAL ? -l.direction : normalize(l.position - v.position));
    vec3 mirrored = specular_albedo(specular.rgb, specular_grazing(code), alpha, grazing);
    float share = dot(mirrored, vec3(1.0)) / max(dot(rsm_albedo(view, texel), vec3(1.0)), 1e-6);
    v.lobe = uintBitsToFloat(packHalf2x16(vec2(min(share, 1.0), lobe_albedo(v.alpha, grazing).x)));
}
