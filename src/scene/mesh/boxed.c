#include "scene/mesh/boxed.h"

#include <math.h>
#include <string.h>

/* A triangle cut by six planes. Corners are weights of the triangle's corners: areas relative to
 * the triangle's need no lengths. */
enum { CORNERS_MAX = 3 + 6 };

struct polygon {
    int count;
    double weight[CORNERS_MAX][3];
};

bool box_ends(const struct box *box) {
    return isfinite(box->low[0]);
}

bool box_holds(const struct box *box, const float low[3], const float high[3]) {
    bool holds = true;
    for (int c = 0; c < 3; c++)
        holds = holds && low[c] >= box->low[c] && high[c] <= box->high[c];
    return holds;
}

static bool holds_triangle(const struct box *box, const struct geometry *geometry,
                           const uint32_t index[3]) {
    bool holds = true;
    for (int k = 0; k < 3; k++)
        holds = holds && box_holds(box, geometry->position[index[k]], geometry->position[index[k]]);
    return holds;
}

/* Rounding may let a triangle without width cross a plane more than twice. */
static void add(struct polygon *polygon, const double a[3], const double b[3], double t) {
    if (polygon->count == CORNERS_MAX)
        return;
    for (int k = 0; k < 3; k++)
        polygon->weight[polygon->count][k] = a[k] + t * (b[k] - a[k]);
    polygon->count++;
}

/* Leaves where a linear function of the place is not negative [Sutherland and Hodgman 1974]; value:
 * at the triangle's corners. */
static void cut(struct polygon *polygon, const double value[3]) {
    struct polygon from = *polygon;
    polygon->count = 0;
    for (int i = 0; i < from.count; i++) {
        const double *a = from.weight[i], *b = from.weight[(i + 1) % from.count];
        double at = a[0] * value[0] + a[1] * value[1] + a[2] * value[2];
        double next = b[0] * value[0] + b[1] * value[1] + b[2] * value[2];
        if (at >= 0)
            add(polygon, a, a, 0);
        if ((at >= 0) != (next >= 0))
            add(polygon, a, b, at / (at - next));
    }
}

static struct polygon part_of(const struct box *box, const struct geometry *geometry,
                              const uint32_t index[3]) {
    struct polygon polygon = {3, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int c = 0; c < 3; c++) {
        double above[3], below[3];
        for (int k = 0; k < 3; k++) {
            double place = (double)geometry->position[index[k]][c];
            above[k] = place - (double)box->low[c];
            below[k] = (double)box->high[c] - place;
        }
        cut(&polygon, above);
        cut(&polygon, below);
    }
    return polygon;
}

/* Of the triangle of the corners 0, i and i + 1, as a share of the whole triangle's area: weights
 * of the last two corners are coordinates in which the whole has an area of 1/2. */
static double fan_share(const struct polygon *polygon, int i) {
    const double *a = polygon->weight[0], *b = polygon->weight[i], *c = polygon->weight[i + 1];
    return fabs((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]));
}

static double share_of(const struct polygon *polygon) {
    double share = 0;
    for (int i = 1; i + 1 < polygon->count; i++)
        share += fan_share(polygon, i);
    return share;
}

double boxed_share(const struct box *box, const struct geometry *geometry,
                   const uint32_t index[3]) {
    if (holds_triangle(box, geometry, index))
        return 1;
    struct polygon polygon = part_of(box, geometry, index);
    return fmin(share_of(&polygon), 1);
}

/* x chooses a triangle of the fan by area, and what is left of it a place in it. */
bool boxed_spread(float weight[3], const struct box *box, const struct geometry *geometry,
                  const uint32_t index[3], double x, double y) {
    float in_fan[3];
    if (holds_triangle(box, geometry, index)) {
        corners_spread(weight, x, y);
        return true;
    }
    struct polygon polygon = part_of(box, geometry, index);
    double rest = x * share_of(&polygon);
    int i = 1;
    while (i + 2 < polygon.count && rest >= fan_share(&polygon, i))
        rest -= fan_share(&polygon, i++);
    double share = polygon.count < 3 ? 0 : fan_share(&polygon, i);
    if (!(share > 0))
        return false;
    corners_spread(in_fan, fmin(rest / share, 1 - 1e-12), y);
    for (int k = 0; k < 3; k++)
        weight[k] = (float)((double)in_fan[0] * polygon.weight[0][k] +
                            (double)in_fan[1] * polygon.weight[i][k] +
                            (double)in_fan[2] * polygon.weight[i + 1][k]);
    return true;
}
