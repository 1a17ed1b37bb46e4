// How much VPL i counts where VPLs are clustered: by what it would give to the picture, and a little for all, as what is
// between is not asked and what is hardly seen needs a cluster, too.
#include "lib/vpl_rows.glsl"

layout(binding = UNIT_VPL_VALUES) uniform sampler2D vpl_values;
layout(binding = UNIT_VPL_VALUE_SUM) uniform sampler2D vpl_value_sum; // and how many VPLs have light

float vpl_weight(int i, vpl v) {
    const float FOR_ALL = 0.1, LEAST = 1e-30; // of the mean; where the picture shows nothing
    vec2 sum = texelFetch(vpl_value_sum, ivec2(0), 0).rg;
    float mean = sum.r / max(sum.g, 1.0);
    float weight = mix(texelFetch(vpl_values, ivec2(i, 0), 0).r, mean, FOR_ALL) + LEAST;
    return v.reach > 0.0 ? weight : 0.0;
}
