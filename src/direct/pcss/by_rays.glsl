// The share of a light that is free, by shadow rays to points of it wherever its map has something in front.
#include "passes/visibility/bvh.glsl"

// First of all go to the light's rim, where shadows begin and end, and halfway to it: where they agree there are no more.
const int FIRST_RAYS = SHADOW_RAYS < 16 ? SHADOW_RAYS : 16;

vec2 first_point(shape s, int i) {
    float turn = 6.28318531 * float(i) / float(FIRST_RAYS);
    vec2 p = vec2(cos(turn), sin(turn));
    return (i % 2 == 0 ? 1.0 : 0.5) * (s.is_round ? p : p / max(abs(p.x), abs(p.y)));
}

// Where rays begin: a little towards the camera, since rasterisers round corners of triangles to parts of a pixel. A
// pixel's centre may lie that far past an edge, behind the wall beside, where all light would be hidden.
vec3 before_surface(surface at) {
    const float ROUNDED = 1.0 / 128.0; // of a pixel
    float pixel = view_height(camera, gbuffer_depth(ivec2(gl_FragCoord.xy))) / float(gbuffer_size().y);
    vec3 direction = normalize(camera.orthographic ? camera.forward : at.position - camera.origin);
    return at.position - direction * (ROUNDED * pixel / max(-dot(direction, at.normal), 0.1));
}

bool is_hidden(vec3 origin, vec3 way, bool asks) {
    return bvh_meets_any(bvh_ray_along(origin, way, IS_SUN ? BVH_FAR : 1.0 - bvh_clearance() / length(way)), asks);
}

// Adds what a point of the light gives if it is free, and if all are.
void ask(light l, vec3 origin, shape s, place x, vec2 point, inout vec2 free_of_all) {
    vec3 end = on_way(s, x, point, 1.0), toward = end - x.position;
    float away2 = dot(toward, toward), faces = max(dot(toward, x.normal), 0.0);
    float gives = IS_SUN ? faces : faces * abs(dot(toward, s.front)) / (away2 * away2);
    bool asks = gives > 0.0;
    bool hidden = is_hidden(origin, IS_SUN ? toward : l.position + end - origin, asks);
    free_of_all += asks ? vec2(hidden ? 0.0 : gives, gives) : vec2(0.0);
}

float free_share(surface at, light l, shape s, place x, casters c, float texel_width) {
    vec2 first = vec2(0.0), all = vec2(0.0);
    vec3 origin = before_surface(at) + bvh_clearance() * at.normal;
    int first_count = l.width > 0.0 ? FIRST_RAYS : 1;
    for (int i = 0; i < (c.any ? first_count : 0); i++)
        ask(l, origin, s, x, first_point(s, i), first);
    bool differ = first.x > 0.0 && first.x < first.y;
    for (int i = 0; i < (differ ? SHADOW_RAYS : 0); i++)
        ask(l, origin, s, x, shape_point(s, i), all);
    first = differ ? all : first;
    return c.any ? (first.y > 0.0 ? first.x / first.y : 0.0) : 1.0;
}
