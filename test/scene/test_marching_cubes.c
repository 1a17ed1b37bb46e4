/* The polygoniser: closed, oriented, of the right shape, and the same when its memory is reused;
 * the metaballs it animates. */
#include "support.h"
#include "surface_shape.h"

#include "scene/shapes/marching_cubes.h"
#include "scene/shapes/metaballs.h"

#include <cglm/cglm.h>

/* --- fields ----------------------------------------------------------------------------------- */

typedef float (*point_function)(const float point[3]);

struct point_field {
    point_function value;
};

static void point_row(const void *context, const float first[3], float step, int count,
                      float *values) {
    const struct point_field *field = context;
    for (int i = 0; i < count; i++)
        values[i] = field->value((const float[]){first[0] + (float)i * step, first[1], first[2]});
}

static void point_gradient(const void *context, const float point[3], float gradient[3]) {
    const struct point_field *field = context;
    const float h = 1e-3f;
    for (int k = 0; k < 3; k++) {
        float high[3] = {point[0], point[1], point[2]}, low[3] = {point[0], point[1], point[2]};
        high[k] += h;
        low[k] -= h;
        gradient[k] = (field->value(high) - field->value(low)) / (2.0f * h);
    }
}

static float sphere(const float p[3]) {
    return 1.0f - sqrtf(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

/* Radii 0.8 and 0.3, tilted so that no part lies along the grid. */
static float torus(const float p[3]) {
    float x = 0.8f * p[0] + 0.6f * p[1], y = -0.6f * p[0] + 0.8f * p[1];
    float ring = sqrtf(x * x + p[2] * p[2]) - 0.8f;
    return 0.3f - sqrtf(ring * ring + y * y);
}

static void polygonise(struct marching_cubes *cubes, point_function value, int cells,
                       struct surface *surface) {
    struct point_field field = {value};
    struct implicit implicit = {&field, point_row, point_gradient};
    struct marching_grid grid = {{-1.2f, -1.2f, -1.2f}, 2.4f / (float)cells, {cells, cells, cells}};
    surface_clear(surface);
    marching_cubes_polygonise(cubes, &implicit, &grid, surface);
}

/* --- tests ------------------------------------------------------------------------------------ */

TEST(sphere) {
    struct marching_cubes cubes;
    struct surface surface = {0};
    marching_cubes_init(&cubes);
    polygonise(&cubes, sphere, 40, &surface);
    struct surface_shape shape = measure_surface(&surface);
    check_near("sphere: open edges", shape.open_edges, 0.0, 0.0);
    check_near("sphere: Euler characteristic", shape.euler, 2.0, 0.0);
    check_near("sphere: area / 4 pi", shape.area / (4.0 * GLM_PI), 1.0, 0.003);
    check_near("sphere: volume / (4 pi / 3)", shape.volume / (4.0 * GLM_PI / 3.0), 1.0, 0.003);
    check_at_most("sphere: 1 - least normal cosine", 1.0 - shape.worst_normal, 0.02);
    double worst = 0.0;
    for (uint32_t i = 0; i < surface.vertex_count; i++)
        worst = fmax(worst, fabs(glm_vec3_norm(surface.normal[i]) - 1.0));
    check_at_most("sphere: normals' distance from unit", worst, 1e-5);
    surface_free(&surface);
    marching_cubes_free(&cubes);
}

TEST(torus) {
    struct marching_cubes cubes;
    struct surface surface = {0};
    marching_cubes_init(&cubes);
    polygonise(&cubes, torus, 60, &surface);
    struct surface_shape shape = measure_surface(&surface);
    check_near("torus: open edges", shape.open_edges, 0.0, 0.0);
    check_near("torus: Euler characteristic", shape.euler, 0.0, 0.0);
    check_near("torus: area / 4 pi^2 R r", shape.area / (4.0 * GLM_PI * GLM_PI * 0.24), 1.0, 0.01);
    check_near("torus: volume / 2 pi^2 R r^2", shape.volume / (2.0 * GLM_PI * GLM_PI * 0.072), 1.0,
               0.01);
    surface_free(&surface);
    marching_cubes_free(&cubes);
}

/* Two cells side by side along an axis with one of the 4096 patterns of inside corners, and outside
 * corners all round. */
struct pattern {
    int bits, axis;
};

static void pattern_row(const void *context, const float first[3], float step, int count,
                        float *values) {
    const struct pattern *pattern = context;
    for (int i = 0; i < count; i++) {
        int at[3] = {(int)first[0] + i * (int)step, (int)first[1], (int)first[2]};
        int along = at[pattern->axis], u = at[(pattern->axis + 1) % 3],
            v = at[(pattern->axis + 2) % 3];
        bool core = along >= 1 && along <= 3 && u >= 1 && u <= 2 && v >= 1 && v <= 2;
        int corner = (along - 1) * 4 + (u - 1) * 2 + v - 1;
        values[i] = core && pattern->bits >> corner & 1 ? 1.0f : -1.0f;
    }
}

static void any_gradient(const void *context, const float point[3], float gradient[3]) {
    (void)context;
    (void)point;
    gradient[0] = gradient[1] = gradient[2] = 1.0f;
}

/* All that two cells can do to each other: the surface closes and no edge is used twice. */
TEST(every_pattern_is_closed) {
    struct marching_cubes cubes;
    struct surface surface = {0};
    marching_cubes_init(&cubes);
    int open = 0;
    for (int axis = 0; axis < 3; axis++)
        for (int bits = 0; bits < 4096; bits++) {
            struct pattern pattern = {bits, axis};
            struct implicit implicit = {&pattern, pattern_row, any_gradient};
            struct marching_grid grid = {.step = 1.0f, .cells = {3, 3, 3}};
            grid.cells[axis] = 4;
            surface_clear(&surface);
            marching_cubes_polygonise(&cubes, &implicit, &grid, &surface);
            assert_true((surface.index_count > 0) == (bits > 0));
            open += measure_surface(&surface).open_edges;
        }
    check_near("open edges of 3 x 4096 patterns", open, 0.0, 0.0);
    surface_free(&surface);
    marching_cubes_free(&cubes);
}

/* Animation reuses the memory: a large surface before must leave no trace in a small one. */
TEST(memory_is_reused) {
    struct marching_cubes cubes;
    struct surface fresh = {0}, reused = {0};
    marching_cubes_init(&cubes);
    polygonise(&cubes, sphere, 20, &fresh);
    polygonise(&cubes, torus, 48, &reused);
    const void *position = reused.position, *values = cubes.values[0];
    polygonise(&cubes, sphere, 20, &reused);
    assert_ptr_equal(reused.position, position);
    assert_ptr_equal(cubes.values[0], values);
    assert_int_equal(reused.vertex_count, fresh.vertex_count);
    assert_int_equal(reused.index_count, fresh.index_count);
    assert_memory_equal(reused.position, fresh.position,
                        fresh.vertex_count * sizeof *fresh.position);
    assert_memory_equal(reused.indices, fresh.indices, fresh.index_count * sizeof *fresh.indices);
    surface_free(&fresh);
    surface_free(&reused);
    marching_cubes_free(&cubes);
}

/* Metaballs stay closed and in their box while they move, and come back after a period. */
TEST(metaballs) {
    struct metaballs balls = {9, {-1.0f, 0.0f, -2.0f}, {1.0f, 3.0f, 1.0f}, 0.6f, 0.1f, 4.0f};
    struct marching_cubes cubes;
    struct surface start = {0}, surface = {0};
    marching_cubes_init(&cubes);
    metaballs_polygonise(&balls, 0.0, &cubes, &start);
    bool moved = false;
    for (double time = 0.5; time <= balls.period; time += 0.5) {
        surface_clear(&surface);
        metaballs_polygonise(&balls, time, &cubes, &surface);
        struct surface_shape shape = measure_surface(&surface);
        check_near("metaballs: open edges", shape.open_edges, 0.0, 0.0);
        /* A neck thinner than a cell may have a vertex that no normal fits. */
        check_at_most("metaballs: normals on the wrong side", shape.wrong_normals, 2);
        assert_true(shape.volume > 1.0);
        for (uint32_t i = 0; i < surface.vertex_count; i++)
            for (int axis = 0; axis < 3; axis++)
                assert_true(surface.position[i][axis] > balls.low[axis] &&
                            surface.position[i][axis] < balls.high[axis]);
        moved = moved || surface.vertex_count != start.vertex_count;
    }
    assert_true(moved);
    assert_int_equal(surface.vertex_count, start.vertex_count);
    assert_memory_equal(surface.position, start.position,
                        start.vertex_count * sizeof *start.position);
    surface_free(&start);
    surface_free(&surface);
    marching_cubes_free(&cubes);
}

RUN_TESTS(NULL, NULL)
