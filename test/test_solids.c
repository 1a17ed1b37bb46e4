/* Which sides of surfaces lie within something: the tree of triangles against Embree, a room whose surfaces are all
 * double-sided, wound the wrong way, and with a part that moves; and what points that are not there change. */
#include "render_support.h"

#include "base/halton.h"
#include "base/memory.h"
#include "reference/scene/ray_scene.h"
#include "scene/mesh/surface_points.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* --- rays ------------------------------------------------------------------------------------- */

static vec3s square_to_sphere(double x, double y) {
    float height = (float)(2 * x - 1), radius = sqrtf(1 - height * height),
          angle = 2 * GLM_PIf * (float)y;
    return (vec3s){{radius * cosf(angle), height, radius * sinf(angle)}};
}

/* From within the bounds, in all directions: the same distances and sides as Embree's, but where two surfaces lie in
 * one place. */
static void check_rays(const char *path) {
    enum { RAYS = 4096 };
    struct stage stage;
    struct solids solids;
    struct hit_table table;
    struct ray_scene rays;
    int met = 0, backs = 0, other = 0;
    open_stage(&stage, path);
    const struct geometry *geometry = &stage.geometry;
    solids_init(&solids, &stage.scene, geometry);
    hit_table_init(&table, &stage.scene, geometry, MATERIALS_DIFFUSE);
    check_ok("Embree", ray_scene_init(&rays, &table));
    for (uint32_t i = 1; i <= RAYS; i++) {
        static const uint32_t bases[] = {2, 3, 5};
        vec3s from, to = square_to_sphere(radical_inverse(7, i), radical_inverse(11, i));
        for (int c = 0; c < 3; c++)
            from.raw[c] = glm_lerp(geometry->bounds_min[c], geometry->bounds_max[c],
                                   (float)radical_inverse(bases[c], i));
        struct hit exact;
        struct tree_hit hit;
        bool is_met = ray_scene_hit(&rays, from, to, &exact);
        bool same = triangle_tree_hit(&solids.tree, from, to, &hit) == is_met;
        if (same && is_met)
            same = fabsf(glms_vec3_distance(exact.position, from) - hit.distance) <
                       1e-4F * geometry->radius &&
                   exact.is_back == hit.back;
        met += is_met;
        backs += is_met && exact.is_back;
        other += !same;
    }
    printf("  %s: %d of %d rays meet something, %d a back, %d otherwise than Embree's\n", path, met,
           RAYS, backs, other);
    assert_true(met > RAYS / 4);
    check_at_most("rays that differ", other, RAYS / 100.);
    ray_scene_free(&rays);
    hit_table_free(&table);
    solids_free(&solids);
    stage_free(&stage);
}

static void test_rays(void **state) {
    (void)state;
    check_rays("scenes/cornell-box.glb");
    check_rays("scenes/cornell-animal.glb");
    check_rays("scenes/atrium.glb");
}

/* --- points ----------------------------------------------------------------------------------- */

static void make_double_sided(struct stage *stage, bool double_sided) {
    for (int m = 0; m < stage->scene.material_count; m++)
        stage->scene.materials[m].double_sided = double_sided;
}

struct count {
    int fronts, backs, moving;
    double area;
};

static struct count count_points(const struct stage *stage) {
    struct solids solids;
    struct surface_points points;
    struct count count = {0};
    solids_init(&solids, &stage->scene, &stage->geometry);
    surface_points_init(&points, &(struct surface_points_desc){.scene = &stage->scene,
                                                               .geometry = &stage->geometry,
                                                               .count = 4096,
                                                               .solids = &solids});
    for (int i = 0; i < points.count; i++) {
        const struct surface_point *point = &points.items[i];
        count.backs += point->back;
        count.fronts += !point->back;
        count.moving += solids.moves[stage->geometry.parts[point->part].node];
        count.area += (double)surface_points_place(&points, &stage->geometry, i).area;
    }
    surface_points_free(&points);
    solids_free(&solids);
    return count;
}

/* The Cornell box and its two blocks have no inside to light and no outside to be seen, as if they were
 * single-sided. */
static void test_room(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/cornell-box.glb");
    struct count single = count_points(&stage);
    make_double_sided(&stage, true);
    struct count both = count_points(&stage);
    printf("  single-sided %d in front, %.2f m2; double-sided %d and %d behind, %.2f m2\n",
           single.fronts, single.area, both.fronts, both.backs, both.area);
    check_at_most("share of points behind", both.backs / 4096., .01);
    check_near("area of double-sided surfaces, over the single-sided's", both.area / single.area, 1,
               .02);
    /* Every triangle the other way round: what cameras see are backs. */
    for (uint32_t k = 0; k < stage.geometry.index_count; k += 3) {
        uint32_t *index = &stage.geometry.indices[k], first = index[0];
        index[0] = index[1];
        index[1] = first;
    }
    struct count turned = count_points(&stage);
    printf("  wound the other way %d and %d behind\n", turned.fronts, turned.backs);
    check_near("share of points behind, wound the other way", turned.backs / 4096., .5, .02);
    stage_free(&stage);
}

/* What a clip moves is neither hidden nor hides. */
static void test_moving(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/door.glb");
    make_double_sided(&stage, true);
    struct count clip = count_points(&stage);
    int clips = stage.scene.clip_count;
    stage.scene.clip_count = 0;
    struct count still = count_points(&stage);
    stage.scene.clip_count = clips;
    printf("  %d points on what moves, %d behind; %d behind were it still\n", clip.moving,
           clip.backs, still.backs);
    assert_true(clip.moving > 100);
    check_near("points behind that are of what moves", clip.backs - still.backs, clip.moving / 2.,
               clip.moving / 20.);
    stage_free(&stage);
}

/* --- light ------------------------------------------------------------------------------------ */

/* The mean of a few sets of points, which differ by some 2 %. */
static double mean_of_bounces(const struct stage *stage, int bounces) {
    enum { SETS = 6 };
    double sum = 0;
    for (int seed = 0; seed < SETS; seed++) {
        char settings[64];
        snprintf(settings, sizeof settings, "bounces=%d seed=%d", bounces, seed);
        struct image image = render_stage(stage, "clustered", settings, 48);
        sum += layer_mean(&image, "indirect") / SETS;
        image_free(&image);
    }
    return sum;
}

/* Further bounces are those of the same scene single-sided, of which points within could only take and leak. */
static void test_light(void **state) {
    (void)state;
    struct stage stage;
    double further[2];
    open_stage(&stage, "scenes/cornell-box.glb");
    for (int sides = 1; sides <= 2; sides++) {
        make_double_sided(&stage, sides == 2);
        further[sides - 1] = mean_of_bounces(&stage, 4) - mean_of_bounces(&stage, 1);
    }
    printf("  bounces 2 to 4: %.5f, double-sided %.5f\n", further[0], further[1]);
    check_near("double-sided over single-sided", further[1] / further[0], 1, .02);
    stage_free(&stage);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rays),
        cmocka_unit_test(test_room),
        cmocka_unit_test(test_moving),
        cmocka_unit_test(test_light),
    };
    return cmocka_run_group_tests_name("solids", tests, open_group_context, close_group_context);
}
