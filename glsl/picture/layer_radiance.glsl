// What smooth surfaces throw onto this one: radiance of a white surface.
#ifdef HAS_CAUSTICS
layout(binding = UNIT_CAUSTIC) uniform sampler2D caustics;

vec3 caustic_at(ivec2 texel) {
    return texelFetch(caustics, texel, 0).rgb;
}
#else
vec3 caustic_at(ivec2 texel) {
    return vec3(0.0);
}
#endif

// The radiance of a surface beside its diffuse part.
#ifdef HAS_SPECULAR
layout(binding = UNIT_DIRECT_SPECULAR) uniform sampler2D direct_speculars;

vec3 direct_specular(ivec2 texel) {
    return texelFetch(direct_speculars, texel, 0).rgb;
}
#else
vec3 direct_specular(ivec2 texel) {
    return vec3(0.0);
}
#endif

// Not of light that comes straight from a source.
#ifdef HAS_RADIANCE
layout(binding = UNIT_RADIANCE) uniform sampler2D radiances;

vec3 indirect_specular(ivec2 texel) {
    return params.scale * texelFetch(radiances, texel, 0).rgb;
}
#else
vec3 indirect_specular(ivec2 texel) {
    return vec3(0.0);
}
#endif

#ifdef HAS_EMISSION
layout(binding = UNIT_GBUFFER_EMISSION) uniform sampler2DArray emissions;

vec3 emitted(ivec2 texel) {
    return params.scale * texelFetch(emissions, ivec3(texel, 0), 0).rgb;
}
#else
vec3 emitted(ivec2 texel) {
    return vec3(0.0);
}
#endif
