// A picture of linear radiance as the composite shows its own.
#include "lib/display.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    composite_params params;
};
layout(binding = UNIT_RADIANCE) uniform sampler2D radiance;

layout(location = TARGET_RESULT) out vec4 color;

void main() {
    vec3 value = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
    color = vec4(display(value, params.exposure, params.tone_map), 1.0);
}
