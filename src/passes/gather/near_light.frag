// What each texel of the reflective shadow map reflects, for the near field: once for the texel, not for
// each of the many samples that meet it.
#include "lib/vpl_shares.glsl"
#include "lib/light_domain.glsl"
#include "passes/gather/near_light.glsl"
#include "lib/rsm.glsl"
#include "shared/gather.h"
#include "shared/vpl.h"

PASS_BLOCK(near_field_params, 48)

#include "passes/lights/vpl_density.glsl"

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
    rsm_light lit = rsm_light_at(l, v, texel, uvec2(texel) + first_view);
    surface s = lit.s;
    if (!s.present)
        return;
    float by_flux = vpl_share_at(v.light).measure * lit.distance2 / max(lit.cosine, VPL_COSINE_MIN);
    float area = vpl_area_at(by_flux, v.light, light_domain_place(l, s.position));
    vec3 from_light = s.position - l.position, power = lit.power * (lit.cosine > 0.0 ? params.power_scale : 0.0);
    power *= ndc_measure(v.view, dot(from_light, v.view.forward) * inversesqrt(dot(from_light, from_light)));
    float z = dot(s.position - v.view.origin, v.view.forward);
    z = lit.at_pane ? z : view_linear_depth(v.view, rsm_depth(v, texel));
    vec2 normal_code = lit.at_pane ? octahedral_encode(s.normal) : rsm_normal_code(v, texel);
    packed_light = near_light_pack(near_light(z, normal_code, power, sqrt(area) * params.inverse_radius));
}
