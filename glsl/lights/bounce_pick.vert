// Point i becomes one of its candidates, by the light that they have and could reflect, so that VPLs are where light
// is: importance resampling [Talbot et al. 2005]. The chosen one stands for all of them: its area is divided by the
// probability of the choice. Half of the choice is by area alone, for what only later bounces light.
//
// The number that chooses belongs to the point: as light moves, few choices change from frame to frame. The
// candidates of all points come in the same order of the surfaces, and the numbers are even, so that choices are.
#include "lib/vpl_texels.glsl" // the candidates: flux is their albedo
#include "lib/vpl_output.glsl"
#include "shared/bounce.h"

layout(binding = UNIT_IRRADIANCE) uniform sampler2D irradiances; // point x candidate

const float BY_AREA = 0.5;

// Even, and not as Halton's sequence is, which placed the candidates: multiples of the golden ratio.
float choice(int i) {
    return float(uint(i) * 2654435769u >> 8) / 16777216.0;
}

void main() {
    int first = gl_VertexID * BOUNCE_CANDIDATES;
    float weights[BOUNCE_CANDIDATES], areas[BOUNCE_CANDIDATES];
    float all = 0.0, area = 0.0;
    for (int i = 0; i < BOUNCE_CANDIDATES; i++) {
        vpl candidate = vpl_at(first + i);
        vec3 irradiance = texelFetch(irradiances, ivec2(gl_VertexID, i), 0).rgb;
        weights[i] = dot(candidate.flux * irradiance, vec3(1.0)) * candidate.area;
        areas[i] = candidate.area;
        all += weights[i];
        area += areas[i];
    }
    float by_light = all > 0.0 ? (1.0 - BY_AREA) / all : 0.0;
    float by_area = area > 0.0 ? (all > 0.0 ? BY_AREA : 1.0) / area : 0.0;
    float left = choice(gl_VertexID), probability = 1.0;
    int chosen = -1;
    for (int i = 0; i < BOUNCE_CANDIDATES; i++) {
        float share = weights[i] * by_light + areas[i] * by_area;
        if (share > 0.0 && left >= 0.0) {
            chosen = i;
            probability = share;
        }
        left -= share;
    }
    vpl v = vpl_at(first + max(chosen, 0));
    v.area /= probability;
    vpl_output(v);
}
