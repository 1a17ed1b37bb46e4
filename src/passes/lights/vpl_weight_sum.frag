// Of all VPLs: what they would give, and how many there are that have light.
#include "lib/vpl_texels.glsl"

layout(binding = UNIT_VPL_VALUES) uniform sampler2D values;

layout(location = TARGET_RESULT) out vec4 sum;

void main() {
    sum = vec4(0.0);
    for (int i = 0; i < textureSize(values, 0).x; i++)
        sum += vec4(texelFetch(values, ivec2(i, 0), 0).r, vpl_at(i).reach > 0.0 ? 1.0 : 0.0, 0.0, 0.0);
}
