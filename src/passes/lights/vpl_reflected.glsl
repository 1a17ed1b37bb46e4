// The VPL of a place of a light's domain: where the light meets a surface there, and the flux reflected [Dong 2009 §4, §6].
#include "lib/light_domain.glsl"
#include "passes/lights/rsm_light.glsl"
#include "lib/vpl_rows.glsl"
#ifdef SKY_RAYS
#include "passes/lights/sky_ray.glsl"
#endif
#ifdef VPL_LOBES
#include "passes/lights/vpl_lobe.glsl"
#endif

// The VPL where the light meets that texel's surface; one without flux where it meets nothing.
vpl vpl_of_texel(light l, float measure, light_view view, ivec2 texel, uvec2 seed) {
    rsm_light lit = rsm_light_at(l, view, texel, seed);
    if (!lit.s.present)
        return vpl_even(l.position, -l.direction, 0.0, vec3(0.0), 0.0);
    vpl v = vpl_even(lit.s.position, lit.s.normal, 0.0, vec3(0.0), 0.0);
    if (lit.cosine <= 0.0)
        return v;
    v.flux = lit.power * measure;
    v.area = measure * lit.distance2 / max(lit.cosine, VPL_COSINE_MIN);
#ifdef VPL_LOBES
    if (!lit.at_pane)
        take_lobe(v, l, view, texel, lit.cosine);
#endif
    return v;
}

// `measure`: what it stands for, of the light's own. `number` tells VPLs apart that have one place.
vpl vpl_reflected(int index, int number, float measure, vec2 place) {
#ifdef SKY_RAYS
    if (has_sky_pieces(index))
        return vpl_by_sky_ray(index, number, measure, place);
#endif
    light l = light_at(index);
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    vec3 direction = l.direction;
    vec2 ndc = place * 2.0 - 1.0;
    light_view view = light_view_at(l.first_view);
    if (!directional) {
        direction = light_domain_direction(l, place);
        view = light_view_at(light_view_index(l, direction));
        vec4 clip = view.view.world_to_clip * vec4(direction, 0.0);
        ndc = clip.xy / clip.w;
    }
    ivec2 size = rsm_size(view.kind);
    ivec2 texel = clamp(ivec2((ndc * 0.5 + 0.5) * vec2(size)), ivec2(0), size - 1);
    return vpl_of_texel(l, measure, view, texel, floatBitsToUint(place) + uint(number));
}
