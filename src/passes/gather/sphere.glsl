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
