// The rows of the matrix of pixels x VPLs: fragment (i, j) is the light that pixel j has of VPL i, as the gather takes it,
// where the pixel's map sees the VPL.
#include "shared/gather.h"

PASS_BLOCK(gather_params, 64)

#include "lib/vpl_texels.glsl"
#include "passes/gather/geometry_term.glsl"
#include "passes/visibility/visibility.glsl"

// The columns of the VPLs begin at x, those of the maps' pixels at y.
layout(location = LOCATION_SLOT) uniform ivec4 first;

layout(location = TARGET_RESULT) out vec4 light;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) - first.xy;
    vpl v = vpl_at(texel.x);
    map_view pixel = map_view_at(texel.y);
    vec3 arriving = v.flux * light_term(texel.x, v.position - pixel.center, pixel.axis, v);
    float visible = 1.0;
    for (int lit = arriving != vec3(0.0) ? 1 : 0; lit > 0; lit--)
        visible = visibility(texel.y, v.position, v.normal);
    light = vec4(arriving * visible, 0.0);
}
