// What a surface that is not diffuse would reflect, besides its diffuse part, of a light that nothing hides: radiance
// over l.radiance. Points are exact, areas are by linearly transformed cosines; spheres and suns are the disks that
// look as large.
#include "lib/lobe.glsl"
#include "lib/unshadowed.glsl"

// Seen from the lobe, light as small as a point is as in unshadowed().
bool is_point(lobe o, float wide, float away) {
    return wide <= LIGHT_SMALL * min(2.0 * o.alpha, 1.0) * away;
}

vec3 specular_of_point(light l, specular_surface s, vec3 direction, float distance2) {
    vec3 brdf = 3.14159265 * specular_brdf(s, -direction);
    if (l.type == LIGHT_TYPE_DIRECTIONAL)
        return brdf;
    float cone = l.type == LIGHT_TYPE_POINT ? 1.0 : light_cone(l, dot(direction, l.direction));
    return brdf * (cone * l.direct_scale / distance2);
}

// A disk that faces the surface.
float facing_disk(lobe o, vec3 center, float radius) {
    vec3 right = perpendicular(normalize(center)), up = cross(normalize(center), right);
    return disk_irradiance(o.from_world * center, o.from_world * right * radius, o.from_world * up * radius,
                           vec3(0.0, 0.0, 1.0));
}

vec3 unshadowed_specular(light l, specular_surface s, vec3 position, vec3 direction, float distance2) {
#ifdef POINTS_ONLY
    return specular_of_point(l, s, direction, distance2);
#endif
    const vec3 Z = vec3(0.0, 0.0, 1.0);
    const float PI = 3.14159265;
    lobe o = lobe_of(s);
    float away = sqrt(distance2), radius = 0.5 * l.width;
    if (l.shape == LIGHT_SHAPE_CAP && !is_point(o, l.width, 1.0)) {
        float sine = sin(radius);
        return o.albedo * (facing_disk(o, -direction, tan(radius)) / (PI * sine * sine));
    }
    if (l.shape == LIGHT_SHAPE_SPHERE && !is_point(o, l.width, away)) {
        float sine = min(radius / away, 0.99), wide = away * sine * inversesqrt(1.0 - sine * sine);
        return o.albedo * (facing_disk(o, -direction * away, wide) * l.direct_scale / (PI * radius * radius));
    }
    if (l.type != LIGHT_TYPE_AREA || is_point(o, max(l.width, l.height), away))
        return specular_of_point(l, s, direction, distance2);
    vec3 center = o.from_world * (l.position - position), right = o.from_world * (l.right * radius);
    vec3 scale = o.albedo * (l.direct_scale / l.extent);
    if (l.shape == LIGHT_SHAPE_RECTANGLE)
        return rectangle_irradiance(center, right, o.from_world * (l.up * (0.5 * l.height)), Z) * scale;
    return disk_irradiance(center, right, o.from_world * (l.up * radius), Z) * scale;
}
