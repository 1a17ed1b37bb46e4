// What smooth surfaces throw onto this one: radiance of a white surface. A smooth surface itself has there what it shows,
// radiance, and in A 1 and the part of it that is indirect light (passes/caustics/glass.h).
#ifdef HAS_CAUSTICS
layout(binding = UNIT_CAUSTIC) uniform sampler2D caustics;

vec4 smooth_light(ivec2 texel) {
    return texelFetch(caustics, texel, 0);
}
#else
vec4 smooth_light(ivec2 texel) {
    return vec4(0.0);
}
#endif

struct smooth_seen {
    vec3 caustic, direct, indirect; // the last two: what it shows
    float rough;                    // 0: it is smooth, and reflects no other light; else 1
};

smooth_seen smooth_at(ivec2 texel) {
    vec4 light = smooth_light(texel);
    float rough = light.a > 0.0 ? 0.0 : 1.0;
    vec3 shown = (1.0 - rough) * light.rgb;
    return smooth_seen(rough * light.rgb, (2.0 - light.a) * shown, (light.a - 1.0) * shown, rough);
}

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
