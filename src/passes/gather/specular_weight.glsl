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
