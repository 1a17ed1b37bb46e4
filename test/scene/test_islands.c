/* Panels that a tool joined in one primitive: those that do not touch are lamps of their own, as
 * before. So are the faces of a box. */
#include "support.h"

#include "scene/lights/emissive.h"
#include "scene/lights/emitter.h"

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

/* A scene of one mesh, whose primitives are empty. */
static void start_scene(struct scene *scene, int primitives, bool double_sided) {
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
    scene->materials[0] =
        FILLED(material, .emission = {2, 1, 1}, .double_sided = double_sided, .normal_texture = -1,
               .base_color_texture = -1, .metal_roughness_texture = -1);
    scene->meshes = mem_alloc(1, sizeof *scene->meshes);
    scene->meshes[0].primitives = mem_alloc((size_t)primitives, sizeof(struct primitive));
    scene->meshes[0].primitive_count = primitives;
}

/* In one primitive, or each in its own. */
static void make_scene(struct scene *scene, const struct panel *panels, int count, bool joined,
                       bool double_sided) {
    int primitives = joined ? 1 : count;
    start_scene(scene, primitives, double_sided);
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
TEST(apart) {
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
TEST(touching) {
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

/* A solid of eight corners; `top` scales its upper four: below 1 the sides are no rectangles. */
static void make_solid(struct primitive *primitive, const float size[3], float top) {
    static const uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
    *primitive = FILLED(
        primitive, .vertex_count = 8, .position = mem_alloc(8, sizeof *primitive->position),
        .uv = {mem_alloc(8, sizeof *primitive->uv[0])}, .indices = mem_alloc(36, sizeof(uint32_t)));
    for (int i = 0; i < 8; i++)
        primitive->uv[0][i][0] = .125F;
    for (int i = 0; i < 8; i++)
        for (int c = 0; c < 3; c++)
            primitive->position[i][c] =
                (i >> c & 1 ? .5F : -.5F) * size[c] * (i & 4 && c < 2 ? top : 1);
    for (int half = 0; half < 2; half++)
        for (int i = 0; i < 6; i++)
            for (int k = 0; k < 3; k++)
                primitive->indices[primitive->index_count++] = quads[i][k ? k + half : 0];
}

static void make_solid_lamp(struct scene *scene, const float size[3], float top) {
    start_scene(scene, 1, false);
    make_solid(&scene->meshes[0].primitives[0], size, top);
    emissive_add_lights(scene);
}

/* Each face of a box shines as it is, however thin the box. */
TEST(box) {
    static const float sizes[][3] = {{1, 1, 1}, {2, 1, .3F}, {.6F, .3F, .01F}};
    for (int i = 0; i < 3; i++) {
        OWNED(scene) scene;
        make_solid_lamp(&scene, sizes[i], 1);
        OWNED(emitters) lights = emitters_place(&scene, 0);
        assert_int_equal(lights.count, 6);
        for (int n = 0; n < lights.count; n++) {
            const struct emitter *light = &lights.items[n];
            int axis = 0;
            for (int c = 1; c < 3; c++)
                if (fabsf(light->direction[c]) > fabsf(light->direction[axis]))
                    axis = c;
            double area = (double)(sizes[i][(axis + 1) % 3] * sizes[i][(axis + 2) % 3]);
            check_near("W/sr of a face", (double)light->intensity[0] / area, 2, 1e-3);
            check_near("its place", fabs((double)light->position[axis]), (double)sizes[i][axis] / 2,
                       1e-3);
        }
    }
}

/* A solid with other faces is one lamp of several rectangles. */
TEST(no_box) {
    OWNED(scene) scene;
    make_solid_lamp(&scene, (const float[]){1, 1, .2F}, .5F);
    assert_int_equal(scene.surface_count, 1);
    assert_int_equal(scene.light_count, STAND_INS_MAX);
}

/* Strips have triangles without area from one panel to the next: these join nothing. */
TEST(bridge) {
    static const struct panel panels[] = {{0, 0, 1, 1, false, 0}, {5, 0, 1, 1, false, 0}};
    OWNED(scene) scene;
    start_scene(&scene, 1, false);
    struct primitive *primitive = &scene.meshes[0].primitives[0];
    make_primitive(primitive, panels, 2);
    primitive->indices = mem_resize(primitive->indices, 15, sizeof(uint32_t));
    memcpy(&primitive->indices[12], (const uint32_t[]){3, 3, 4}, 3 * sizeof(uint32_t));
    primitive->index_count = 15;
    emissive_add_lights(&scene);
    assert_int_equal(scene.light_count, 2);
}

RUN_TESTS(NULL, NULL)
