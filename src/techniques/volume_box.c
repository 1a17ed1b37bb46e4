#include "techniques/volume_box.h"

#include "scene/animation.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = 4096, POSES = 9 /* of a clip */ };

/* Points beyond the middle 70 % along an axis do not count, but the box has room on each side. A
 * scene that is not this much longer than the box is held whole. */
static const float beyond = .15F, room = .75F, far_longer = 2;

static int ascending(const void *a, const void *b) {
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

static void fit_axis(struct box *box, int axis, float *values, int count) {
    qsort(values, (size_t)count, sizeof *values, ascending);
    float low = values[(int)(beyond * (float)count)],
          high = values[count - 1 - (int)(beyond * (float)count)];
    box->low[axis] = low - room * (high - low);
    box->high[axis] = high + room * (high - low);
}

static float longest_of(const float low[3], const float high[3]) {
    return fmaxf(high[0] - low[0], fmaxf(high[1] - low[1], high[2] - low[2]));
}

static const struct box unbounded = {{-INFINITY, -INFINITY, -INFINITY},
                                     {INFINITY, INFINITY, INFINITY}};

/* No triangle has more than a tenth of these points. */
static struct box box_of_pose(const struct scene *scene, const struct geometry *geometry) {
    struct box box = unbounded;
    struct surface_points points;
    float values[3][POINTS];
    int count = 0;
    surface_points_init(&points, &(struct surface_points_desc){
                                     .scene = scene, .geometry = geometry, .count = POINTS});
    for (int i = 0; i < points.count; i++) {
        struct surface_place place = surface_points_place(&points, geometry, i);
        if (place.area > 0) {
            for (int c = 0; c < 3; c++)
                values[c][count] = place.position.raw[c];
            count++;
        }
    }
    surface_points_free(&points);
    for (int c = 0; c < 3 && count > 0; c++)
        fit_axis(&box, c, values[c], count);
    return box;
}

static bool is_far_longer(const struct geometry *geometry, const struct box *box) {
    return box_ends(box) && longest_of(geometry->bounds_min, geometry->bounds_max) >=
                                far_longer * longest_of(box->low, box->high);
}

/* With what is in the box at that time. A pose that fails needs all. */
static void add_pose(struct box *box, const struct scene *scene, double time) {
    struct geometry geometry;
    if (!geometry_init_still(&geometry, scene, time)) {
        *box = unbounded;
        return;
    }
    struct box own = box_of_pose(scene, &geometry);
    for (int c = 0; c < 3; c++) {
        box->low[c] = fminf(box->low[c], own.low[c]);
        box->high[c] = fmaxf(box->high[c], own.high[c]);
    }
    geometry_free(&geometry);
}

/* Whatever pose the geometry has, the result is the same. */
static struct box box_of_clip(const struct scene *scene, const struct geometry *geometry,
                              double duration) {
    struct box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (int i = 0; i < POSES; i++) {
        add_pose(&box, scene, duration * i / (POSES - 1));
        if (!is_far_longer(geometry, &box))
            break;
    }
    return box;
}

void volume_box_fit(struct box *box, const struct scene *scene, const struct geometry *geometry) {
    double duration = scene_duration(scene);
    *box = duration > 0 ? box_of_clip(scene, geometry, duration) : box_of_pose(scene, geometry);
    if (!is_far_longer(geometry, box))
        *box = unbounded;
}
