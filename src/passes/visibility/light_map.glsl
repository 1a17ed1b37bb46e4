// A light's own maps of depth, which filters read: a plane across the axis of the light, so that what is parallel
// to it keeps its shape and a window of the light's shape is a box. A light that shines into a half space sees all of
// it in one map: beyond 45 degrees to either side the plane is drawn together, as a cube's faces around the middle
// one would be, without their seams. A point light has six such maps; each is asked for a sixth of the directions,
// and windows reach beyond.
#include "lib/light.glsl"

struct light_map {
    vec3 origin, right, up, forward; // right and up: of what is not drawn together, from the middle at a depth of 1
    float plain;      // of the map's width, what is not drawn together: 1, or a half
    float unit;       // metres, a depth of 1
    vec2 sides;       // of a rectangle like the light, metres; of a sun tangents
    bool orthographic;
    bool is_sphere;
    int layer;
};

// A square of the area of a round light of that diameter.
const float SQUARE_OF_ROUND = 0.88622693; // sqrt(pi) / 2

vec2 light_sides(light l) {
    if (l.shape == LIGHT_SHAPE_CAP)
        return vec2(2.0 * tan(0.5 * l.width) * SQUARE_OF_ROUND);
    return l.shape == LIGHT_SHAPE_RECTANGLE ? vec2(l.width, l.height) : vec2(l.width * SQUARE_OF_ROUND);
}

// face: of a point light, else 0.
light_map light_map_at(light l, int face) {
    view v = light_view_at(l.first_view + face).view;
    bool aside = l.view_count > 1 && l.type != LIGHT_TYPE_POINT;
    light_map m;
    m.origin = v.origin;
    m.right = aside ? l.right : v.right;
    m.up = aside ? l.up : v.up;
    m.forward = aside ? l.direction : v.forward;
    m.plain = l.view_count > 1 ? 0.5 : 1.0;
    m.unit = l.map_unit;
    m.sides = light_sides(l);
    m.orthographic = v.orthographic;
    m.is_sphere = l.shape == LIGHT_SHAPE_SPHERE;
    m.layer = l.first_map + face;
    return m;
}

// The map that has what lies in that direction.
light_map light_map_towards(light l, vec3 direction) {
    return light_map_at(l, l.type == LIGHT_TYPE_POINT ? light_view_index(l, direction) - l.first_view : 0);
}

// From the plane to the map, whose middle is 0 and whose edges are at 1; and back.
vec2 light_map_place(float plain, vec2 s) {
    vec2 a = abs(s);
    return mix(sign(s) * plain * (2.0 - 1.0 / max(a, 1.0)), s * plain, lessThanEqual(a, vec2(1.0)));
}

vec2 light_map_plane(float plain, vec2 place) {
    vec2 a = abs(place);
    return mix(sign(place) * plain / max(2.0 * plain - a, 1e-6), place / plain, lessThanEqual(a, vec2(plain)));
}
