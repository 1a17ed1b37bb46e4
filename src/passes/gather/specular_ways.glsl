// Ways by which a pixel reflects light: what the camera sees has its direct light, VPLs and rays find the rest.
#include "lib/gbuffer_specular.glsl"

// The camera sees a surface where it lies within so many pixels of the pixel's plane, and faces alike.
const float SEEN_PIXELS = 3.0;
const float SEEN_COSINE = 0.5;
// Surfaces that reflect more than this as a mirror does send other light elsewhere.
const float SEEN_F0_MAX = 0.25;

bool camera_sees(vec3 position, vec3 normal, out ivec2 pixel) {
    bool inside = view_shows(camera, position, gbuffer_size(), pixel);
    surface seen = gbuffer_surface(pixel);
    float wide = view_height(camera, gbuffer_depth(pixel)) / float(gbuffer_size().y);
    vec3 f0 = specular_decode(texelFetch(gbuffer_speculars, ivec3(pixel, 0), 0)).rgb;
    return inside && seen.present && dot(seen.normal, normal) > SEEN_COSINE &&
           distance(seen.position, position) < SEEN_PIXELS * wide &&
           max(f0.r, max(f0.g, f0.b)) < SEEN_F0_MAX;
}

// Two ways find light that y reflects to x: VPLs, and rays that x samples by its lobe. Each counts by the power
// heuristic [Veach 1997, §9.2.4] of how densely it places its samples around y. Of smooth surfaces rays find it
// all: VPLs would be seen as spots.
struct specular_densities {
    float vpls, rays; // at y, 1/m2
};

// cosine: at y, towards x; area: what one of the VPLs that x has stands for there.
specular_densities specular_densities_at(specular_surface x, vec3 direction, float cosine, float distance2, float rays,
                                         float area) {
    return specular_densities(is_smooth(x.alpha) ? 0.0 : 1.0 / area,
                              rays * lobe_density(x, direction) * cosine / distance2);
}

float specular_weight(float own, float other) {
    float ratio = other / max(own, 1e-30);
    return own > 0.0 ? 1.0 / (1.0 + min(ratio * ratio, 1e30)) : 0.0;
}

// The part of rays and visibility tests that a receiver takes: what reflects little adds little noise.
float specular_effort(specular_surface x) {
    float rest = max(1.0 - dot(x.normal, x.to_eye), 0.0), f0 = max(x.f0.r, max(x.f0.g, x.f0.b));
    return f0 + (x.f90.r - f0) * rest * rest * rest * rest * rest < 0.1 ? 0.5 : 1.0;
}
