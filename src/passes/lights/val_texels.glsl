// The VALs, for passes/lights/val_distance.glsl.
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
