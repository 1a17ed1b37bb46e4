// The specular part of glTF's metallic-roughness model, the same as reference/brdf.c, and its code in G-buffers.
#include "lib/direction.glsl"
#include "shared/brdf.h"

// A surface towards the eye.
struct specular_surface {
    vec3 f0, f90;  // reflectance from straight on and grazing; 0 of a diffuse surface
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
vec3 specular_brdf(specular_surface s, vec3 to_light) {
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

// --- directions sampled by the lobe -------------------------------------------------------------

// The direction with its part across the normal squeezed.
vec3 squeeze(vec3 normal, vec3 direction, float alpha) {
    float along = max(dot(normal, direction), 0.0);
    return normalize(normal * ((1.0 - alpha) * along) + direction * alpha);
}

// Where one of the microfacets' normals that the eye sees mirrors it [Heitz 2018]; may lie below the horizon.
vec3 lobe_sample(specular_surface s, vec2 place) {
    vec3 seen_from = squeeze(s.normal, s.to_eye, s.alpha), right = cross(s.normal, seen_from);
    right = dot(right, right) > 0.0 ? normalize(right) : perpendicular(s.normal);
    vec3 up = cross(seen_from, right);
    float radius = sqrt(place.x), turn = 6.28318530718 * place.y, x = radius * cos(turn);
    float y = mix(sqrt(max(1.0 - x * x, 0.0)), radius * sin(turn), 0.5 * (1.0 + dot(s.normal, seen_from)));
    vec3 h = right * x + up * y + seen_from * sqrt(max(1.0 - x * x - y * y, 0.0));
    h = squeeze(s.normal, h, s.alpha);
    return normalize(2.0 * dot(s.to_eye, h) * h - s.to_eye);
}

// Its density, 1/sr.
float lobe_density(specular_surface s, vec3 to_light) {
    vec3 h = normalize(s.to_eye + to_light), aside = cross(s.normal, h);
    float n_h = dot(s.normal, h), n_v = dot(s.normal, s.to_eye);
    float across = dot(aside, aside) / s.alpha + n_h * n_h * s.alpha;
    return 0.5 / (3.14159265358979 * across * across * (n_v + smith_root(s.alpha, n_v)));
}

// --- code ---------------------------------------------------------------------------------------

// A texel keeps the specular part of reflection: the reflectance from straight on in rgb, as its square root; in
// a the roughness in 256 steps, and in 256 steps of these the reflectance grazing. All is 0 where a surface is diffuse.
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
