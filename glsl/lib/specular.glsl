// How the G-buffer keeps the specular part of reflection: the reflectance from straight on in rgb, as its square root; in
// a the roughness in 256 steps, and in 256 steps of these the reflectance grazing. All is 0 where a surface is diffuse.

#include "shared/brdf.h"

const float SPECULAR_STEPS = 255.0, SPECULAR_CODES = 65535.0;

// specular: the reflectance from straight on, and the roughness.
vec4 specular_encode(vec4 specular, float f90) {
    vec2 steps = round(SPECULAR_STEPS * clamp(vec2(specular.a, f90), 0.0, 1.0));
    return vec4(sqrt(clamp(specular.rgb, 0.0, 1.0)), (256.0 * steps.x + steps.y) / SPECULAR_CODES);
}

vec4 specular_decode(vec4 code) {
    return vec4(code.rgb * code.rgb, floor((SPECULAR_CODES * code.a + 0.5) / 256.0) / SPECULAR_STEPS);
}

vec3 specular_grazing(vec4 code) {
    return vec3(mod(floor(SPECULAR_CODES * code.a + 0.5), 256.0) / SPECULAR_STEPS);
}

float specular_alpha(float roughness) {
    float clamped = max(roughness, BRDF_LEAST_ROUGHNESS);
    return clamped * clamped;
}

// What is as smooth shows images, which a blur would take.
bool is_smooth(float alpha) {
    return alpha < 0.0625; // roughness^2
}
