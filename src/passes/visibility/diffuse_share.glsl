// The part of a light from a direction that a surface reflects diffusely. Where it shines from below the horizon, at the
// horizon.
float diffuse_share(specular_surface seen, vec3 direction) {
    float f0 = max(seen.f0.r, max(seen.f0.g, seen.f0.b)), cosine = max(-dot(seen.normal, direction), BRDF_LEAST_COSINE);
    return let_through(f0, seen.f90.r, seen.alpha, cosine);
}
