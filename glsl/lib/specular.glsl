// How the G-buffer keeps the specular part of reflection: the reflectance from straight on in rgb, the roughness in a;
// all 0 where a surface is diffuse. Reflectance is stored as its square root, so that eight bits serve dark ones too.

#include "shared/brdf.h"

vec4 specular_encode(vec4 specular) {
    return vec4(sqrt(clamp(specular.rgb, 0.0, 1.0)), specular.a);
}

vec4 specular_decode(vec4 code) {
    return vec4(code.rgb * code.rgb, code.a);
}

// What is as smooth shows images, which a blur would take.
bool is_smooth(float alpha) {
    return alpha < 0.0625; // roughness^2
}

// The share of a lamp's light, which does not graze much, that the specular part reflects, all together: VPLs send it
// evenly.
vec3 evenly_reflected(vec4 specular) {
    return specular.rgb * BRDF_MEAN_LOBE(specular.a);
}
