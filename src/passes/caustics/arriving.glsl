// A share of the flux of a ray at its end. The shader has included lib/light.glsl, lib/medium.glsl and
// passes/caustics/rays.glsl.
layout(location = LOCATION_LIGHT) uniform int light_index;

vec3 arriving(ivec2 texel, vec4 end, float share) {
    vec4 flux = texelFetch(ray_fluxes, texel, 0);
    float metres = distance(texelFetch(ray_leaves, texel, 0).xyz, end.xyz), way = flux.w + metres;
    return share * flux.rgb * light_in_range(light_at(light_index), way * way) * medium_passes(metres);
}
