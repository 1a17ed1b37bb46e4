// Light of patches that VPLs of later bounces stand for: cos cos / d^2, bounded over a wide radius, as pixels would show
// single patches as blobs.

// Of the light at a distance a patch sends there g(d^2 / a^2), a^2 = 6.5 A:
//     g(t) = 1 - (1 - b t - c t^2) / (1 + t^2)^2,  c = (pi - 6) / (pi - 2),  b = 3 - c,
// as b and c make the integral of g - 1 over t nothing, which is what the inside of a sphere gains, and that over
// sqrt(t), which is what two walls gain: what lies about a radius away gets what is nearer loses.
const float PATCH_SPREAD = 6.5;

float patch_share(float distance2, float area) {
    const float B = 5.50387, C = -2.50387;
    float t = distance2 / (PATCH_SPREAD * area), bound = 1.0 + t * t;
    return t * (B + t * (2.0 + C + t * t)) / (bound * bound);
}

// scaled_cosines: times d each.
float patch_term(float scaled_cosines, float distance2, float area) {
    return scaled_cosines * patch_share(distance2, area) / (distance2 * distance2);
}

// The most of such a term without its cosines, from that distance on, for that area and all larger ones: over the
// squared distance the share falls with the distance; by itself it rises to its peak as areas grow smaller, and falls then.
float patch_most(float distance2, float area) {
    const float PEAK = 0.602 * PATCH_SPREAD;
    float away2 = max(distance2, 1e-6 * area);
    return patch_share(min(away2, PEAK * area), area) / away2;
}
