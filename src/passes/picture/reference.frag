// A picture of linear radiance as the composite shows its own.
#include "passes/picture/display.glsl"
#include "shared/composite.h"

layout(binding = UNIT_RADIANCE) uniform sampler2D radiance;

layout(location = TARGET_RESULT) out vec4 color;

void main() {
    vec3 value = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
    color = vec4(display(value, params.exposure, params.filmic), 1.0);
}
