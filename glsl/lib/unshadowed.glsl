// What a surface would get from a light that nothing hides: irradiance per unit of intensity, times
// direct_scale. Exact for rectangles and spheres that shine alike everywhere [Lambert 1760; Lagarde and
// Rousiers 2014]; a disk is its 16-gon of equal area, within 2e-5. Spots with a size get what one in
// their middle would give.
#include "lib/light.glsl"
#include "lib/polygon.glsl"

const int DISK_CORNERS = 16;
// The 16-gon's radius over the disk's, sqrt(x / sin x) with x = 2 pi / 16.
const float DISK_POLYGON = 1.01300156;

float disk_irradiance(vec3 center, vec3 right, vec3 up, vec3 normal) {
    polygon_sum p = polygon_sum(0.0, vec3(0.0), vec3(0.0));
    vec3 last = center + right * DISK_POLYGON;
    for (int i = 1; i <= DISK_CORNERS; i++) {
        float turn = 6.28318531 * float(i) / float(DISK_CORNERS);
        vec3 next = center + (right * cos(turn) + up * sin(turn)) * DISK_POLYGON;
        polygon_edge(p, last, next, normal);
        last = next;
    }
    return polygon_end(p, normal);
}

// (t - atan t) / t^3, also where t is small.
float arc_rest(float t) {
    float q = t * t;
    return q < 0.1 ? 1.0 / 3.0 - q * (1.0 / 5.0 - q * (1.0 / 7.0 - q * (1.0 / 9.0 - q / 11.0)))
                   : (t - atan(t)) / (q * t);
}

// Of a sphere whose radius is s times its distance, with the cosine to its middle, over pi s^2: what a
// point in its middle would give is the cosine.
float sphere_cosine(float cosine, float s) {
    float s2 = s * s;
    if (cosine * cosine > s2 || s2 >= 1.0)
        return max(cosine, 0.0);
    if (cosine <= -s)
        return 0.0;
    float sine = sqrt(1.0 - cosine * cosine), x = sqrt(1.0 / s2 - 1.0), y = -x * cosine / sine;
    // By sine and cosine: acos of drivers errs by up to 3e-4.
    float root = sqrt(max(1.0 - y * y, 0.0)), t = sine * root / x;
    // -x u + atan(u / x) / s2 with u = t x
    float half_seen = t * (1.0 - t * t * arc_rest(t) / s2);
    return max((cosine * atan(root, y) + half_seen) / 3.14159265, 0.0);
}

// Below it the light is as small as a point, m of light per m of distance: the sums above would lose
// their digits.
const float LIGHT_SMALL = 5e-3;

// direction: unit, from the light's middle to the surface.
float point_irradiance(light l, vec3 normal, vec3 direction, float distance2) {
    float share = max(dot(normal, -direction), 0.0);
    if (l.type != LIGHT_TYPE_DIRECTIONAL)
        share *= l.direct_scale / distance2;
    if (l.type == LIGHT_TYPE_SPOT || l.type == LIGHT_TYPE_AREA)
        share *= light_cone(l, dot(direction, l.direction));
    return share;
}

// POINTS_ONLY: no light has a size. A software rasteriser would run all of it all the same.
float unshadowed(light l, vec3 position, vec3 normal, vec3 direction, float distance2) {
#ifdef POINTS_ONLY
    return point_irradiance(l, normal, direction, distance2);
#endif
    float wide = max(l.width, l.height), away = sqrt(distance2);
    if (l.shape == LIGHT_SHAPE_CAP)
        return sphere_cosine(dot(normal, -direction), sin(0.5 * l.width));
    if (l.shape == LIGHT_SHAPE_SPHERE)
        return sphere_cosine(dot(normal, -direction), 0.5 * l.width / away) * l.direct_scale / distance2;
    if (l.type != LIGHT_TYPE_AREA || wide <= LIGHT_SMALL * away)
        return point_irradiance(l, normal, direction, distance2);
    vec3 right = l.right * (0.5 * l.width), center = l.position - position;
    float scale = l.direct_scale / l.extent;
    if (l.shape == LIGHT_SHAPE_RECTANGLE)
        return rectangle_irradiance(center, right, l.up * (0.5 * l.height), normal) * scale;
    return disk_irradiance(center, right, l.up * (0.5 * l.width), normal) * scale;
}
