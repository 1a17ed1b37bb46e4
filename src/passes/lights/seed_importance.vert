// VPL i lands on its cell of its light's domain with what it would give to the picture where nothing is between
// [Prutkin 2012 §4; Ritschel et al. 2011]: its flux times the sum of bounded geometry terms with pixels that are even
// over the picture. With NUMBERS it lands there with its number.
#include "lib/vpl_texels.glsl"
#include "shared/seed_importance.h"

#if !NUMBERS
#include "lib/gbuffer.glsl"
#endif

layout(location = ATTRIBUTE_VPL_POINT) in vec3 place_and_light;

flat out vec4 value;

#if NUMBERS
float value_of(vpl v) {
    return float(gl_VertexID + 1);
}
#else
float geometry_term(vpl v, surface s) {
    vec3 apart = v.position - s.position;
    float distance2 = dot(apart, apart);
    float cosines = max(dot(s.normal, apart), 0.0) * max(-dot(v.normal, apart), 0.0);
    return min(cosines / max(distance2 * distance2, 1e-30), params.clamp_at);
}

float value_of(vpl v) {
    float sum = 0.0;
    for (int j = 0; j < SEED_IMPORTANCE_PIXELS; j++) {
        surface s = seen_pixel(j, vec2(0.0));
        sum += s.present ? geometry_term(v, s) : 0.0;
    }
    return length(v.flux) * sum;
}
#endif

void main() {
    vpl v = vpl_at(gl_VertexID);
    vec2 cell = floor(place_and_light.xy * float(SEED_IMPORTANCE_SIDE)) + 0.5;
    value = vec4(v.reach > 0.0 ? value_of(v) : 0.0);
    gl_Position = v.reach > 0.0 ? vec4(cell * (2.0 / float(SEED_IMPORTANCE_SIDE)) - 1.0, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
