/* Shadow casters: simplified, and with the long ones apart. */
#include "support.h"

#include "scene/mesh/caster.h"

#include <cglm/util.h>

/* A box of 12 triangles, each with vertices of its own, far from the origin and stretched, so that
 * midpoints round. Two faces are masked. */
static void make_box(struct geometry *geometry) {
    static const float axes[3][3] = {{7.3F, .1F, -.2F}, {.3F, 1.1F, .05F}, {-.7F, .2F, .37F}};
    static const uint8_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    static const uint8_t corners[6] = {0, 1, 2, 0, 2, 3};
    *geometry = FILLED(geometry, .vertex_count = 36, .index_count = 36, .batch_count = 2,
                       .blocking_batch_count = 2, .radius = 1);
    geometry->position = mem_alloc(37, sizeof *geometry->position);
    geometry->uv[0] = mem_alloc(36, sizeof *geometry->uv[0]);
    geometry->mapping_count = 1;
    geometry->indices = mem_alloc(36, sizeof *geometry->indices);
    geometry->batches = mem_alloc(2, sizeof *geometry->batches);
    for (uint32_t i = 0; i < 36; i++) {
        int bits = faces[i / 6][corners[i % 6]];
        for (int c = 0; c < 3; c++) {
            float *x = &geometry->position[i][c];
            *x = 31.7F;
            for (int axis = 0; axis < 3; axis++)
                *x += (float)(bits >> axis & 1) * axes[axis][c];
            geometry->bounds_max[c] = fmaxf(geometry->bounds_max[c], *x);
        }
        geometry->uv[0][i][0] = geometry->position[i][0];
        geometry->uv[0][i][1] = geometry->position[i][1];
        geometry->indices[i] = i;
    }
    geometry->opaque_index_count = 24;
    geometry->batches[0] = (struct geometry_batch){.material = 3, .index_count = 24};
    geometry->batches[1] =
        (struct geometry_batch){.material = 1, .first_index = 24, .index_count = 12};
}

static double distance(const float a[3], const float b[3]) {
    return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
}

static double area_of(float (*position)[3], const uint32_t *indices, uint32_t first,
                      uint32_t count) {
    double area = 0;
    for (uint32_t k = first; k < first + count; k += 3) {
        double a = distance(position[indices[k]], position[indices[k + 1]]);
        double b = distance(position[indices[k + 1]], position[indices[k + 2]]);
        double c = distance(position[indices[k + 2]], position[indices[k]]), s = (a + b + c) / 2;
        area += sqrt(fmax(0, s * (s - a) * (s - b) * (s - c)));
    }
    return area;
}

static double longest_edge(float (*position)[3], const uint32_t corner[3]) {
    double longest = 0;
    for (int e = 0; e < 3; e++)
        longest = fmax(longest, distance(position[corner[e]], position[corner[(e + 1) % 3]]));
    return longest;
}

/* An edge by the positions of its ends, the lesser first. */
struct edge {
    float ends[6];
    int direction;
};

static int compare_edges(const void *a, const void *b) {
    return memcmp(((const struct edge *)a)->ends, ((const struct edge *)b)->ends, sizeof(float[6]));
}

/* Edges that are not shared by exactly two triangles that run along them in opposite directions. */
static uint32_t add_edges(float (*position)[3], const struct caster_list *list,
                          struct edge *edges) {
    for (uint32_t k = 0; k < list->index_count; k++) {
        const float *a = position[list->indices[k]];
        const float *b = position[list->indices[k % 3 == 2 ? k - 2 : k + 1]];
        edges[k].direction = memcmp(a, b, 12) < 0 ? 1 : -1;
        memcpy(edges[k].ends, edges[k].direction > 0 ? a : b, 12);
        memcpy(edges[k].ends + 3, edges[k].direction > 0 ? b : a, 12);
    }
    return list->index_count;
}

static uint32_t index_count(const struct caster *caster) {
    return caster->list[CASTER_SHORT].index_count + caster->list[CASTER_LONG].index_count;
}

/* Of the long and the short triangles together. */
static int count_open_edges(float (*position)[3], const struct caster *caster) {
    struct edge *edges = mem_alloc(index_count(caster), sizeof *edges);
    uint32_t count = add_edges(position, &caster->list[CASTER_SHORT], edges);
    count += add_edges(position, &caster->list[CASTER_LONG], edges + count);
    qsort(edges, count, sizeof *edges, compare_edges);
    int open = 0;
    for (uint32_t k = 0, end; k < count; k = end) {
        int direction = 0;
        for (end = k; end < count && compare_edges(&edges[k], &edges[end]) == 0;)
            direction += edges[end++].direction;
        open += end - k != 2 || direction != 0;
    }
    free(edges);
    return open;
}

/* The triangles with the longest edges are long, as many as may be but for those that are alike,
 * and no triangle is lost. */
TEST(long) {
    OWNED(geometry) box;
    make_box(&box);
    static const int most[] = {0, 1, 5, 8, 11, 12, 1000000};
    for (int i = 0; i < 7; i++) {
        struct caster caster;
        caster_init(&caster, &box, &(struct caster_desc){.long_count = most[i]});
        const struct caster_list *list = caster.list;
        printf("  %d at most: %u long, edges above %g\n", most[i],
               list[CASTER_LONG].index_count / 3, (double)caster.long_edge);
        check_at_most("long triangles", list[CASTER_LONG].index_count / 3, most[i]);
        check_near("all triangles", index_count(&caster) / 3, 12, 0);
        check_near("open edges", count_open_edges(box.position, &caster), 0, 0);
        for (int l = 0; l < 2; l++)
            for (uint32_t k = 0; k < list[l].index_count; k += 3) {
                double longest = longest_edge(box.position, list[l].indices + k);
                double bound = (double)caster.long_edge;
                assert_true(l == CASTER_LONG ? longest > bound - 1e-5 : longest < bound + 1e-5);
            }
        if (most[i] >= 12)
            assert_int_equal(list[CASTER_LONG].index_count, 36);
        if (most[i] == 8) /* the four long sides of the box */
            assert_int_equal(list[CASTER_LONG].index_count, 24);
        caster_free(&caster);
    }
}

/* Both lists have all batches, opaque ones first. */
TEST(batches) {
    OWNED(geometry) box;
    make_box(&box);
    struct caster caster;
    caster_init(&caster, &box, &(struct caster_desc){.long_count = 8});
    assert_int_equal(caster.batch_count, 2);
    assert_int_equal(caster.vertex_count, 36);
    double area[2] = {0};
    for (int l = 0; l < 2; l++) {
        const struct caster_list *list = &caster.list[l];
        const struct geometry_batch *batches = list->batches;
        assert_int_equal(batches[0].material, 3);
        assert_int_equal(batches[1].material, 1);
        assert_int_equal(batches[0].first_index, 0);
        assert_int_equal(batches[0].index_count, list->opaque_index_count);
        assert_int_equal(batches[1].first_index, list->opaque_index_count);
        assert_int_equal(batches[1].index_count, list->index_count - list->opaque_index_count);
        for (int i = 0; i < 2; i++)
            area[i] += area_of(box.position, list->indices, batches[i].first_index,
                               batches[i].index_count);
    }
    for (int i = 0; i < 2; i++)
        check_near("area of a batch", area[i],
                   area_of(box.position, box.indices, box.batches[i].first_index,
                           box.batches[i].index_count),
                   1e-6);
    caster_free(&caster);
}

/* Metaballs have other triangles with each pose: none is long. */
TEST(dynamic) {
    OWNED(geometry) box;
    make_box(&box);
    box.batches[0].dynamic = true;
    struct caster caster;
    caster_init(&caster, &box, &(struct caster_desc){.long_count = 100});
    assert_int_equal(caster.list[CASTER_SHORT].index_count, 24);
    assert_int_equal(caster.list[CASTER_LONG].index_count, 12);
    uint32_t first = box.indices[0];
    box.indices[0] = box.indices[3];
    caster_take_batch(&caster, &box, 0);
    assert_true(caster.list[CASTER_SHORT].indices[0] == box.indices[0]);
    box.indices[0] = first;
    box.batches[0].index_count = 12; /* room for fewer */
    caster_lay_out(&caster, &box);
    assert_int_equal(caster.list[CASTER_SHORT].index_count, 12);
    assert_int_equal(caster.list[CASTER_SHORT].opaque_index_count, 12);
    assert_true(caster.list[CASTER_SHORT].indices[0] == first);
    caster_free(&caster);
}

enum { ROWS = 32, COLUMNS = 64, BALL_INDICES = ROWS * COLUMNS * 6 };

/* A corner of the unit sphere's grid; the poles and the seam come out as exact as all others. */
static void ball_point(int row, int column, float point[3]) {
    double polar = GLM_PI * row / ROWS, around = 2 * GLM_PI * (column % COLUMNS) / COLUMNS;
    double ring = row % ROWS ? sin(polar) : 0;
    point[0] = (float)(ring * cos(around));
    point[1] = (float)cos(polar);
    point[2] = (float)(ring * sin(around));
}

/* A unit sphere of triangles with vertices of their own, in two parts: the halves of the rows. */
static void make_ball(struct geometry *ball) {
    static const int steps[6][2] = {{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}};
    *ball = FILLED(geometry, .vertex_count = BALL_INDICES, .index_count = BALL_INDICES,
                   .opaque_index_count = BALL_INDICES, .batch_count = 1, .blocking_batch_count = 1,
                   .part_count = 2, .radius = 1,
                   .position = mem_alloc(BALL_INDICES + 1, sizeof *ball->position),
                   .uv = {mem_alloc(BALL_INDICES, sizeof *ball->uv[0])}, .mapping_count = 1,
                   .indices = mem_alloc(BALL_INDICES, sizeof *ball->indices),
                   .batches = mem_alloc(1, sizeof *ball->batches),
                   .parts = mem_alloc(2, sizeof *ball->parts));
    for (int i = 0; i < BALL_INDICES; i++) {
        int quad = i / 6, row = quad / COLUMNS, column = quad % COLUMNS;
        ball_point(row + steps[i % 6][0], column + steps[i % 6][1], ball->position[i]);
        ball->indices[i] = (uint32_t)i;
    }
    ball->batches[0].index_count = BALL_INDICES;
    for (uint32_t p = 0; p < 2; p++)
        ball->parts[p] = FILLED(
            geometry_part, .first_vertex = p * BALL_INDICES / 2, .vertex_count = BALL_INDICES / 2,
            .first_index = p * BALL_INDICES / 2, .index_count = BALL_INDICES / 2, .rigid = true,
            .bounds_min = {-1, -1, -1}, .bounds_max = {1, 1, 1});
}

/* How deep the triangles lie within the unit sphere. */
static double deepest(float (*position)[3], const struct caster *caster) {
    static const float weights[][3] = {
        {.5F, .5F, 0}, {.5F, 0, .5F}, {0, .5F, .5F}, {1 / 3.F, 1 / 3.F, 1 / 3.F}};
    double deepest = 0;
    const struct caster_list *list = &caster->list[CASTER_SHORT];
    for (uint32_t k = 0; k < list->index_count; k += 3)
        for (int w = 0; w < 4; w++) {
            double square = 0;
            for (int c = 0; c < 3; c++) {
                double sum = 0;
                for (int i = 0; i < 3; i++)
                    sum += (double)(weights[w][i] * position[list->indices[k + i]][c]);
                square += sum * sum;
            }
            deepest = fmax(deepest, 1 - sqrt(square));
        }
    return deepest;
}

/* A ball of few triangles strays no more than was allowed for, and no crack opens in it nor between
 * its parts. */
TEST(simplified) {
    OWNED(geometry) ball;
    make_ball(&ball);
    /* The poles' rows have triangles without area. */
    uint32_t before = BALL_INDICES / 3 - 2 * COLUMNS, last = before;
    static const float errors[] = {.001F, .0025F, .008F}; /* metres */
    float size = sqrtf(4 * GLM_PIf);
    for (int i = 0; i < 3; i++) {
        struct caster caster;
        caster_init(&caster, &ball, &(struct caster_desc){.error = errors[i] / size});
        check_near("open edges", count_open_edges(ball.position, &caster), 0, 0);
        check_at_most("depth", deepest(ball.position, &caster), 3 * errors[i] + .0025);
        check_at_most("triangles", caster.list[CASTER_SHORT].index_count / 3, .9 * last);
        last = caster.list[CASTER_SHORT].index_count / 3;
        caster_free(&caster);
    }
    check_at_most("triangles", last, before / 3.);
}

/* What bends or has holes keeps its triangles, and so does all where nothing may stray. */
TEST(not_simplified) {
    enum { OFF, NOT_RIGID, MASKED, KINDS };
    for (int kind = 0; kind < KINDS; kind++) {
        OWNED(geometry) ball;
        make_ball(&ball);
        ball.parts[0].rigid = ball.parts[1].rigid = kind != NOT_RIGID;
        if (kind == MASKED)
            ball.opaque_index_count = 0;
        struct caster caster;
        caster_init(&caster, &ball, &(struct caster_desc){.error = kind == OFF ? 0 : .1F});
        assert_int_equal(caster.list[CASTER_SHORT].index_count, BALL_INDICES);
        assert_memory_equal(caster.list[CASTER_SHORT].indices, ball.indices,
                            sizeof(uint32_t[BALL_INDICES]));
        caster_free(&caster);
    }
}

/* A small thing keeps its shape whatever the scene's size allows for. */
TEST(small_part) {
    OWNED(geometry) ball;
    make_ball(&ball);
    struct caster caster;
    caster_init(&caster, &ball, &(struct caster_desc){.error = 100});
    check_near("open edges", count_open_edges(ball.position, &caster), 0, 0);
    check_at_most("depth", deepest(ball.position, &caster), .03);
    caster_free(&caster);
}

RUN_TESTS(NULL, NULL)
