/* Rays through a tree of triangles, against all triangles one by one. */
#include "support.h"

#include "base/halton.h"
#include "base/memory.h"
#include "scene/mesh/tree_ray.h"

#include <math.h>

enum { TRIANGLES = 300, RAYS = 4000 };

/* In [-1, 1) along each axis. */
static vec3s point_of(uint32_t i) {
    vec3s point;
    static const uint32_t bases[3] = {2, 3, 5};
    for (int c = 0; c < 3; c++)
        point.raw[c] = 2 * (float)radical_inverse(bases[c], i) - 1;
    return point;
}

/* Of a tenth of the box, in no order. */
static struct tree_triangle *scatter_triangles(void) {
    struct tree_triangle *triangles = mem_alloc(TRIANGLES, sizeof *triangles);
    for (uint32_t i = 0; i < TRIANGLES; i++)
        triangles[i] = (struct tree_triangle){.corner = point_of(3 * i),
                                              .edges = {glms_vec3_scale(point_of(7 * i + 1), .2F),
                                                        glms_vec3_scale(point_of(11 * i + 2), .2F)},
                                              .number = i};
    return triangles;
}

/* -1 = none. */
static int nearest_of_all(const struct triangle_tree *tree, vec3s origin, vec3s direction,
                          float *distance) {
    int nearest = -1;
    *distance = INFINITY;
    for (uint32_t i = 0; i < tree->count; i++) {
        const struct tree_triangle *t = &tree->triangles[i];
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
    return glms_vec3_normalize(direction);
}

static void test_nearest(void **state) {
    (void)state;
    struct triangle_tree tree;
    int hits = 0, fronts = 0;
    double worst = 0;
    triangle_tree_init(&tree, scatter_triangles(), TRIANGLES);
    for (uint32_t i = 0; i < RAYS; i++) {
        vec3s origin = i % 16 ? point_of(i) : tree.triangles[i % TRIANGLES].corner;
        vec3s direction = direction_of(i);
        float distance;
        int expected = nearest_of_all(&tree, origin, direction, &distance);
        struct tree_hit hit = tree_ray_trace(&tree, origin, direction);
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
    assert_in_range(hits, RAYS / 4, RAYS);
    assert_in_range(fronts, hits / 3, hits * 2 / 3);
    triangle_tree_free(&tree);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_nearest)};
    return cmocka_run_group_tests_name("tree_ray", tests, NULL, NULL);
}
