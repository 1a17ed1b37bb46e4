/* Direct light of surface elements: lamps among them, and rays to lights. */
#include "volume_scenes.h"

#include "scene/mesh/bvh_ray.h"
#include "techniques/implicit-visibility/light.h"

struct table {
    struct stage stage;
    struct elements elements;
    struct tree tree;
    struct element_light light;
    struct lamps lamps;
};

static void open_table(struct table *table) {
    const struct geometry *geometry = &table->stage.geometry;
    table->stage = open_stage("scenes/table.glb");
    elements_init(&table->elements, &(struct elements_desc){&table->stage.scene, geometry,
                                                            MATERIALS_DIFFUSE, false, 2000, false});
    tree_init(&table->tree, &table->elements, .3F * geometry->radius);
    element_light_init(&table->light, &table->tree);
    element_light_emit(&table->light, &table->elements, &table->tree);
    lamps_init(&table->lamps, &table->stage.scene, geometry, &table->elements);
}

static void close_table(struct table *table) {
    lamps_free(&table->lamps);
    element_light_free(&table->light);
    tree_free(&table->tree);
    elements_free(&table->elements);
    stage_free(&table->stage);
}

/* W/sr of all elements. */
static void add_up(const struct table *table, double sum[3]) {
    for (int c = 0; c < 3; c++)
        sum[c] = 0;
    for (int i = 0; i < table->elements.count; i++)
        for (int c = 0; c < 3; c++)
            sum[c] += (double)(table->elements.items[i].area * table->light.emission[i][c]);
    printf("  the lamp's elements: %.4f %.4f %.4f W/sr\n", sum[0], sum[1], sum[2]);
}

/* The table's lamp gives its elements what its light has: 6.4 W/sr of red. Dimmed or coloured it
 * gives them that. */
TEST(emission) {
    struct table table;
    double sum[3];
    open_table(&table);
    for (int i = 0; i < table.elements.count; i++)
        assert_int_equal(table.lamps.of_elements[i], table.light.emission[i][0] > 0);
    add_up(&table, sum);
    check_near("emission over the light's", sum[0] / 6.4, 1, .01);
    struct emitters emitters = emitters_copy(&table.stage.emitters);
    emitters.items[0].intensity[0] *= .5F;
    emitters.items[0].intensity[2] = 0;
    lamps_follow(&table.lamps, &emitters);
    element_light_dim(&table.light, &table.elements, &table.tree, &table.lamps);
    add_up(&table, sum);
    check_near("red over half of the lamp's", sum[0] / 3.2, 1, .01);
    check_near("green over the lamp's", sum[1] / 6.08, 1, .01);
    check_at_most("blue", sum[2], 0);
    emitters_free(&emitters);
    close_table(&table);
}

/* Rays to lights pass through holes of alpha masks. */
TEST(masks) {
    struct bvh casters, panes = {0};
    int holes = 0, hits = 0;
    OWNED(stage) stage = open_stage("scenes/materials.glb");
    element_light_casters(&casters, &panes, &stage.scene, &stage.geometry);
    for (uint32_t t = 0; t < stage.geometry.index_count / 3; t++) {
        vec3s edges[2],
            corner = corners_edges(&stage.geometry, &stage.geometry.indices[3 * t], edges);
        vec3s normal = vec3s_unit(glms_vec3_cross(edges[0], edges[1]));
        for (int k = 0; k < 100; k++) {
            float u = ((float)(k % 10) + .4F) / 10, v = ((float)(k / 10) + .4F) / 10;
            vec3s place = glms_vec3_muladds(edges[0], u, corner);
            place =
                glms_vec3_add(glms_vec3_muladds(edges[1], v, place), glms_vec3_scale(normal, .01F));
            if (u + v >= 1)
                continue;
            hits++;
            holes +=
                !(bvh_ray_trace_opaque(&casters, place, glms_vec3_negate(normal)).distance < .02F);
        }
    }
    printf("  %d of %d places of triangles are holes\n", holes, hits);
    check_at_most("holes", 100, holes);
    check_at_most("holes", holes, hits / 4);
    bvh_free(&panes);
    bvh_free(&casters);
}

RUN_TESTS(open_group_context, close_group_context)
