#include "techniques/implicit-visibility/triangle.h"

#include <math.h>

struct triangle triangle_of(const vec3s corners[3]) {
    struct triangle triangle;
    for (int e = 0; e < 3; e++) {
        triangle.corners[e] = corners[e];
        triangle.across[e] = glms_vec3_cross(corners[e], corners[(e + 1) % 3]);
    }
    triangle.normal = glms_vec3_cross(glms_vec3_sub(corners[1], corners[0]),
                                      glms_vec3_sub(corners[2], corners[0]));
    triangle.along = glms_vec3_dot(corners[0], triangle.normal);
    return triangle;
}

float triangle_distance(const struct triangle *triangle, vec3s ray) {
    const float sign = triangle->along < 0 ? -1 : 1;
    for (int e = 0; e < 3; e++)
        if (!(sign * glms_vec3_dot(ray, triangle->across[e]) >= 0))
            return INFINITY;
    float distance = triangle->along / glms_vec3_dot(ray, triangle->normal);
    return distance > 0 ? distance : INFINITY;
}

/* Between the places of a face's plane at distance 1. */
struct bounds {
    float low[2], high[2];
};

static void extend(struct bounds *bounds, int axis, vec3s at, float depth) {
    for (int c = 0; c < 2; c++) {
        float place = at.raw[(axis + 1 + c) % 3] / depth;
        bounds->low[c] = fminf(bounds->low[c], place);
        bounds->high[c] = fmaxf(bounds->high[c], place);
    }
}

/* The part of the triangle before the face counts. */
bool triangle_window(const struct triangle *triangle, const struct bins *bins, int face,
                     struct bins_window *window) {
    const int axis = face / 2;
    const float sign = face % 2 ? -1 : 1;
    struct bounds bounds = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    float depths[3], largest = 0;
    for (int v = 0; v < 3; v++) {
        depths[v] = sign * triangle->corners[v].raw[axis];
        largest = fmaxf(largest, depths[v]);
    }
    const float nearest = 1e-4F * largest;
    if (!(largest > 0))
        return false;
    for (int v = 0; v < 3; v++) {
        const int next = (v + 1) % 3;
        if (depths[v] >= nearest)
            extend(&bounds, axis, triangle->corners[v], depths[v]);
        if ((depths[v] < nearest) == (depths[next] < nearest))
            continue;
        float cut = (nearest - depths[v]) / (depths[next] - depths[v]);
        vec3s at = glms_vec3_lerp(triangle->corners[v], triangle->corners[next], cut);
        extend(&bounds, axis, at, nearest);
    }
    return bins_window_between(bins, bounds.low, bounds.high, window);
}
