// The VPL of a place of a light's domain: where the light meets a surface there, and the flux reflected [Dong 2009 §4, §6].
#include "lib/light_domain.glsl"
#include "lib/medium.glsl"
#include "lib/rsm.glsl"
#include "shared/vpl.h"
#ifdef SKY_RAYS
#include "lights/sky_ray.glsl"
#endif

// The VPL where the light meets that texel's surface; one without flux where it meets nothing.
vpl vpl_of_texel(light l, float measure, light_view view, ivec2 texel, vec3 direction) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    surface s = rsm_surface(view, texel);
    if (!s.present)
        return vpl(l.position, 0.0, -direction, 0.0, vec3(0.0), 0.0);
    vpl v = vpl(s.position, 0.0, s.normal, 0.0, vec3(0.0), 0.0);
    vec3 from_light = s.position - l.position;
    float distance2 = dot(from_light, from_light);
    vec3 incoming = directional ? direction : from_light * inversesqrt(distance2);
    float cosine = dot(s.normal, -incoming);
    if (cosine <= 0.0)
        return v;
    vec3 power = directional ? l.intensity : light_intensity(l, incoming) * light_in_range(l, distance2);
    v.flux = rsm_albedo(view, texel) * power * measure;
    v.flux *= medium_passes_light(s.position, incoming, !directional, distance2);
    v.area = measure * (directional ? 1.0 : distance2) / max(cosine, VPL_COSINE_MIN);
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
    return vpl_of_texel(l, measure, view, texel, direction);
}
