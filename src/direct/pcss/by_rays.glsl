// The share of a light that is free, by shadow rays to points of it wherever its map has something in front.
#include "visibility/bvh.glsl"

// First of all go to the light's rim, where shadows begin and end, and halfway to it: where they agree there are no more.
const int FIRST_RAYS = WAYS < 16 ? WAYS : 16;

vec2 first_point(shape s, int i) {
    float turn = 6.28318531 * float(i) / float(FIRST_RAYS);
    vec2 p = vec2(cos(turn), sin(turn));
    return (i % 2 == 0 ? 1.0 : 0.5) * (s.is_round ? p : p / max(abs(p.x), abs(p.y)));
}

bool is_hidden(surface at, vec3 toward, bool asks) {
    float clearance = bvh_clearance();
    vec3 way = IS_SUN ? toward : toward - clearance * normalize(toward);
    return bvh_meets_any(bvh_ray_along(at.position + clearance * at.normal, way, IS_SUN ? BVH_FAR : 1.0), asks);
}

// Counts a ray to a point that the receiver faces.
void ask(surface at, shape s, place x, vec2 point, inout vec2 free_of_faced) {
    vec3 toward = on_way(s, x, point, 1.0) - x.position;
    bool faces = dot(toward, x.normal) > 0.0;
    free_of_faced += faces ? vec2(is_hidden(at, toward, faces) ? 0.0 : 1.0, 1.0) : vec2(0.0);
}

float free_share(surface at, light l, shape s, place x, casters c, float texel_width) {
    vec2 first = vec2(0.0), all = vec2(0.0);
    int first_count = l.width > 0.0 ? FIRST_RAYS : 1;
    for (int i = 0; i < (c.any ? first_count : 0); i++)
        ask(at, s, x, first_point(s, i), first);
    bool differ = first.x > 0.0 && first.x < first.y;
    for (int i = 0; i < (differ ? WAYS : 0); i++)
        ask(at, s, x, shape_point(s, i), all);
    first = differ ? all : first;
    return c.any ? first.x / max(first.y, 1.0) : 1.0;
}
