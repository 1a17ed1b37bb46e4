// The lights of a sky. Rows are read one by one: few need all of them.
#include "lib/unshadowed.glsl"
#include "shared/sky.h"

layout(std140, binding = BLOCK_SKY) uniform sky_uniforms {
    vec4 sky_rows[ENVIRONMENT_LIGHTS_MAX * SKY_ROWS];
};

vec3 sky_corner(int i, int corner) {
    return sky_rows[i * SKY_ROWS + corner].xyz;
}

// And its luminance.
vec4 sky_radiance(int i) {
    return sky_rows[i * SKY_ROWS + 4];
}

// Irradiance over radiance, as a vector.
vec3 sky_vector(int i) {
    return sky_rows[i * SKY_ROWS + 5].xyz;
}

// Unit: to its middle.
vec3 sky_direction(int i) {
    return sky_rows[i * SKY_ROWS + 6].xyz;
}

// The direction to a point of it, not of unit length.
vec3 sky_towards(int i, vec2 point) {
    int row = i * SKY_ROWS;
    return sky_rows[row + 6].xyz + point.x * sky_rows[row + 7].xyz + point.y * sky_rows[row + 8].xyz;
}

// Irradiance over radiance of a light that nothing hides, exact: the vector's where all is above the
// horizon, and Lambert's sum where the horizon cuts it.
float sky_irradiance(int i, vec3 normal) {
    vec4 above;
    for (int c = 0; c < 4; c++)
        above[c] = dot(sky_corner(i, c), normal);
    float least = min(min(above.x, above.y), min(above.z, above.w));
    float most = max(max(above.x, above.y), max(above.z, above.w));
    float share = most > 0.0 ? max(dot(sky_vector(i), normal), 0.0) : 0.0;
    if (least < 0.0 && most > 0.0) {
        polygon_sum p = polygon_sum(0.0, vec3(0.0), vec3(0.0));
        for (int c = 0; c < 4; c++)
            polygon_edge(p, sky_corner(i, c), sky_corner(i, (c + 1) & 3), normal);
        share = polygon_end(p, normal);
    }
    return share;
}
