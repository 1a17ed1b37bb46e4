// Light of a VPL that is no point: of a patch, of a ball, and outside its near field.

// Light of patches that VPLs of later bounces stand for: cos cos / d^2, bounded over a wide radius, as pixels would show
// single patches as blobs.
//
// Of the light at a distance a patch sends there g(d^2 / a^2), a^2 = 6.5 A:
//     g(t) = 1 - (1 - b t - c t^2) / (1 + t^2)^2,  c = (pi - 6) / (pi - 2),  b = 3 - c.
// With these b and c the integral of g - 1 over t is 0: the inside of a sphere gains nothing. The integral over sqrt(t) is 0,
// too: two walls gain nothing. What lies about a radius away gets what is nearer loses.
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

// A VPL's light spread over a ball of radius r around it, as a diffuse surface receives it [Hašan et al. 2009]: in
// place of cos cos / d^2 its mean over the cone in which the ball is seen,
//     1 / (pi r^2)  int (n . l)+ (m . l)+ dl,  m = -n of the VPL.
// Exact while the cone is above both horizons; within the ball the cone is the whole sphere, and that is exact.
float sphere_term(vec3 to_vpl, vec3 normal, vec3 vpl_normal, float radius2) {
    const float PI = 3.14159265358979;
    vec3 towards = -vpl_normal;
    float distance2 = dot(to_vpl, to_vpl), facing = dot(normal, towards);
    if (distance2 <= radius2) {
        float angle = acos(clamp(facing, -1.0, 1.0));
        return 2.0 / 3.0 * ((PI - angle) * facing + sin(angle)) / (PI * radius2);
    }
    vec3 w = to_vpl * inversesqrt(distance2);
    float sine2 = radius2 / distance2, c = sqrt(1.0 - sine2), rest = sine2 / (1.0 + c); // 1 - c
    float aside = rest * rest * (2.0 + c) / 3.0, along = 2.0 / 3.0 * rest * (1.0 + c + c * c);
    return max(aside * facing + (along - aside) * dot(normal, w) * dot(towards, w), 0.0) / radius2;
}

// Of the squared distance over that where the near field ends.
float near_share_at(float far) {
    far = min(far, 1.0);
    return (1.0 - far) * (1.0 - far);
}

// How much of the light from a surface point at this distance is the near field's: 1 at the point, 0
// from `reach` times the spacing of VPLs on. VPLs give the rest, so that their light stays bounded:
// G (1 - near) <= 2 cos cos / (reach^2 area).
float near_share(float distance2, float area, float reach) {
    return near_share_at(distance2 / (reach * reach * area));
}
