// The light of a whole cluster, as a rectangle that shines alike everywhere.
#include "lib/polygon.glsl"
#include "passes/gather/vpl_terms.glsl"
#include "shared/gather.h"

const bool TERM_OF_POINT = false;
const bool WITHOUT_NEAR_FIELD = CLAMP == GATHER_CLAMP_RECTANGLE_NEAR;

layout(std140, binding = BLOCK_LIGHT_RECTANGLES) uniform rectangle_uniforms {
    vec4 rectangle_rows[LIGHT_RECTANGLES_MAX * LIGHT_RECTANGLE_ROWS];
};

// A rectangle of this squared half diagonal over its squared distance is as good as four points, within 1e-3: the polygon costs
// four times as much, and would lose its digits.
const float SMALL2 = 0.01;

// Points along either side where the near field leaves only a part of the rectangle.
const int NEAR_SIDE = 4;

struct rectangle {
    vec3 middle, right, up; // from the receiver; half sides
};

rectangle rectangle_at(int i, vec3 to_light) {
    int row = i * LIGHT_RECTANGLE_ROWS;
    return rectangle(to_light, rectangle_rows[row].xyz, rectangle_rows[row + 1].xyz);
}

// Of one of side x side points, each for its part of the rectangle.
vec3 rectangle_point(rectangle r, int side, int k) {
    vec2 place = (vec2(k % side, k / side) + 0.5) * (2.0 / float(side)) - 1.0;
    return r.middle + place.x * r.right + place.y * r.up;
}

float cosines_of(vec3 to_point, vec3 normal, vec3 light_normal) {
    return max(dot(normal, to_point), 0.0) * max(-dot(light_normal, to_point), 0.0);
}

float few_points(rectangle r, vec3 normal, vpl light) {
    float sum = 0.0;
    for (int k = 0; k < 4; k++) {
        vec3 to_point = rectangle_point(r, 2, k);
        float distance2 = dot(to_point, to_point);
        sum += cosines_of(to_point, normal, light.normal) / (distance2 * distance2);
    }
    return 0.25 * sum;
}

float far_points(rectangle r, vec3 normal, vpl light) {
    float sum = 0.0;
    for (int k = 0; k < NEAR_SIDE * NEAR_SIDE; k++) {
        vec3 to_point = rectangle_point(r, NEAR_SIDE, k);
        float distance2 = dot(to_point, to_point), far = 1.0 - near_share(distance2, light.area, light.reach);
        sum += cosines_of(to_point, normal, light.normal) * far / max(distance2 * distance2, 1e-30);
    }
    return sum / float(NEAR_SIDE * NEAR_SIDE);
}

// Whether some of the rectangle is within the near field.
bool is_near(rectangle r, vpl light) {
    vec2 half_sides2 = max(vec2(dot(r.right, r.right), dot(r.up, r.up)), 1e-30);
    vec2 foot = clamp(-vec2(dot(r.middle, r.right), dot(r.middle, r.up)) / half_sides2, -1.0, 1.0);
    vec3 nearest = r.middle + foot.x * r.right + foot.y * r.up;
    return dot(nearest, nearest) < light.reach * light.reach * light.area;
}

// Whether the receiver is before the rectangle, and some of that above its horizon.
bool is_seen(rectangle r, vec3 normal, vpl light) {
    float above = dot(normal, r.middle) + abs(dot(normal, r.right)) + abs(dot(normal, r.up));
    return above > 0.0 && dot(light.normal, r.middle) < 0.0;
}

// In the place of a point's cos cos / d^2.
float light_term(int i, vec3 to_light, vec3 normal, vpl light) {
    rectangle r = rectangle_at(i, to_light);
    float term = 0.0, diagonal2 = dot(r.right, r.right) + dot(r.up, r.up);
    bool seen = is_seen(r, normal, light), small = diagonal2 < SMALL2 * dot(to_light, to_light);
    bool near = WITHOUT_NEAR_FIELD && is_near(r, light);
    if (seen && near)
        term = far_points(r, normal, light);
    if (seen && small && !near)
        term = few_points(r, normal, light);
    if (seen && !small && !near)
        term = rectangle_irradiance(r.middle, r.up, r.right, normal) / light.area; // facing us: right is left
    return term;
}
