#include "scene/shapes/metaballs.h"

#include "base/halton.h"
#include "scene/shapes/marching_cubes.h"

#include <assert.h>
#include <cglm/cglm.h>
#include <math.h>

static const float threshold = 0.25f;

struct ball {
    float center[3], reach;
};

/* The balls at one time. */
struct ball_set {
    int count;
    struct ball balls[METABALLS_MAX];
};

/* Each axis swings by itself, a whole number of times a period. */
static float swing(int ball, int axis, double turns) {
    static const uint32_t bases[3] = {2, 3, 5};
    uint32_t i = (uint32_t)ball + 1;
    int frequency = 1 + (ball + axis) % 2;
    return (float)sin(2.0 * GLM_PI * (frequency * turns + radical_inverse(bases[axis], i)));
}

static struct ball_set place_balls(const struct metaballs *metaballs, double time) {
    struct ball_set set = {.count = metaballs->count};
    double turns = time / metaballs->period;
    turns -= floor(turns);
    for (int i = 0; i < set.count; i++) {
        struct ball *ball = &set.balls[i];
        ball->reach = metaballs->reach * (0.7f + 0.6f * (float)radical_inverse(7, (uint32_t)i + 1));
        for (int axis = 0; axis < 3; axis++) {
            float middle = 0.5f * (metaballs->low[axis] + metaballs->high[axis]);
            float room = metaballs->high[axis] - middle - ball->reach;
            ball->center[axis] = middle + room * swing(i, axis, turns);
        }
    }
    return set;
}

/* Sums the balls whose reach the row crosses, each only over that part of the row. */
static void field_row(const void *context, const float first[3], float step, int count,
                      float *values) {
    const struct ball_set *set = context;
    for (int i = 0; i < count; i++)
        values[i] = -threshold;
    for (const struct ball *ball = set->balls; ball < set->balls + set->count; ball++) {
        float dy = first[1] - ball->center[1], dz = first[2] - ball->center[2];
        float aside = dy * dy + dz * dz, square = ball->reach * ball->reach;
        if (aside >= square)
            continue;
        float x = ball->center[0] - first[0], half = sqrtf(square - aside);
        int begin = (int)fmaxf(ceilf((x - half) / step), 0.0f);
        int end = (int)fminf(floorf((x + half) / step) + 1.0f, (float)count);
        for (int i = begin; i < end; i++) {
            float dx = (float)i * step - x, inner = 1.0f - (dx * dx + aside) / square;
            values[i] += inner * inner * inner;
        }
    }
}

static void field_gradient(const void *context, const float point[3], float gradient[3]) {
    const struct ball_set *set = context;
    glm_vec3_zero(gradient);
    for (const struct ball *ball = set->balls; ball < set->balls + set->count; ball++) {
        vec3 d;
        glm_vec3_sub((float *)ball->center, (float *)point, d);
        float square = ball->reach * ball->reach, inner = 1.0f - glm_vec3_norm2(d) / square;
        if (inner > 0.0f)
            glm_vec3_muladds(d, 6.0f * inner * inner / square, gradient);
    }
}

bool metaballs_are_sound(const struct metaballs *balls) {
    double cells = 1;
    for (int axis = 0; axis < 3; axis++) {
        double side = (double)balls->high[axis] - (double)balls->low[axis];
        if (!isfinite(side) || !(side >= 2.6 * (double)balls->reach))
            return false;
        cells *= ceil(side / (double)balls->cell);
    }
    return balls->count >= 1 && balls->count <= METABALLS_MAX && balls->reach > 0 &&
           balls->cell > 0 && cells <= METABALLS_MAX_CELLS && balls->period > 0 &&
           isfinite(balls->period);
}

void metaballs_polygonise(const struct metaballs *metaballs, double time,
                          struct marching_cubes *cubes, struct surface *surface) {
    assert(metaballs->count <= METABALLS_MAX);
    struct ball_set set = place_balls(metaballs, time);
    struct implicit implicit = {&set, field_row, field_gradient};
    struct marching_grid grid = {.step = metaballs->cell};
    for (int axis = 0; axis < 3; axis++) {
        grid.low[axis] = metaballs->low[axis];
        grid.cells[axis] =
            (int)ceilf((metaballs->high[axis] - metaballs->low[axis]) / metaballs->cell);
    }
    marching_cubes_polygonise(cubes, &implicit, &grid, surface);
}
