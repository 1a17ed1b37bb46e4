/* Nodes that share a mesh look as nodes with meshes of their own: the same bits of a frame, and the
 * same paths. The GPU has one copy of their indices. */
#include "render_support.h"

#include "inspect/aov.h"

#include <cglm/cglm.h>

enum { SIZE = 96, PLACES = 4 };

/* Places of more animals: plain, mirrored twice, and turned with a scale for each axis. */
static const struct {
    float scale[3], angle, translation[3];
} places[PLACES] = {
    {{.5F, .5F, .5F}, 0, {-1.7F, 0, 1}},
    {{-.4F, .5F, .4F}, 0, {1.7F, 0, 1.4F}},
    {{.3F, -.5F, .6F}, .7F, {-1, 3.5F, 0}},
    {{.3F, .8F, .5F}, -.5F, {1.4F, 1.8F, -1}},
};

static int node_of_animal(const struct geometry *geometry) {
    const struct geometry_part *largest = geometry->parts;
    for (int i = 0; i < geometry->part_count; i++)
        if (geometry->parts[i].index_count > largest->index_count)
            largest = &geometry->parts[i];
    return largest->node;
}

static void add_node(struct scene *scene, int of, float world[16], int place) {
    mat4 matrix;
    glm_translate_make(matrix, (float *)places[place].translation);
    glm_rotate(matrix, places[place].angle, (vec3){0, 1, 1});
    glm_scale(matrix, (float *)places[place].scale);
    glm_mat4_mul(matrix, (vec4 *)world, matrix);
    scene->nodes = mem_resize(scene->nodes, (size_t)scene->node_count + 1, sizeof *scene->nodes);
    struct node *node = &scene->nodes[scene->node_count++];
    *node = scene->nodes[of];
    node->parent = -1;
    node->has_matrix = true;
    memcpy(node->matrix, matrix, sizeof node->matrix);
}

/* A mesh of its own for the last node: a copy of the one it has. */
static void copy_mesh(struct scene *scene) {
    struct node *node = &scene->nodes[scene->node_count - 1];
    scene->meshes = mem_resize(scene->meshes, (size_t)scene->mesh_count + 1, sizeof *scene->meshes);
    struct mesh *copy = &scene->meshes[scene->mesh_count];
    *copy = scene->meshes[node->mesh];
    node->mesh = scene->mesh_count++;
    copy->primitives =
        mem_copy(copy->primitives, (size_t)copy->primitive_count, sizeof *copy->primitives);
    for (int p = 0; p < copy->primitive_count; p++) {
        struct primitive *primitive = &copy->primitives[p];
        size_t count = (size_t)primitive->vertex_count;
        assert_true(!primitive->joints && !primitive->targets);
        if (primitive->color)
            primitive->color = mem_copy(primitive->color, count, sizeof *primitive->color);
        primitive->position = mem_copy(primitive->position, count, sizeof *primitive->position);
        primitive->normal = mem_copy(primitive->normal, count, sizeof *primitive->normal);
        for (int m = 0; m < MAPPINGS_MAX; m++)
            if (primitive->uv[m])
                primitive->uv[m] = mem_copy(primitive->uv[m], count, sizeof *primitive->uv[m]);
        primitive->indices = mem_copy(primitive->indices, (size_t)primitive->index_count,
                                      sizeof *primitive->indices);
    }
}

enum look { PLAIN, GLOWING, MASKED };

/* Colours of vertices with holes, through which backs are seen. */
static void make_holes(struct primitive *primitive, struct material *material) {
    size_t count = (size_t)primitive->vertex_count;
    primitive->color = mem_alloc(count, sizeof *primitive->color);
    for (size_t i = 0; i < count; i++) {
        glm_vec3_one(primitive->color[i]);
        primitive->color[i][3] = .5F + .5F * sinf(40 * primitive->position[i][1]);
    }
    material->alpha_mask = true;
    material->double_sided = false;
}

/* Five animals, by one mesh or by five. */
static struct stage open_animals(bool copied, enum look look) {
    struct stage stage = open_stage("scenes/cornell-animal.glb");
    struct scene *scene = &stage.scene, taken;
    int of = node_of_animal(&stage.geometry);
    float world[16];
    struct primitive *primitive = &scene->meshes[scene->nodes[of].mesh].primitives[0];
    struct material *material = &scene->materials[primitive->material];
    memcpy(world, stage.geometry.pose.worlds[of], sizeof world);
    if (look == MASKED)
        make_holes(primitive, material);
    for (int i = 0; i < PLACES; i++) {
        add_node(scene, of, world, i);
        if (copied)
            copy_mesh(scene);
    }
    if (look == GLOWING) {
        glm_vec3_copy((vec3){3, 2, 1}, material->emission);
        check_ok("take", scene_take(&taken, scene));
        stage.scene = taken;
    }
    pose_stage(&stage);
    return stage;
}

static struct image draw(const struct stage *stage, const char *settings) {
    struct renderer_desc desc = desc_of(stage, "clustered", settings, SIZE, SIZE);
    OWNED(renderer) renderer;
    struct image image;
    open_renderer(&renderer, desc);
    check_ok("read", renderer_read_layers(&renderer, &image));
    check_ok("append", aov_append(&renderer, "id.node,position", NULL, &image));
    return image;
}

static void check_frames(enum look look, const char *settings) {
    struct stage shared = open_animals(false, look), copied = open_animals(true, look);
    OWNED(image) a = draw(&shared, settings);
    OWNED(image) b = draw(&copied, settings);
    check_near("mean of shared meshes", layer_mean(&a, "indirect"), layer_mean(&b, "indirect"), 0);
    assert_true(same_pixels(&a, &b));
    stage_free(&shared);
    stage_free(&copied);
}

TEST(frames) {
    check_frames(PLAIN, "path=maps");
    check_frames(MASKED, "path=traced samples=8");
    check_frames(GLOWING, "");
}

/* Three animals as the file winds them and two mirrored ones need two copies; the first animal and
 * two plain ones have one, and so have the mirrored ones. */
TEST(one_copy_of_indices) {
    struct stage stage = open_animals(false, PLAIN);
    const struct geometry *geometry = &stage.geometry;
    OWNED(renderer) renderer;
    uint32_t animal = 0;
    for (int i = 0; i < geometry->part_count; i++)
        animal = geometry->parts[i].index_count > animal ? geometry->parts[i].index_count : animal;
    open_renderer(&renderer, desc_of(&stage, "clustered", "", SIZE, SIZE));
    assert_int_equal(renderer.scene.indices.size,
                     (geometry->index_count - 3 * animal) * sizeof *geometry->indices);
    stage_free(&stage);
}

static struct image trace(const struct stage *stage) {
    struct image image;
    check_ok("trace",
             path_tracer_render(&FILLED(path_tracer_desc, .scene = &stage->scene,
                                        .geometry = &stage->geometry, .camera = &stage->camera,
                                        .emitters = stage->emitters, .width = SIZE, .height = SIZE,
                                        .samples = 4, .bounces = 2,
                                        .surface_layers = "id.node,id.material"),
                                &image, NULL));
    return image;
}

/* Part of the pixels where a channel is off by more than that part of its mean. */
static double off(const struct image *a, const struct image *b, const char *name, double most) {
    int of_a = image_find_channel(a, name), of_b = image_find_channel(b, name), count = 0;
    double sum = 0;
    assert_true(of_a >= 0 && of_b >= 0);
    for (int i = 0; i < SIZE * SIZE; i++)
        sum += fabs((double)image_at(b, i % SIZE, i / SIZE)[of_b]);
    for (int i = 0; i < SIZE * SIZE; i++)
        count +=
            !(fabs((double)image_at(a, i % SIZE, i / SIZE)[of_a] -
                   (double)image_at(b, i % SIZE, i / SIZE)[of_b]) <= most * sum / (SIZE * SIZE));
    return (double)count / (SIZE * SIZE);
}

/* Embree turns rays for instances. Rounding sends a few paths past an edge, or to the other side of
 * it; each changes one pixel. */
static void check_paths(enum look look) {
    static const char *const layers[] = {"id.node",  "id.material", "Z",       "normal.X",
                                         "normal.Y", "normal.Z",    "albedo.G"};
    struct stage shared = open_animals(false, look), copied = open_animals(true, look);
    OWNED(image) a = trace(&shared);
    OWNED(image) b = trace(&copied);
    for (size_t i = 0; i < sizeof layers / sizeof *layers; i++)
        check_at_most(layers[i], off(&a, &b, layers[i], 1e-4), .005);
    check_at_most("paths", off(&a, &b, "indirect.G", 1e-4), .02);
    check_near("direct", layer_mean(&a, "direct"), layer_mean(&b, "direct"),
               1e-3 * layer_mean(&b, "direct"));
    check_near("indirect", layer_mean(&a, "indirect"), layer_mean(&b, "indirect"),
               1e-3 * layer_mean(&b, "indirect"));
    stage_free(&shared);
    stage_free(&copied);
}

TEST(paths) {
    check_paths(PLAIN);
    check_paths(GLOWING);
    check_paths(MASKED);
}

RUN_TESTS(open_group_context, close_group_context)
