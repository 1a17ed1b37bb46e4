// The most that cos_i cos_x / d^2 can be, bounded as the gather's CLAMP says, between the points of a box with a cone
// of normals and VPLs in another [Walter et al. 2005, §4; 2006]. Of two points and normals it is the term itself.
#include "lib/direction.glsl"
#include "lib/vpl_tree.glsl"
#include "passes/gather/vpl_terms.glsl"
#include "shared/gather.h"

const float CUT_INVERSE_PI = 0.31830988618;

// Bounds are wider by so much than rounding makes them narrower.
const float CUT_ROUNDING = 1e-5;

// The least and the greatest of dot(direction, v) over a box of v.
vec2 project(vec3 direction, vec3 low, vec3 high) {
    vec3 a = direction * low, b = direction * high;
    return vec2(dot(min(a, b), vec3(1.0)), dot(max(a, b), vec3(1.0)));
}

float least_square(vec2 interval) {
    float nearest = max(max(interval.x, -interval.y), 0.0);
    return nearest * nearest;
}

float greatest_square(vec2 interval) {
    return max(interval.x * interval.x, interval.y * interval.y);
}

// The greatest cosine between a direction of the cone and a vector of the box.
float greatest_cosine(vec3 axis, float cosine, vec3 low, vec3 high) {
    vec3 right = perpendicular(axis);
    vec2 z = project(axis, low, high), x = project(right, low, high), y = project(cross(axis, right), low, high);
    float along = z.y + CUT_ROUNDING * (z.y - z.x);
    float across2 = along >= 0.0 ? least_square(x) + least_square(y) : greatest_square(x) + greatest_square(y);
    float distance = sqrt(across2 + along * along);
    float found = distance > 0.0 ? min(along / distance + CUT_ROUNDING, 1.0) : 1.0;
    if (found >= cosine)
        return 1.0;
    return max(found * cosine + sqrt((1.0 - found * found) * (1.0 - cosine * cosine)), 0.0);
}

// Of the squared distance, the area of a VPL and the squared reach of its near field.
float greatest_share(float distance2, float area, float near2) {
#if CLAMP == GATHER_CLAMP_NONE || CLAMP == GATHER_CLAMP_VALUE
    return 1.0 / max(distance2, 1e-30);
#elif CLAMP == GATHER_CLAMP_DISK || CLAMP == GATHER_CLAMP_SPHERE
    return 1.0 / max(distance2 + area * CUT_INVERSE_PI, 1e-30);
#elif CLAMP == GATHER_CLAMP_PATCH
    return patch_most(distance2, area);
#else
    // What the near field leaves is (2 - q) / near2 with q = d^2 / near2.
    return distance2 < near2 ? (2.0 - distance2 / near2) / near2 : 1.0 / max(distance2, 1e-30);
#endif
}

float cut_bound(tree_extent receiver, tree_node node, float clamp_at) {
    vec3 low = node.extent.low - receiver.high, high = node.extent.high - receiver.low;
    vec3 nearest = max(max(low, -high), 0.0);
    float cosines = greatest_cosine(receiver.axis, receiver.cosine, low, high) *
                    greatest_cosine(node.extent.axis, node.extent.cosine, -high, -low);
    float most = cosines * greatest_share(dot(nearest, nearest), node.area, node.near2);
#if CLAMP == GATHER_CLAMP_VALUE
    most = min(most, clamp_at);
#endif
    return most;
}
