// Direct light of sampled lights, exact and blurred, and of all others.
#include "shared/sampled_light.h"

PASS_BLOCK(sampled_direct_params, 32)

layout(binding = UNIT_IRRADIANCE) uniform sampler2D irradiance;
layout(binding = UNIT_DIRECT) uniform sampler2D direct;
layout(binding = UNIT_EXACT) uniform sampler2D exact;

layout(location = TARGET_RESULT) out vec4 sum;
#ifdef HAS_SPECULAR
layout(binding = UNIT_RADIANCE) uniform sampler2D radiance;
layout(binding = UNIT_DIRECT_SPECULAR) uniform sampler2D direct_specular;
layout(binding = UNIT_EXACT_SPECULAR) uniform sampler2D exact_specular;

layout(location = TARGET_DIRECT_SPECULAR) out vec4 specular;
#endif

void main() {
    const float INVERSE_PI = 0.31830988618;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    sum = texelFetch(direct, pixel, 0) + texelFetch(exact, pixel, 0);
    sum.rgb += texelFetch(irradiance, pixel, 0).rgb * (INVERSE_PI / params.scale);
#ifdef HAS_SPECULAR
    specular = texelFetch(direct_specular, pixel, 0) + texelFetch(exact_specular, pixel, 0);
    specular.rgb += texelFetch(radiance, pixel, 0).rgb / params.scale;
#endif
}
