// What VPL i would give to the picture where nothing is between: to pixels that are even over it, others for each VPL.
// Near ones it lights as a disk of its area, so that one next to a pixel is not all there is. SUM: what all would give, and
// how many VPLs have light.
#define CLAMP GATHER_CLAMP_DISK
#include "lib/vpl_texels.glsl"
#include "passes/gather/geometry_term.glsl"
#include "lib/gbuffer.glsl"

#ifdef SUM
layout(binding = UNIT_VPL_VALUES) uniform sampler2D values;

layout(location = TARGET_RESULT) out vec4 sum;

void main() {
    sum = vec4(0.0);
    for (int i = 0; i < textureSize(values, 0).x; i++)
        sum += vec4(texelFetch(values, ivec2(i, 0), 0).r, vpl_at(i).reach > 0.0 ? 1.0 : 0.0, 0.0, 0.0);
}
#else
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
#endif
