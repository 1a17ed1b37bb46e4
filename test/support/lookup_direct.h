/* Lookups in maps of depth straight from their definitions, in doubles: projections and filters. A
 * second implementation to hold passes/visibility/lookup.glsl against. */
#ifndef TEST_LOOKUP_DIRECT_H
#define TEST_LOOKUP_DIRECT_H

#include "base/unit.h"
#include "gl/texture.h"
#include "shared/maps.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { SIZE = 64, LEVELS = 7, POINTS = 4000, TERMS = 4, TAPS = 16, SEARCH = TAPS / 2 };

static const double extent = .3, unit = 5, near = .01; /* metres; of the orthographic: radians */
static const double half = .8; /* of the map at 1 m, or of the orthographic one */
static const double bias = .5, map_bias = .01, shift = .03, gain = 2;
static const double nearest = .2, farthest = .5, knee = .2; /* the range of the series, map depth */
static const double series_edge = .61 / (2 * TERMS);

struct answer {
    float uv[2], seen, depth, plane, texel, light, penumbra, width, share, unused[2];
};

struct lookups {
    int projection, filter;
    double plate;          /* map depth; 0: none */
    vec3s origin, axes[3]; /* right, up, forward */
    vec4 points[POINTS][2];
    double depths[SIZE][SIZE]; /* linear, over the unit; 2 where nothing is */
    struct texture map, bases[5];
    struct answer *answers;
};

/* --- projections, in doubles ------------------------------------------------------------------ */

struct c_receiver {
    double point[3], normal[3]; /* in the map's frame */
    double uv[2], distance;
    bool seen;
};

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void to_frame(const struct lookups *lookups, const double v[3], double local[3]) {
    for (int axis = 0; axis < 3; axis++)
        local[axis] = v[0] * (double)lookups->axes[axis].x + v[1] * (double)lookups->axes[axis].y +
                      v[2] * (double)lookups->axes[axis].z;
}

/* Where the map has a place of its own frame. */
static void place_of(int projection, const double q[3], double uv[2]) {
    double across = hypot(q[0], q[1]), scale = 1 / half;
    if (projection == PROJECTION_PARABOLOID)
        scale = across > 0 ? tan(atan2(across, q[2]) / 2) / across : 0;
    if (projection == PROJECTION_PERSPECTIVE)
        scale = 1 / (half * q[2]);
    uv[0] = .5 + .5 * scale * q[0];
    uv[1] = .5 + .5 * scale * q[1];
}

static double distance_of(int projection, const double q[3]) {
    return projection == PROJECTION_PARABOLOID ? sqrt(dot(q, q)) : q[2];
}

/* The width of a texel at the receiver, metres. */
static double texel_of(int projection, const double q[3]) {
    if (projection == PROJECTION_PARABOLOID)
        return 4. / SIZE * sqrt(dot(q, q));
    return 2 * half / SIZE * (projection == PROJECTION_PERSPECTIVE ? q[2] : 1);
}

static struct c_receiver receiver_of(const struct lookups *lookups, const vec4 point[2]) {
    struct c_receiver r = {.distance = 0};
    double from[3], n[3];
    for (int c = 0; c < 3; c++) {
        from[c] = (double)point[0][c] - (double)lookups->origin.raw[c];
        n[c] = (double)point[1][c];
    }
    to_frame(lookups, from, r.point);
    to_frame(lookups, n, r.normal);
    double texel = texel_of(lookups->projection, r.point);
    for (int c = 0; c < 3; c++)
        r.point[c] += bias * texel * r.normal[c];
    place_of(lookups->projection, r.point, r.uv);
    r.distance = distance_of(lookups->projection, r.point);
    r.seen = r.point[2] > 0;
    return r;
}

/* A place of the texel's line of sight, and along it. */
static void sight_of(int projection, int x, int y, double origin[3], double ray[3]) {
    double p[2] = {(x + .5) / SIZE * 2 - 1, (y + .5) / SIZE * 2 - 1};
    bool orthographic = projection == PROJECTION_ORTHOGRAPHIC;
    double angle = 2 * atan(hypot(p[0], p[1])), across = fmax(hypot(p[0], p[1]), 1e-12);
    for (int c = 0; c < 2; c++) {
        origin[c] = orthographic ? p[c] * half : 0;
        ray[c] = orthographic                          ? 0
                 : projection == PROJECTION_PARABOLOID ? sin(angle) * p[c] / across
                                                       : p[c] * half;
    }
    origin[2] = 0;
    ray[2] = projection == PROJECTION_PARABOLOID ? cos(angle) : 1;
}

/* Where the receiver's plane is met through a texel. */
static double plane_of(const struct lookups *lookups, const struct c_receiver *r, int x, int y) {
    double origin[3], ray[3], from[3], bend = 0;
    sight_of(lookups->projection, x, y, origin, ray);
    for (int c = 0; c < 3; c++)
        from[c] = r->point[c] - origin[c];
    double facing = dot(r->normal, ray), plane = r->distance;
    if (facing < -1e-3)
        plane = dot(r->normal, from) / facing;
    if (lookups->projection == PROJECTION_PARABOLOID)
        bend = 2 - 2 * dot(ray, r->point) / r->distance;
    return fmax(fmin(plane, r->distance), r->distance / 2) * (1 - map_bias - bend);
}

/* The width in the map of what is seen under an angle, by two places that far apart. */
static double width_of(int projection, const struct c_receiver *r, double angle) {
    double a[3], b[3], uv[2][2], across = hypot(r->point[0], r->point[1]);
    memcpy(a, r->point, sizeof a);
    memcpy(b, r->point, sizeof b);
    if (projection == PROJECTION_PARABOLOID) { /* turned towards the axis and away from it */
        double middle = atan2(across, r->point[2]);
        for (int c = 0; c < 3; c++) {
            double way = c < 2 ? r->point[c] / across : 0;
            a[c] = c < 2 ? sin(middle - angle / 2) * way : cos(middle - angle / 2);
            b[c] = c < 2 ? sin(middle + angle / 2) * way : cos(middle + angle / 2);
        }
    } else {
        a[0] -= angle * r->distance / 2;
        b[0] += angle * r->distance / 2;
    }
    place_of(projection, a, uv[0]);
    place_of(projection, b, uv[1]);
    return hypot(uv[1][0] - uv[0][0], uv[1][1] - uv[0][1]);
}

/* How much farther the plane gets for a step to the side at 1 m, or an angle of one. */
static double slope_of(int projection, const struct c_receiver *r) {
    double along = -dot(r->normal, r->point), tilt = hypot(r->normal[0], r->normal[1]);
    if (projection == PROJECTION_PARABOLOID)
        return tan(acos(fmin(fmax(along / r->distance, .1), 1)));
    return tilt /
           fmax(projection == PROJECTION_PERSPECTIVE ? along / r->point[2] : -r->normal[2], .1);
}

static double light_of(int projection, const struct c_receiver *r) {
    double cosine = r->point[2] / sqrt(dot(r->point, r->point));
    return projection == PROJECTION_ORTHOGRAPHIC  ? extent
           : projection == PROJECTION_PERSPECTIVE ? extent / r->distance
                                                  : extent * sqrt(fmax(cosine, .05)) / r->distance;
}

/* The rays from both ends of the light past an edge at z, where they meet the
 * receiver's distance. */
static double penumbra_of(int projection, double d, double z) {
    bool orthographic = projection == PROJECTION_ORTHOGRAPHIC;
    double slope = orthographic ? extent / 2 : extent / 2 / z;
    return 2 * slope * (d - z) / d;
}

/* --- filters, in doubles ---------------------------------------------------------------------- */

static bool sees(const struct lookups *lookups, const struct c_receiver *r, double u, double v) {
    int x = (int)(u * SIZE), y = (int)(v * SIZE);
    return plane_of(lookups, r, x, y) <= lookups->depths[y][x] * unit;
}

static double filter_hard(const struct lookups *lookups, const struct c_receiver *r) {
    return sees(lookups, r, r->uv[0], r->uv[1]);
}

static double filter_pcf(const struct lookups *lookups, const struct c_receiver *r) {
    double x = r->uv[0] * SIZE - .5, y = r->uv[1] * SIZE - .5, sum = 0;
    for (int i = 0; i < 4; i++) {
        int column = (int)floor(x) + i % 2, row = (int)floor(y) + i / 2;
        double weight = (1 - fabs(x - column)) * (1 - fabs(y - row));
        sum += r->distance <= lookups->depths[row][column] * unit ? weight : 0;
    }
    return sum;
}

static void tap(const double uv[2], double radius, int i, int n, double at[2]) {
    double turn = i * acos(-1) * (3 - sqrt(5)), reach = radius * sqrt((i + .5) / n);
    at[0] = uv[0] + reach * cos(turn);
    at[1] = uv[1] + reach * sin(turn);
}

/* Half of the filter's width in the map, at least half a texel. */
static double radius_of(const struct lookups *lookups, const struct c_receiver *r, double angle) {
    double wide = width_of(lookups->projection, r, 1e-3) * fmin(angle, .2) / 1e-3;
    return fmax(wide / 2, .5 / SIZE);
}

static double filter_pcss(const struct lookups *lookups, const struct c_receiver *r) {
    double sum = 0, count = 0, lit = 0, at[2];
    double search = radius_of(lookups, r, light_of(lookups->projection, r));
    for (int i = 0; i < SEARCH; i++) {
        tap(r->uv, search, i, SEARCH, at);
        if (sees(lookups, r, at[0], at[1]))
            continue;
        sum += lookups->depths[(int)(at[1] * SIZE)][(int)(at[0] * SIZE)] * unit;
        count++;
    }
    if (count == 0)
        return 1;
    double z = fmax(sum / count, 1e-3 * r->distance);
    double angle = penumbra_of(lookups->projection, r->distance, fmin(z, r->distance));
    for (int i = 0; i < TAPS; i++) {
        tap(r->uv, radius_of(lookups, r, angle), i, TAPS, at);
        lit += sees(lookups, r, at[0], at[1]);
    }
    return lit / TAPS;
}

/* The argument of the series that an open map's range makes of a depth: 0 at the nearest caster,
 * two steps less than half the period at the farthest; and back. */
static double argument_of(double z) {
    double beyond = fmax(z - nearest, 0), range = farthest - nearest;
    return (1 - 4 * series_edge) * beyond / (beyond + knee) * (range + knee) / range;
}

static double depth_of(double argument) {
    double range = farthest - nearest;
    double share = argument / (1 - 4 * series_edge) * range / (range + knee);
    return nearest + knee * share / (1 - share);
}

/* Of a texel: where nothing is, one step less. */
static double texel_argument(double z) {
    return z > 1 ? 1 - 2 * series_edge : argument_of(z);
}

/* What a basis says of the argument a: cos or sin of c_k a, times a or not. */
static double basis_of(double a, int k, bool sine, bool times_a) {
    double angle = acos(-1) * (2 * k + 1) * a;
    return (sine ? sin(angle) : cos(angle)) * (times_a ? a : 1);
}

/* The mean over the texels of a basis, bilinear between texels of a level that are means of squares
 * of the map. k < 0: the argument itself. */
static double level_of(const struct lookups *lookups, const double uv[2], int level, int k,
                       bool sine, bool times_a) {
    int size = SIZE >> level, side = 1 << level;
    double x = uv[0] * size - .5, y = uv[1] * size - .5, sum = 0;
    for (int i = 0; i < 4; i++) {
        int column = (int)floor(x) + i % 2, row = (int)floor(y) + i / 2;
        double weight = (1 - fabs(x - column)) * (1 - fabs(y - row)), mean = 0;
        column = column < 0 ? 0 : column < size ? column : size - 1;
        row = row < 0 ? 0 : row < size ? row : size - 1;
        for (int t = 0; t < side * side; t++) {
            double a =
                texel_argument(lookups->depths[row * side + t / side][column * side + t % side]);
            mean += (k < 0 ? a : basis_of(a, k, sine, times_a)) / (side * side);
        }
        sum += weight * mean;
    }
    return sum;
}

static double filtered(const struct lookups *lookups, const double uv[2], double lod, int k,
                       bool sine, bool times_a) {
    lod = fmin(lod, LEVELS - 1);
    int level = (int)lod < LEVELS - 2 ? (int)lod : LEVELS - 2;
    double part = lod - level;
    return (1 - part) * level_of(lookups, uv, level, k, sine, times_a) +
           part * level_of(lookups, uv, level + 1, k, sine, times_a);
}

/* The blocked fraction [Dong 2009 §4.1], or with a the sum of blockers' arguments. */
static double series(const struct lookups *lookups, const double uv[2], double b, double lod,
                     bool times_a) {
    double sum = times_a ? .5 * filtered(lookups, uv, lod, -1, false, false) : .5;
    for (int k = 0; k < TERMS; k++) {
        double c = acos(-1) * (2 * k + 1);
        sum += 2 / c *
               (sin(c * b) * filtered(lookups, uv, lod, k, false, times_a) -
                cos(c * b) * filtered(lookups, uv, lod, k, true, times_a));
    }
    return sum;
}

static double lod_of(const struct lookups *lookups, const struct c_receiver *r, double angle) {
    double width = width_of(lookups->projection, r, 1e-3) * angle / 1e-3;
    return fmax(0, log2(SIZE * width) - 1);
}

static double receiver_of_series(double d) {
    return fmin(fmax(argument_of(d) - shift, -series_edge), argument_of(farthest) + series_edge);
}

static double filter_cssm(const struct lookups *lookups, const struct c_receiver *r) {
    double d = r->distance / unit, b = receiver_of_series(d);
    double lod = lod_of(lookups, r, light_of(lookups->projection, r));
    double blocked = series(lookups, r->uv, b, lod, false);
    if (blocked < .02)
        return 1;
    double z = series(lookups, r->uv, b, lod, true) / blocked;
    z = fmin(fmax(depth_of(fmax(z, 0)), 1e-3 * d), d);
    double angle = atan(penumbra_of(lookups->projection, r->distance, z * unit));
    b = receiver_of_series(d * (1 - fmin(angle / 8 * slope_of(lookups->projection, r), .5)));
    blocked = series(lookups, r->uv, b, lod_of(lookups, r, angle), false);
    return fmax(fmin(.5 - (blocked - .5) * gain, 1), 0);
}

#endif
