// Light of patches that points of further bounces stand for: cos cos / d^2, bounded nearby so that nothing is lost on the
// whole, as what lies about a radius away gets more.
//
// scaled_cosines: times d each.

// Between points: cos cos (d^2 + a^2) / (d^4 + a^4), a^2 = A / pi, which loses nothing where two walls meet and is never
// above 1.2 of what there is. Inside a sphere P points exchange 1 - atan(P) / P + ln(1 + P^2) / (2 P) of their light.
float patch_term(float scaled_cosines, float distance2, float area) {
    float radius2 = area * 0.31830988618;
    return scaled_cosines * (1.0 + radius2 / distance2) / (distance2 * distance2 + radius2 * radius2);
}

// At pixels, which would show single patches as blobs: over a wider radius, a^2 = 6.5 A, cos cos / d^2 g(d^2 / a^2),
//     g(t) = 1 - (1 - b t - c t^2) / (1 + t^2)^2,  c = (pi - 6) / (pi - 2),  b = 3 - c,
// as b and c make the integral of g - 1 over t nothing, which is what the inside of a sphere gains, and that over
// sqrt(t), which is what two walls gain. It reaches 1.8, so that between points light could grow.
float patch_term_at_pixel(float scaled_cosines, float distance2, float area) {
    const float B = 5.50387, C = -2.50387, SPREAD = 6.5;
    float t = distance2 / (SPREAD * area), bound = 1.0 + t * t;
    float g = t * (B + t * (2.0 + C + t * t));
    return scaled_cosines * g / (bound * bound * distance2 * distance2);
}
