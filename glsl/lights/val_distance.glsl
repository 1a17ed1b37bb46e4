// The clustering criterion [Dong 2009 §5.1]: d = w_x |x - c| + w_alpha angle(n, m). Distances are taken over
// the spread of the VPLs, so that neither units nor what no light reaches count.
#include "shared/cluster.h"
#include "lib/vpl_spread.glsl"

layout(binding = UNIT_VAL_POSITION) uniform sampler2D val_positions; // xyz, count
layout(binding = UNIT_VAL_NORMAL) uniform sampler2D val_normals;

// 1/m.
float position_weight() {
    return params.weight_position / vpl_spread();
}

float val_distance(float weight_position, vec3 position, vec3 normal, vec3 center, vec3 mean) {
    float angle = acos(clamp(dot(normal, mean), -1.0, 1.0));
    return weight_position * distance(position, center) + params.weight_normal * angle;
}

// The VAL with the least distance; the first of equals.
int nearest_val(vec3 position, vec3 normal) {
    int nearest = 0;
    float least = 1e30, weight_position = position_weight();
    for (int k = 0; k < params.val_count; k++) {
        vec3 center = texelFetch(val_positions, ivec2(k, 0), 0).xyz;
        vec3 mean = texelFetch(val_normals, ivec2(k, 0), 0).xyz;
        float d = val_distance(weight_position, position, normal, center, mean);
        if (d < least) {
            least = d;
            nearest = k;
        }
    }
    return nearest;
}

// The pixel of VAL k in a target of one row.
vec4 val_pixel(int k) {
    return vec4((float(k) + 0.5) / float(params.val_count) * 2.0 - 1.0, 0.0, 0.0, 1.0);
}
