// What each texel of the reflective shadow map reflects, for the near field: once for the texel, not for
// each of the many samples that meet it.
#include "gather/near_light.glsl"
#include "lib/medium.glsl"
#include "lib/rsm.glsl"
#include "lib/vpl_shares.glsl"
#include "shared/near_field.h"
#include "shared/vpl.h"
#include VPL_AREA

layout(location = LOCATION_FIRST_VIEW) uniform int first_view; // of this kind
flat in int instance;

layout(location = TARGET_RESULT) out uvec4 packed_light;

// Solid angle per unit of ndc area, but for the view's own spread; an area does not depend on the ray.
float ndc_measure(view v, float cosine) {
    return v.orthographic ? 1.0 : cosine * cosine * cosine;
}

void main() {
    packed_light = uvec4(0u);
    light_view v = light_view_at(first_view + instance);
    light l = light_at(v.light);
    ivec2 texel = ivec2(gl_FragCoord.xy);
    surface s = rsm_surface(v, texel);
    if (!s.present)
        return;
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    vec3 from_light = s.position - l.position;
    vec3 direction = directional ? v.view.forward : normalize(from_light);
    float cosine = dot(s.normal, -direction);
    float distance2 = directional ? 1.0 : dot(from_light, from_light);
    float by_flux = vpl_share_at(v.light).measure * distance2 / max(cosine, VPL_COSINE_MIN);
    float area = vpl_area_at(by_flux, v.light, l, s.position);
    vec3 power = directional ? l.intensity : light_intensity(l, direction) * light_in_range(l, distance2);
    power *= rsm_albedo(v, texel) * (cosine > 0.0 ? params.power_scale : 0.0);
    power *= medium_passes_light(s.position, direction, !directional, distance2);
    power *= ndc_measure(v.view, dot(from_light, v.view.forward) * inversesqrt(dot(from_light, from_light)));
    float z = view_linear_depth(v.view, rsm_depth(v, texel));
    packed_light = near_light_pack(near_light(z, rsm_normal_code(v, texel), power, sqrt(area) * params.inverse_radius));
}
