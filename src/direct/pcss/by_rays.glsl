// The share of a light that is free, by shadow rays to points of it wherever its map has something in front.
#include "visibility/bvh.glsl"

const int FIRST_RAYS = WAYS < 16 ? WAYS : 16; // where they agree there are no more

bool is_hidden(surface at, vec3 toward, bool asks) {
    float clearance = bvh_clearance();
    vec3 way = IS_SUN ? toward : toward - clearance * normalize(toward);
    return bvh_meets_any(bvh_ray_along(at.position + clearance * at.normal, way, IS_SUN ? BVH_FAR : 1.0), asks);
}

// Of the points that the receiver faces.
float free_share(surface at, light l, shape s, place x, casters c, float texel_width) {
    float free = 0.0, faced = 0.0;
    int first = l.width > 0.0 ? FIRST_RAYS : 1, count = c.any ? first : 0;
    for (int i = 0; i < count; i++) {
        vec3 toward = on_way(s, x, shape_point(s, i), 1.0) - x.position;
        bool faces = dot(toward, x.normal) > 0.0;
        free += faces && !is_hidden(at, toward, faces) ? 1.0 : 0.0;
        faced += faces ? 1.0 : 0.0;
        count = i + 1 == FIRST_RAYS && free > 0.0 && free < faced ? WAYS : count;
    }
    return count > 0 ? free / max(faced, 1.0) : 1.0;
}
