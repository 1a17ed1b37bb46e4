// What VPL i would give to the picture where nothing is between: to pixels that are even over it, others for each VPL.
// Near ones it lights as a disk of its area, so that one next to a pixel is not all there is.
#include "lib/gbuffer.glsl"
#include "lib/vpl_texels.glsl"
#include "shared/vpl_weight.h"

layout(location = TARGET_RESULT) out float value;

const float INVERSE_PI = 0.31830988618;

float geometry_term(vpl v, surface s) {
    vec3 apart = v.position - s.position;
    float distance2 = dot(apart, apart);
    float cosines = max(dot(s.normal, apart), 0.0) * max(-dot(v.normal, apart), 0.0);
    return cosines / max(distance2 * (distance2 + v.area * INVERSE_PI), 1e-30);
}

void main() {
    int i = int(gl_FragCoord.x);
    vpl v = vpl_at(i);
    vec2 size = vec2(gbuffer_size()), own = fract(float(i) * vec2(0.6180339887, 0.4142135624));
    float sum = 0.0;
    for (int j = 0; j < VPL_WEIGHT_POINTS; j++) {
        vec2 place = fract((float(j) + 0.5) * vec2(0.7548776662, 0.5698402910) + own);
        surface s = gbuffer_surface(min(ivec2(place * size), ivec2(size) - 1));
        sum += s.present ? geometry_term(v, s) : 0.0;
    }
    value = v.reach > 0.0 ? dot(v.flux, vec3(1.0)) * sum : 0.0;
}
