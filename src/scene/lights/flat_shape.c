#include "scene/lights/flat_shape.h"

#include <cglm/cglm.h>
#include <math.h>
#include <string.h>

/* How far a shape may be from what it is taken for, of its size or area. */
static const double tolerance = 1e-3;

/* Of an octagon's area, that of the circle around it. */
static const double octagon_share = .9003;

typedef double dvec3[3];

static void difference(const float *a, const double *b, dvec3 out) {
    for (int c = 0; c < 3; c++)
        out[c] = (double)a[c] - b[c];
}

static void cross(const dvec3 a, const dvec3 b, dvec3 out) {
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        out[c] = a[d] * b[e] - a[e] * b[d];
    }
}

static double dot(const dvec3 a, const dvec3 b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double norm(const dvec3 a) {
    return sqrt(dot(a, a));
}

/* All triangles of a primitive taken together. */
struct whole {
    const struct primitive *primitive;
    dvec3 center, normal; /* of the area; unit */
    double area, radius;  /* of the farthest vertex from the centre */
    dvec3 farthest;       /* that vertex, from the centre */
};

static const float *corner_of(const struct primitive *primitive, int index) {
    return primitive->position[primitive->indices[index]];
}

/* Sums areas as vectors: they add up to the sum of lengths only where all face the same way. */
static bool sum_areas(struct whole *whole) {
    const struct primitive *primitive = whole->primitive;
    const double origin[3] = {0};
    dvec3 first;
    if (primitive->index_count < 3)
        return false;
    difference(corner_of(primitive, 0), origin, first);
    for (int i = 0; i + 2 < primitive->index_count; i += 3) {
        dvec3 a, b, c, area;
        difference(corner_of(primitive, i), first, a);
        difference(corner_of(primitive, i + 1), first, b);
        difference(corner_of(primitive, i + 2), first, c);
        dvec3 ab = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        dvec3 ac = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        cross(ab, ac, area);
        double size = norm(area) / 2;
        whole->area += size;
        for (int k = 0; k < 3; k++) {
            whole->normal[k] += area[k] / 2;
            whole->center[k] += (a[k] + b[k] + c[k]) / 3 * size;
        }
    }
    double vector_sum = norm(whole->normal);
    if (!(whole->area > 0) || vector_sum < (1 - tolerance) * whole->area)
        return false;
    for (int k = 0; k < 3; k++) {
        whole->normal[k] /= vector_sum;
        whole->center[k] = whole->center[k] / whole->area + first[k];
    }
    return true;
}

/* Finds the farthest vertex; false where not all lie in one plane. */
static bool measure(struct whole *whole) {
    double off_plane = 0;
    for (int i = 0; i < whole->primitive->index_count; i++) {
        dvec3 from;
        difference(corner_of(whole->primitive, i), whole->center, from);
        off_plane = fmax(off_plane, fabs(dot(from, whole->normal)));
        if (norm(from) > whole->radius) {
            whole->radius = norm(from);
            memcpy(whole->farthest, from, sizeof from);
        }
    }
    return off_plane <= tolerance * whole->radius;
}

static void set_frame(struct flat_shape *shape, const struct whole *whole, const dvec3 right) {
    dvec3 up;
    cross(whole->normal, right, up);
    for (int c = 0; c < 3; c++) {
        shape->center[c] = (float)whole->center[c];
        shape->normal[c] = (float)whole->normal[c];
        shape->right[c] = (float)(right[c] / norm(right));
        shape->up[c] = (float)(up[c] / norm(up));
    }
}

/* A rectangle's farthest vertex is a corner, and of those farthest from the diagonal through it
 * each is another: then area says whether the triangles fill what the corners span. */
static bool fits_rectangle(struct flat_shape *shape, const struct whole *whole) {
    dvec3 other = {0}, right, up, turned;
    double away = 0;
    for (int i = 0; i < whole->primitive->index_count; i++) {
        dvec3 from;
        difference(corner_of(whole->primitive, i), whole->center, from);
        cross(whole->farthest, from, turned);
        if (norm(turned) > away * (1 + tolerance)) {
            away = norm(turned);
            memcpy(other, from, sizeof other);
        }
    }
    for (int c = 0; c < 3; c++) {
        right[c] = other[c] - whole->farthest[c];
        up[c] = other[c] + whole->farthest[c];
    }
    double width = norm(right), height = norm(up);
    if (fabs(dot(right, up)) > tolerance * width * height ||
        fabs(width * height - whole->area) > tolerance * whole->area)
        return false;
    set_frame(shape, whole, right);
    shape->size[0] = (float)width;
    shape->size[1] = (float)height;
    return true;
}

/* The integral of the squared distance from the centre, over the triangles. */
static double second_moment(const struct whole *whole) {
    double sum = 0;
    for (int i = 0; i + 2 < whole->primitive->index_count; i += 3) {
        dvec3 p[3], ab, ac, area, middle;
        for (int k = 0; k < 3; k++)
            difference(corner_of(whole->primitive, i + k), whole->center, p[k]);
        for (int c = 0; c < 3; c++) {
            ab[c] = p[1][c] - p[0][c], ac[c] = p[2][c] - p[0][c];
            middle[c] = p[0][c] + p[1][c] + p[2][c];
        }
        cross(ab, ac, area);
        double squares = dot(p[0], p[0]) + dot(p[1], p[1]) + dot(p[2], p[2]);
        sum += norm(area) / 2 * (squares + dot(middle, middle)) / 12;
    }
    return sum;
}

/* A regular polygon's area tells how many corners it has, and its second moment that it is one. The
 * disk has the same area. */
static bool fits_disk(struct flat_shape *shape, const struct whole *whole) {
    double square = whole->radius * whole->radius, share = whole->area / (GLM_PI * square);
    if (share < octagon_share || share > 1 + tolerance)
        return false;
    /* sin(x) / x = share, x = 2 pi / corners */
    double x = sqrt(fmax(0, 10 * (1 - sqrt(fmax(0, 1 - 1.2 * (1 - share))))));
    double moment = whole->area * square * (2 + cos(x)) / 6;
    if (fabs(second_moment(whole) - moment) > 10 * tolerance * moment)
        return false;
    set_frame(shape, whole, whole->farthest);
    shape->size[0] = (float)(2 * sqrt(whole->area / GLM_PI));
    shape->size[1] = 0;
    return true;
}

bool flat_shape_of(struct flat_shape *shape, const struct primitive *primitive) {
    struct whole whole = {.primitive = primitive};
    return sum_areas(&whole) && measure(&whole) &&
           (fits_rectangle(shape, &whole) || fits_disk(shape, &whole));
}
