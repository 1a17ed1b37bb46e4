// The directional albedo of the specular lobe: the same as scene/lobe_albedo.c.
#include "shared/brdf.h"

layout(binding = UNIT_LOBE_ALBEDOS) uniform sampler2D lobe_albedos;

// Of a lobe that reflects all, and of one that reflects (1 - v.h)^5.
vec2 lobe_albedo(float alpha, float cosine) {
    vec2 place = (pow(max(vec2(cosine, alpha), vec2(1e-6)), vec2(1.0 / 3.0)) - BRDF_ALBEDO_FIRST) /
                 (1.0 - BRDF_ALBEDO_FIRST);
    place = (clamp(place, 0.0, 1.0) * float(BRDF_ALBEDO_SIZE - 1) + 0.5) / float(BRDF_ALBEDO_SIZE);
    return textureLod(lobe_albedos, place, 0.0).xy;
}

vec3 specular_albedo(vec3 f0, vec3 f90, float alpha, float cosine) {
    vec2 all = lobe_albedo(alpha, cosine);
    return f0 * all.x + (f90 - f0) * all.y;
}

// The share of light that comes through the interface to the diffuse part, over its mean: f0, f90 and the cosine's. f0
// above a dielectric's is a metal's part, and counts as a dielectric's: the share hardly depends on it.
float let_through(float f0, float f90, float alpha, float cosine) {
    float outer = min(f0, BRDF_DIELECTRIC_F0), roughness = sqrt(alpha);
    float mean = outer * BRDF_MEAN_LOBE(roughness) + (f90 - outer) * BRDF_MEAN_GRAZING(roughness);
    vec2 all = lobe_albedo(alpha, cosine);
    return (1.0 - outer * all.x - (f90 - outer) * all.y) / (1.0 - mean);
}
