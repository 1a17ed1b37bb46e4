// The specular part of glTF's metallic-roughness model, the same as reference/brdf.c.
#include "shared/brdf.h"

// A surface towards the eye.
struct shine {
    vec3 f0, f90;  // reflectance from straight on and grazing; 0 of a matt surface
    float alpha;   // roughness^2
    vec3 normal, to_eye;
};

// Grazing and hidden views, which normal maps make, are seen as BRDF_LEAST_COSINE.
vec3 facing(vec3 normal, vec3 to_eye) {
    float cosine = dot(normal, to_eye);
    return cosine >= BRDF_LEAST_COSINE ? to_eye : normalize(to_eye + normal * (BRDF_LEAST_COSINE - cosine));
}

float smith_root(float alpha, float cosine) {
    return sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

// 1/sr, times the cosine of the light; 0 from below the horizon.
vec3 specular_brdf(shine s, vec3 to_light) {
    float n_l = dot(s.normal, to_light);
    if (n_l <= 0.0)
        return vec3(0.0);
    vec3 h = normalize(s.to_eye + to_light);
    // 1 - (n.h)^2 would lose its digits on smooth surfaces.
    vec3 aside = cross(s.normal, h);
    float n_h = dot(s.normal, h), n_v = dot(s.normal, s.to_eye);
    float across = dot(aside, aside) / s.alpha + n_h * n_h * s.alpha;
    float visibility = 0.5 / (n_v * smith_root(s.alpha, n_l) + n_l * smith_root(s.alpha, n_v));
    float rest = max(1.0 - dot(s.to_eye, h), 0.0);
    float w = rest * rest * rest * rest * rest;
    return mix(s.f0, s.f90, w) * (n_l * visibility / (3.14159265358979 * across * across));
}
