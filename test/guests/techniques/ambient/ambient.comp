#include "shared/bindings.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = UNIT_GBUFFER_DEPTH) uniform sampler2DArray depths;
layout(rgba16f, binding = 0) writeonly uniform image2D irradiance;
layout(location = 0) uniform float level;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool present = texelFetch(depths, ivec3(pixel, 0), 0).r > 0.0;
    imageStore(irradiance, pixel, vec4(present ? level : 0.0));
}
