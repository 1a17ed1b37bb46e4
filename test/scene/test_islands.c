/* Panels that a tool joined in one primitive: those that do not touch are lamps of their own, as
 * before. */
#include "support.h"

#include "base/memory.h"
#include "scene/lights/emissive.h"
#include "scene/lights/emitter.h"

#include <stdio.h>
#include <string.h>

enum { PANELS_MAX = 60 };

/* A panel that shines down or, turned, up; its texel of a texture of four. */
struct panel {
    float x, z, width, depth;
    bool turned;
    int texel;
};

static void put_panel(struct primitive *to, const struct panel *panel) {
    static const uint32_t corners[2][6] = {{0, 1, 2, 0, 2, 3}, {0, 2, 1, 0, 3, 2}};
    int first = to->vertex_count, start = to->index_count;
    for (int k = 0; k < 4; k++) {
        float *at = to->position[to->vertex_count];
        at[0] = panel->x + (k == 1 || k == 2 ? panel->width : 0);
        at[1] = 2;
        at[2] = panel->z + (k >= 2 ? panel->depth : 0);
        to->uv[0][to->vertex_count][0] = ((float)panel->texel + .5F) / 4;
        to->uv[0][to->vertex_count++][1] = .5F;
    }
    for (int k = 0; k < 6; k++)
        to->indices[start + k] = (uint32_t)first + corners[panel->turned][k];
    to->index_count += 6;
}

/* The second triangles of all panels after the first ones. */
static void mix_triangles(struct primitive *primitive) {
    uint32_t mixed[6 * PANELS_MAX];
    int panels = primitive->index_count / 6;
    for (int i = 0; i < 2 * panels; i++)
        memcpy(&mixed[3 * (i / 2 + i % 2 * panels)], &primitive->indices[3 * i], 3 * sizeof *mixed);
    memcpy(primitive->indices, mixed, (size_t)primitive->index_count * sizeof *mixed);
}

static void make_primitive(struct primitive *primitive, const struct panel *panels, int count) {
    size_t vertices = 4 * (size_t)count;
    *primitive = (struct primitive){.position = mem_alloc(vertices, sizeof *primitive->position),
                                    .uv = {mem_alloc(vertices, sizeof *primitive->uv[0])},
                                    .indices = mem_alloc(6 * (size_t)count, sizeof(uint32_t))};
    for (int i = 0; i < count; i++)
        put_panel(primitive, &panels[i]);
    mix_triangles(primitive);
}

/* In one primitive, or each in its own. */
static void make_scene(struct scene *scene, const struct panel *panels, int count, bool joined,
                       bool double_sided) {
    int primitives = joined ? 1 : count;
    *scene = (struct scene){.path = mem_strdup("panels"), .node_count = 1, .mesh_count = 1};
    scene->material_count = scene->texture_count = 1;
    scene->nodes = mem_alloc(1, sizeof *scene->nodes);
    scene->nodes[0] = (struct node){
        .parent = -1, .light = -1, .camera = -1, .skin = -1, .metaballs = -1, .has_matrix = true};
    for (int c = 0; c < 4; c++)
        scene->nodes[0].matrix[5 * c] = 1;
    scene->textures = mem_alloc(1, sizeof *scene->textures);
    scene->textures[0] = (struct scene_texture){.bitmap = {4, 1, mem_alloc(16, 1)}, .linear = true};
    for (unsigned i = 0; i < 16; i++)
        scene->textures[0].bitmap.rgba[i] = (unsigned char)(i < 4 || i % 4 == 3 ? 255 : 10 * i);
    scene->materials = mem_alloc(1, sizeof *scene->materials);
    scene->materials[0] = (struct material){.emission = {2, 1, 1},
                                            .double_sided = double_sided,
                                            .normal_texture = -1,
                                            .base_color_texture = -1,
                                            .metal_roughness_texture = -1};
    scene->meshes = mem_alloc(1, sizeof *scene->meshes);
    scene->meshes[0].primitives = mem_alloc((size_t)primitives, sizeof(struct primitive));
    scene->meshes[0].primitive_count = primitives;
    for (int i = 0; i < primitives; i++)
        make_primitive(&scene->meshes[0].primitives[i], &panels[i], joined ? count : 1);
    emissive_add_lights(scene);
}

static void check_alike(const struct panel *panels, int count, bool double_sided, int lights) {
    struct scene scenes[2];
    struct emitters all[2];
    for (int joined = 0; joined < 2; joined++) {
        make_scene(&scenes[joined], panels, count, joined, double_sided);
        all[joined] = emitters_place(&scenes[joined], 0);
        check_near(joined ? "lights, joined" : "lights", all[joined].count, lights, 0);
    }
    for (int i = 0; i < lights; i++)
        all[1].items[i].lamp = all[0].items[i].lamp; /* any number does */
    assert_true(emitters_same(&all[0], &all[1]));
    for (int joined = 0; joined < 2; joined++) {
        emitters_free(&all[joined]);
        scene_free(&scenes[joined]);
    }
}

/* Both windings, both sides, several colours, and more than may be lights. */
static void test_apart(void **state) {
    (void)state;
    struct panel panels[PANELS_MAX];
    for (int i = 0; i < PANELS_MAX; i++)
        panels[i] = (struct panel){.4F * (float)i, (float)(i % 3), .3F, .2F, i % 4 == 1, i % 4};
    check_alike(panels, 3, false, 3);
    check_alike(panels, 7, false, 7);
    check_alike(panels, 10, true, 20);
    check_alike(panels, EMISSIVE_LIGHTS_MAX, false, EMISSIVE_LIGHTS_MAX);
    check_alike(panels, PANELS_MAX, false, EMISSIVE_LIGHTS_MAX);
}

static void check_joined(const char *what, const struct panel *panels, int count, int surfaces,
                         int lights) {
    struct scene scene;
    make_scene(&scene, panels, count, true, false);
    printf("    %s: %d surfaces, %d lights\n", what, scene.surface_count, scene.light_count);
    assert_int_equal(scene.surface_count, surfaces);
    if (lights)
        assert_int_equal(scene.light_count, lights);
    assert_int_equal(scene.surfaces[surfaces - 1].end, 6 * count);
    scene_free(&scene);
}

/* What touches is one lamp: a strip with vertices of its own for each panel, though rounded, and
 * panels at a corner. */
static void test_touching(void **state) {
    (void)state;
    static const struct panel strip[] = {{0, 0, 1, 1, false, 0},
                                         {1, 0, 1, 1, false, 0},
                                         {2.0000002F, 0, 1, 1, false, 0}},
                              corner[] = {{0, 0, 1, 1, false, 0}, {1, 1, 1, 1, false, 0}},
                              both[] = {{0, 0, 1, 1, false, 0},
                                        {1, 0, 1, 1, false, 0},
                                        {5, 0, 1, 1, false, 0},
                                        {5, 1, 1, 1, false, 0}},
                              gap[] = {{0, 0, 1, 1, false, 0}, {1.001F, 0, 1, 1, false, 0}};
    check_joined("strip", strip, 3, 1, 1);
    check_joined("corner", corner, 2, 1, 0);
    check_joined("two strips", both, 4, 2, 2);
    check_joined("a gap of a thousandth", gap, 2, 2, 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_apart),
                                       cmocka_unit_test(test_touching)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
