// Real spherical harmonics up to order 3, in three parts: l <= 1, the first four of l = 2, and the last one
// [Ramamoorthi and Hanrahan 2001].
vec4 sh_low(vec3 d) {
    return vec4(0.2820948, 0.4886025 * d.yzx);
}

vec4 sh_high(vec3 d) {
    return vec4(1.0925484 * d.x * d.y, 1.0925484 * d.y * d.z, 0.3153916 * (3.0 * d.z * d.z - 1.0), 1.0925484 * d.x * d.z);
}

float sh_last(vec3 d) {
    return 0.5462742 * (d.x * d.x - d.y * d.y);
}

// Irradiance of a surface of that normal by radiance of coefficients c: the sum of c times these.
vec4 sh_cosine_low(vec3 normal) {
    return sh_low(normal) * vec4(3.1415927, vec3(2.0943951));
}

vec4 sh_cosine_high(vec3 normal) {
    return sh_high(normal) * 0.7853982;
}

float sh_cosine_last(vec3 normal) {
    return sh_last(normal) * 0.7853982;
}
