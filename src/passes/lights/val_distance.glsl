// The clustering criterion, of lengths [Dong 2009 §5.1] or of squares [Prutkin 2012, eq. 1]:
//     d = w_x |x - c| + w_alpha angle(n, m)
//     d = w_d |x - c|^2 + w_n (1 - n m) + w_Phi |Phi / |Phi| - Phi_c / |Phi_c||^2
// Distances are taken over the spread of the VPLs, so that neither units nor what no light reaches count. VALS_AS_IMAGES:
// the including file has val_position, val_normal and val_flux of a number.
#include "shared/cluster.h"
#include "shared/vpl.h"
#include "lib/vpl_sums.glsl"

#ifndef VALS_AS_IMAGES
layout(binding = UNIT_VAL_POSITION) uniform sampler2D val_positions; // xyz, count
layout(binding = UNIT_VAL_NORMAL) uniform sampler2D val_normals;

vec3 val_position(int k) {
    return texelFetch(val_positions, ivec2(k, 0), 0).xyz;
}

vec3 val_normal(int k) {
    return texelFetch(val_normals, ivec2(k, 0), 0).xyz;
}

#if METRIC == CLUSTER_METRIC_SQUARES
layout(binding = UNIT_VAL_FLUX) uniform sampler2D val_fluxes;

vec3 val_flux(int k) {
    return texelFetch(val_fluxes, ivec2(k, 0), 0).rgb;
}
#endif
#endif

// 1/m.
float position_weight() {
    return params.weight_position / vpl_spread();
}

float val_distance(float weight_position, vpl v, int k) {
    vec3 center = val_position(k), mean = val_normal(k);
#if METRIC == CLUSTER_METRIC_SQUARES
    vec3 flux = val_flux(k);
    vec3 apart = weight_position * (v.position - center);
    vec3 hues_apart = v.flux / max(length(v.flux), 1e-30) - flux / max(length(flux), 1e-30);
    return dot(apart, apart) + params.weight_normal * (1.0 - dot(v.normal, mean)) +
           params.weight_flux * dot(hues_apart, hues_apart);
#else
    // acos of a float near 1 is right to 4e-4 alone.
    float angle = atan(max(length(cross(v.normal, mean)), 1e-20), dot(v.normal, mean));
    return weight_position * distance(v.position, center) + params.weight_normal * angle;
#endif
}

// Distances that differ by less are equal: how a driver rounds shall choose no VAL.
const float EQUAL = 1e-5;

// The VAL with the least distance; the first of equals.
int nearest_val(vpl v) {
    int nearest = 0;
    float least = 1e30, weight_position = position_weight();
    for (int k = 0; k < params.val_count; k++) {
        float d = max(val_distance(weight_position, v, k), 0.0); // cosines round above 1
        if (d < least * (1.0 - EQUAL)) {
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
