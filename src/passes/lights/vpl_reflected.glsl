// The VPL of a place of a light's domain: where the light meets a surface there, and the flux reflected [Dong 2009 §4, §6].
#include "lib/light_domain.glsl"
#include "lib/rsm.glsl"
#include "lib/vpl_rows.glsl"
#include "passes/lights/vpl_lobe.glsl"
#ifdef SKY_RAYS
#include "lib/random.glsl"
#include "passes/visibility/bvh.glsl"
#include "passes/lights/light_end.glsl"
#include "passes/lights/sky_pieces.glsl"

// Multiples of the golden ratio are even however few there are, and unlike the numbers of places.
int sky_piece_of(int number) {
    return int(uint(number) * LATTICE_GOLDEN >> SKY_PIECE_SHIFT);
}

// The VPL of a sky's light sample: what a ray meets from one of its many directions. One direction for all its VPLs would be
// luck where its light comes through a window.
vpl vpl_by_sky_ray(int index, int number, float measure, vec2 place) {
    int piece = sky_piece_of(number);
    vec4 origin = sky_piece_row(index, piece, 0);
    vec4 right = sky_piece_row(index, piece, 1), up = sky_piece_row(index, piece, 2);
    vec2 at = 2.0 * fract(place + vec2(right.w, up.w)) - 1.0;
    vec3 from = origin.xyz + at.x * right.xyz + at.y * up.xyz;
    vec3 direction = normalize(cross(up.xyz, right.xyz));
    vec3 albedo, arrives;
    vec4 specular;
    float away;
    surface s = light_end(from, direction, floatBitsToUint(place) + uint(number), albedo, specular, arrives, away);
    if (!s.present)
        return vpl_even(from, -direction, 0.0, vec3(0.0), 0.0);
    float area = origin.w * measure, cosine = dot(s.normal, -direction);
    vec3 power = sky_piece_row(index, piece, 3).xyz * area * arrives;
    vpl v = vpl_even(s.position, s.normal, area / max(cosine, VPL_COSINE_MIN), albedo * power, 0.0);
    take_lobe(v, specular, albedo, -direction, cosine, 0.0);
    return v;
}
#endif
#ifdef HAS_SAMPLED
#include "passes/lights/vpl_sampled.glsl"
#endif
#ifdef VPL_LOBES
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

void take_map_lobe(inout vpl v, light l, light_view view, ivec2 texel, float cosine) {
    vec3 to_light = l.type == LIGHT_TYPE_DIRECTIONAL ? -l.direction : normalize(l.position - v.position);
    take_lobe(v, rsm_specular(view, texel), rsm_albedo(view, texel), to_light, cosine,
              patch_bend(v, view, texel));
}
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
        take_map_lobe(v, l, view, texel, lit.cosine);
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
#ifdef HAS_SAMPLED
    if (l.type == LIGHT_TYPE_MANY)
        return vpl_by_sampled_light(l, number, measure, place);
#endif
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
