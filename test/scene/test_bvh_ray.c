/* Rays through a tree of triangles, against all triangles one by one. */
#include "support.h"

#include "base/halton.h"
#include "scene/mesh/bvh_ray.h"

enum { TRIANGLES = 300, RAYS = 4000 };

/* In [-1, 1) along each axis. */
static vec3s point_of(uint32_t i) {
    vec3s point;
    static const uint32_t bases[3] = {2, 3, 5};
    for (int c = 0; c < 3; c++)
        point.raw[c] = 2 * (float)radical_inverse(bases[c], i) - 1;
    return point;
}

/* Of a tenth of the box at size .2, in no order. */
static struct bvh_triangle *scatter_triangles(uint32_t count, float size) {
    struct bvh_triangle *triangles = mem_alloc(count, sizeof *triangles);
    for (uint32_t i = 0; i < count; i++)
        triangles[i] = FILLED(bvh_triangle, .corner = point_of(3 * i),
                              .edges = {glms_vec3_scale(point_of(7 * i + 1), size),
                                        glms_vec3_scale(point_of(11 * i + 2), size)},
                              .number = i);
    return triangles;
}

/* -1 = none. */
static int nearest_of_all(const struct bvh *tree, vec3s origin, vec3s direction, float *distance) {
    int nearest = -1;
    *distance = INFINITY;
    for (uint32_t i = 0; i < tree->count; i++) {
        const struct bvh_triangle *t = &tree->triangles[i];
        vec3s b = glms_vec3_add(t->corner, t->edges[0]), c = glms_vec3_add(t->corner, t->edges[1]);
        float along;
        if (glm_ray_triangle(origin.raw, direction.raw, (float *)t->corner.raw, b.raw, c.raw,
                             &along) &&
            along < *distance) {
            *distance = along;
            nearest = (int)t->number;
        }
    }
    return nearest;
}

/* Now and then along an axis, where a side of a box is met by all of the ray or by none. */
static vec3s direction_of(uint32_t i) {
    vec3s direction = point_of(5 * i + 1);
    for (uint32_t c = 0; c < 3 && i % 8 == 0; c++)
        direction.raw[c] = c == i / 8 % 3 ? 1 : 0;
    return vec3s_unit(direction);
}

TEST(nearest) {
    struct bvh tree;
    int hits = 0, fronts = 0;
    double worst = 0;
    bvh_init(&tree, scatter_triangles(TRIANGLES, .2F), TRIANGLES);
    for (uint32_t i = 0; i < RAYS; i++) {
        vec3s origin = i % 16 ? point_of(i) : tree.triangles[i % TRIANGLES].corner;
        vec3s direction = direction_of(i);
        float distance;
        int expected = nearest_of_all(&tree, origin, direction, &distance);
        struct bvh_hit hit = bvh_ray_trace(&tree, origin, direction);
        assert_int_equal(hit.triangle ? (int)hit.triangle->number : -1, expected);
        if (!hit.triangle)
            continue;
        vec3s normal = glms_vec3_cross(hit.triangle->edges[0], hit.triangle->edges[1]);
        assert_int_equal(hit.front, glms_vec3_dot(normal, direction) < 0);
        worst = fmax(worst, fabs((double)(hit.distance - distance)));
        hits++;
        fronts += hit.front;
    }
    printf("  %d of %d rays hit, %d of them fronts\n", hits, RAYS, fronts);
    check_at_most("distance", worst, 1e-5);
    assert_true(hits >= RAYS / 4 && hits <= RAYS);
    assert_true(fronts >= hits / 3 && fronts <= hits * 2 / 3);
    bvh_free(&tree);
}

/* Of two triangles the nearer one is met where its part is opaque: parts go row by row along the
 * first edge (scene/mesh/opacity.c). */
TEST(opaque) {
    struct bvh tree;
    struct bvh_triangle *triangles = mem_alloc(2, sizeof *triangles);
    const struct bvh_triangle both = {.edges = {{{1, 0, 0}}, {{0, 1, 0}}},
                                      .opaque = {0x5A3C0FF1U, 0x9E2244B7U}};
    int number = 0, met = 0, wrong = 0;
    for (int i = 0; i < 2; i++) {
        triangles[i] = both;
        triangles[i].corner.z = (float)i;
        triangles[i].number = (uint32_t)i;
    }
    triangles[1].opaque[0] = triangles[1].opaque[1] = ~0U;
    bvh_init(&tree, triangles, 2);
    for (int row = 0; row < 8; row++)
        for (int i = 0; i < 2 * (8 - row) - 1; i++, number++) {
            float past = i % 2 ? 2.F / 3 : 1.F / 3;
            const vec3s origin = {{((float)(i / 2) + past) / 8, ((float)row + past) / 8, -1}};
            const vec3s along = {{0, 0, 1}};
            struct bvh_hit hit = bvh_ray_trace_opaque(&tree, origin, along);
            bool opaque = both.opaque[number / 32] >> number % 32 & 1;
            assert_non_null(hit.triangle);
            wrong += (hit.triangle->number == 0) != opaque;
            met += opaque;
            assert_int_equal(bvh_ray_trace(&tree, origin, along).triangle->number, 0);
        }
    printf("  %d of %d parts are opaque, %d seen wrongly\n", met, number, wrong);
    assert_int_equal(number, 64);
    assert_int_equal(wrong, 0);
    bvh_free(&tree);
}

/* --- the tree --------------------------------------------------------------------------------- */

enum { MANY = 20000 }; /* so many that subtrees are built in parallel */

static bool holds(const struct bvh_box *box, const struct bvh_box *other) {
    bool inside = true;
    for (int c = 0; c < 3; c++)
        inside = inside && box->low[c] <= other->low[c] && box->high[c] >= other->high[c];
    return inside;
}

static bool holds_triangle(const struct bvh_box *box, const struct bvh_triangle *t) {
    const vec3s corners[3] = {t->corner, glms_vec3_add(t->corner, t->edges[0]),
                              glms_vec3_add(t->corner, t->edges[1])};
    bool inside = true;
    for (int i = 0; i < 3; i++) {
        struct bvh_box point;
        memcpy(point.low, corners[i].raw, sizeof point.low);
        memcpy(point.high, corners[i].raw, sizeof point.high);
        inside = inside && holds(box, &point);
    }
    return inside;
}

/* What is below a node: triangles, the largest leaf, and the expected cost of a ray that enters the
 * node, in tests of triangles. */
struct below {
    uint32_t triangles, largest_leaf;
    double cost;
};

static struct below look_below(const struct bvh *tree, uint32_t number) {
    const struct bvh_node *node = &tree->nodes[number];
    struct below below = {node->count, node->count, node->count};
    for (uint32_t i = 0; i < node->count; i++)
        assert_true(holds_triangle(&node->box, &tree->triangles[node->first + i]));
    if (node->count > 0)
        return below;
    below.cost = 1;
    for (uint32_t i = 0; i < 2; i++) {
        const struct bvh_box *box = &tree->nodes[node->first + i].box;
        struct below child = look_below(tree, node->first + i);
        assert_true(holds(&node->box, box));
        below.triangles += child.triangles;
        below.largest_leaf =
            child.largest_leaf > below.largest_leaf ? child.largest_leaf : below.largest_leaf;
        below.cost +=
            child.cost * (double)(bvh_box_half_surface(box) / bvh_box_half_surface(&node->box));
    }
    return below;
}

/* Every triangle is in one leaf, leaves are small, and threads do not change the order. The cost is
 * 75 here, and 88 where all nodes of up to four triangles are leaves. */
TEST(tree) {
    struct bvh tree, again;
    bool *seen = mem_alloc(MANY, sizeof *seen);
    bvh_init(&tree, scatter_triangles(MANY, .02F), MANY);
    bvh_init(&again, scatter_triangles(MANY, .02F), MANY);
    struct below below = look_below(&tree, 0);
    printf("  %u triangles, leaves of up to %u, cost %.1f\n", below.triangles, below.largest_leaf,
           below.cost);
    assert_int_equal(below.triangles, MANY);
    assert_true(below.largest_leaf >= 1 && below.largest_leaf <= 4);
    check_at_most("cost", below.cost, 80);
    for (uint32_t i = 0; i < MANY; i++) {
        assert_false(seen[tree.triangles[i].number]);
        seen[tree.triangles[i].number] = true;
        assert_int_equal(tree.triangles[i].number, again.triangles[i].number);
    }
    bvh_free(&tree);
    bvh_free(&again);
    free(seen);
}

/* Triangles whose boxes have one middle cannot be split. */
TEST(one_place) {
    enum { COUNT = 40 };
    struct bvh tree;
    struct bvh_triangle *triangles = mem_alloc(COUNT, sizeof *triangles);
    for (uint32_t i = 0; i < COUNT; i++)
        triangles[i] = FILLED(bvh_triangle, .edges = {{{1, 0, 0}}, {{0, 1, 0}}}, .number = i);
    bvh_init(&tree, triangles, COUNT);
    printf("  %u nodes, %u triangles in the first\n", tree.node_count, tree.nodes[0].count);
    assert_int_equal(tree.node_count, 1);
    assert_int_equal(tree.nodes[0].count, COUNT);
    bvh_free(&tree);
}

TEST(none) {
    struct bvh tree;
    bvh_init(&tree, mem_alloc(0, sizeof *tree.triangles), 0);
    assert_int_equal(tree.count, 0);
    assert_int_equal(tree.nodes[0].count, 0);
    bvh_free(&tree);
}

RUN_TESTS(NULL, NULL)
