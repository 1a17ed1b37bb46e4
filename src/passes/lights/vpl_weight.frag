// What VPL i would give to the picture where nothing is between: to pixels that are even over it, others for each VPL.
// Near ones it lights as a disk of its area, so that one next to a pixel is not all there is.
#define CLAMP GATHER_CLAMP_DISK
#include "lib/vpl_texels.glsl"
#include "passes/gather/geometry_term.glsl"
#include "passes/lights/seen_pixel.glsl"

layout(location = TARGET_RESULT) out float value;

const int PIXELS = 64;

void main() {
    int i = int(gl_FragCoord.x);
    vpl v = vpl_at(i);
    vec2 own = fract(float(i) * vec2(0.6180339887, 0.4142135624));
    float sum = 0.0;
    for (int j = 0; j < PIXELS; j++) {
        surface s = seen_pixel(j, own);
        sum += s.present ? light_term(i, v.position - s.position, s.normal, v) : 0.0;
    }
    value = v.reach > 0.0 ? dot(v.flux, vec3(1.0)) * sum : 0.0;
}
