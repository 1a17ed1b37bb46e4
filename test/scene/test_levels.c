/* Levels of detail: their triangles, which views choose them, and that instances have the same. */
#include "render_support.h"

#include "scene/gpu/culling.h"
#include "scene/mesh/simplify.h"

#include <cglm/cglm.h>

/* Adds a node with the mesh of another, moved along x and scaled by 1.5. */
static void add_instance(struct stage *stage, int of) {
    struct scene *scene = &stage->scene;
    scene->nodes = mem_resize(scene->nodes, (size_t)scene->node_count + 1, sizeof *scene->nodes);
    struct node *node = &scene->nodes[scene->node_count++];
    *node = scene->nodes[of];
    node->parent = of;
    node->weights = NULL;
    node->has_matrix = false;
    memcpy(node->translation, (float[3]){2, 0, 0}, sizeof node->translation);
    memcpy(node->rotation, (float[4]){0, 0, 0, 1}, sizeof node->rotation);
    memcpy(node->scale, (float[3]){1.5F, 1.5F, 1.5F}, sizeof node->scale);
    pose_stage(stage);
}

/* The animal of 16,976 triangles, twice. */
static void open_twins(struct stage *stage, struct levels *levels) {
    *stage = open_stage("scenes/cornell-animal.glb");
    levels_init(levels, &stage->scene, &stage->geometry);
    assert_int_equal(levels->part_count, 1);
    int node = stage->geometry.parts[levels->parts[0].part].node;
    levels_free(levels);
    add_instance(stage, node);
    levels_init(levels, &stage->scene, &stage->geometry);
    assert_int_equal(levels->part_count, 2);
    assert_int_equal(levels->shape_count, 1);
}

/* Whether each edge has a triangle on both sides: the sum of an antisymmetric hash of the directed
 * edges is zero. */
static bool is_closed(const uint32_t *indices, uint32_t count) {
    uint64_t sum = 0;
    for (uint32_t k = 0; k < count; k++) {
        uint64_t a = indices[k], b = indices[k % 3 == 2 ? k - 2 : k + 1];
        uint64_t low = a < b ? a : b, high = a ^ b ^ low;
        uint64_t hash = (low * 0x9e3779b97f4a7c15U ^ high) * 0xc2b2ae3d27d4eb4fU;
        sum += a < b ? hash : -hash;
    }
    return sum == 0;
}

/* A long strip of triangles without area ends, though its triangles can go from its ends alone. */
TEST(chain) {
    enum { COUNT = 1 << 20 };
    static float position[COUNT + 2][3];
    static uint32_t indices[COUNT][3], moved[COUNT + 2];
    for (uint32_t v = 0; v < COUNT + 2; v++)
        memcpy(position[v], (float[3]){(float)v * 1e-4F, 0, 0}, sizeof position[v]);
    for (uint32_t t = 0; t < COUNT; t++)
        memcpy(indices[t], (uint32_t[3]){t, t + 1, t + 2}, sizeof indices[t]);
    simplify_mesh(&(struct simplify_mesh){position, *indices, NULL, COUNT + 2, 3 * COUNT, NULL},
                  &(struct simplify_desc){.error = 1}, moved);
    for (uint32_t v = 0; v < COUNT + 2; v++)
        assert_true(moved[v] < COUNT + 2 && moved[moved[v]] == moved[v]);
}

/* Each level has fewer triangles and a larger error than the one before. It is closed, as the
 * animal is. The larger instance has the same triangles, with errors 1.5 times as large. */
TEST(twins) {
    struct stage stage;
    struct levels levels;
    open_twins(&stage, &levels);
    const struct level_part *part = levels.parts;
    const struct geometry_part *parts = stage.geometry.parts;
    uint32_t before = part->index_count, found = 0;
    uint32_t apart = parts[part[1].part].first_vertex - parts[part[0].part].first_vertex;
    float error = 0;
    assert_int_equal(part[1].base - part->base, apart);
    assert_true(is_closed(stage.geometry.indices + part->first_index, part->index_count));
    for (int l = 0; l < LEVEL_COUNT; l++) {
        if (isinf(part->error[l]))
            continue;
        assert_true(part->error[l] > error && part->count[l] < before && part->count[l] > 0);
        assert_true(is_closed(levels.indices + part->first[l], part->count[l]));
        check_near("error of twin over error", (double)(part[1].error[l] / part->error[l]), 1.5,
                   1e-5);
        assert_int_equal(part[1].count[l], part->count[l]);
        assert_int_equal(part[1].first[l], part->first[l]);
        before = part->count[l];
        error = part->error[l];
        found++;
    }
    assert_true(found >= 2);
    check_at_most("triangles left", before, part->index_count / 4.);
    levels_free(&levels);
    stage_free(&stage);
}

/* The vertices of instances collapse onto the same ones, where the size of the mesh bounds the
 * error. */
TEST(casters_of_twins) {
    struct stage stage;
    struct levels levels;
    open_twins(&stage, &levels);
    const struct geometry_part *one = &stage.geometry.parts[levels.parts[0].part];
    const struct geometry_part *other = &stage.geometry.parts[levels.parts[1].part];
    uint32_t *moved_to = simplify_geometry(
        &stage.geometry,
        &(struct simplify_desc){.error = 1, .scene = &stage.scene, .levels = &levels});
    uint32_t moved = 0;
    for (uint32_t v = 0; v < one->vertex_count; v++) {
        uint32_t to = moved_to[one->first_vertex + v] - one->first_vertex;
        assert_int_equal(moved_to[other->first_vertex + v] - other->first_vertex, to);
        moved += to != v;
    }
    assert_true(moved > one->vertex_count / 2);
    free(moved_to);
    levels_free(&levels);
    stage_free(&stage);
}

/* Three animals in one mesh, side by side: 50,928 triangles. */
static void join_three(struct stage *stage) {
    *stage = open_stage("scenes/cornell-animal.glb");
    struct primitive *animal = NULL;
    for (int m = 0; m < stage->scene.mesh_count; m++)
        if (stage->scene.meshes[m].primitives[0].index_count > 3000)
            animal = &stage->scene.meshes[m].primitives[0];
    assert_null(animal->uv[0]);
    size_t vertices = (size_t)animal->vertex_count, indices = (size_t)animal->index_count;
    animal->position = mem_resize(animal->position, 3 * vertices, sizeof *animal->position);
    animal->normal = mem_resize(animal->normal, 3 * vertices, sizeof *animal->normal);
    animal->indices = mem_resize(animal->indices, 3 * indices, sizeof *animal->indices);
    for (size_t v = vertices; v < 3 * vertices; v++) {
        glm_vec3_add(animal->position[v - vertices], (vec3){2, 0, 0}, animal->position[v]);
        glm_vec3_copy(animal->normal[v - vertices], animal->normal[v]);
    }
    for (size_t k = indices; k < 3 * indices; k++)
        animal->indices[k] = animal->indices[k - indices] + (uint32_t)vertices;
    animal->vertex_count *= 3;
    animal->index_count *= 3;
    pose_stage(stage);
}

/* In no spatial order pieces would share nearly all vertices: the mesh is one piece with levels. */
TEST(shuffled) {
    OWNED(stage) stage;
    OWNED(levels) levels;
    join_three(&stage);
    for (int m = 0; m < stage.scene.mesh_count; m++) {
        struct primitive *primitive = &stage.scene.meshes[m].primitives[0];
        int triangles = primitive->index_count / 3;
        for (int i = 0; i < triangles; i++)
            for (int c = 0, other = (int)((long)i * 7919 % triangles); c < 3; c++) {
                uint32_t *a = &primitive->indices[3 * i + c],
                         *b = &primitive->indices[3 * other + c], first = *a;
                *a = *b;
                *b = first;
            }
    }
    pose_stage(&stage);
    levels_init(&levels, &stage.scene, &stage.geometry);
    assert_int_equal(levels.part_count, 1);
    const struct level_part *part = &levels.parts[0];
    uint32_t fewest = part->index_count;
    for (int l = 0; l < LEVEL_COUNT; l++)
        if (!isinf(part->error[l]))
            fewest = part->count[l];
    check_at_most("indices left", fewest, part->index_count / 4.); /* as test_twins */
}

/* Each piece of a large mesh chooses its level, and no crack opens between pieces of any. */
TEST(pieces) {
    OWNED(stage) stage;
    OWNED(levels) levels;
    join_three(&stage);
    levels_init(&levels, &stage.scene, &stage.geometry);
    assert_true(levels.part_count >= 16);
    const struct geometry_part *whole = &stage.geometry.parts[levels.parts[0].part];
    uint32_t *drawn = mem_alloc(whole->index_count, sizeof *drawn), count = 0;
    uint32_t end = whole->first_index;
    for (int i = 0; i < levels.part_count; i++) {
        const struct level_part *piece = &levels.parts[i];
        int level = i % (LEVEL_COUNT + 1) - 1; /* -1: all triangles */
        bool levelled = level >= 0 && !isinf(piece->error[level]);
        const uint32_t *from = levelled ? levels.indices + piece->first[level]
                                        : stage.geometry.indices + piece->first_index;
        uint32_t own = levelled ? piece->count[level] : piece->index_count;
        assert_int_equal(piece->first_index, end);
        end += piece->index_count;
        memcpy(drawn + count, from, own * sizeof *from);
        count += own;
        check_at_most("width of a piece", (double)(piece->box[1][0] - piece->box[0][0]),
                      (double)(whole->bounds_max[0] - whole->bounds_min[0]) / 2);
    }
    assert_int_equal(end, whole->first_index + whole->index_count);
    assert_true(is_closed(drawn, count) && count < whole->index_count);
    free(drawn);
}

/* Half a picture is as wide as the distance. A box from 3 to 5 m shows 1 % of half the picture as
 * 3 cm at its nearest point. Behind the camera nothing is drawn. */
TEST(choice) {
    struct view near = {.right = {1, 0, 0}, .up = {0, 1, 0}, .forward = {0, 0, -1}, .near = .1F};
    float box[2][3] = {{-1, -1, -5}, {1, 1, -3}}, behind[2][3] = {{-1, -1, 3}, {1, 1, 5}};
    float ahead[2][3] = {{-1, -1, -5}, {1, 1, 1}};
    glm_mat4_zero(near.world_to_clip);
    near.world_to_clip[0][0] = near.world_to_clip[1][1] = 1;
    near.world_to_clip[2][3] = -1;
    near.world_to_clip[3][2] = near.near;
    struct draw_views views = {.count = 1, .first = &near, .coarseness = .01F};
    const float errors[] = {.0299F, .0301F, INFINITY};
    assert_int_equal(culling_level(&views, box, errors, 3), 1);
    assert_int_equal(culling_level(&views, box, errors + 1, 2), 0);
    assert_int_equal(culling_level(&views, behind, errors, 3), -1);
    assert_int_equal(culling_level(&views, ahead, errors, 3), 0);
    struct view both[2] = {near, near};
    both[1].origin[2] = 3; /* farther off */
    struct draw_views pair = {.count = 2, .first = both, .stride = sizeof near, .coarseness = .01F};
    assert_int_equal(culling_level(&pair, box, errors, 3), 1);
    views.first = &both[1];
    assert_int_equal(culling_level(&views, box, errors, 3), 2);
    views.coarseness = 0;
    assert_int_equal(culling_level(&views, behind, errors, 3), 0);
}

RUN_TESTS(open_group_context, close_group_context)
