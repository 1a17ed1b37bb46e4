/* The scenes that make_scenes writes, read back through the loader. */
#include "command_support.h"
#include "surface_shape.h"

#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/medium.h"
#include "scene/scene.h"

/* What each scene must be. `open` names the nodes that need not be closed solids. */
static const struct expectation {
    const char *name;
    int triangles, tolerance, least_materials;
    float low[3], high[3];
    const char *open;
} expectations[] = {
#define ROOM                                                                                       \
    {-2.79f, 0.0f, -2.797f}, {                                                                     \
        2.79f, 5.489f, 2.797f                                                                      \
    }
#define WALLS "|floor|ceiling|back wall|right wall|left wall|lamp|"
    {"cornell-box", 36, 0, 4, ROOM, WALLS},
    {"three-lights", 36, 0, 4, ROOM, WALLS},
    {"cornell-animal", 17012, 0, 5, ROOM, WALLS},
    {"metaballs", 5012, 200, 5, ROOM, WALLS},
    {"atrium", 98000, 1000, 12, {-13.91f, -0.31f, -7.66f}, {13.91f, 10.26f, 7.66f}, ""},
    /* Bounds of meshes at rest, before their nodes place them. */
    {"moving-spot", 36, 0, 4, ROOM, WALLS},
    {"door", 120, 0, 3, {-4.31f, -0.21f, -2.21f}, {4.31f, 3.21f, 2.21f}, ""},
    {"character", 4012, 0, 5, {-2.79f, -0.01f, -2.797f}, {2.79f, 5.489f, 2.797f}, WALLS},
    {"creatures", 105480, 0, 15, {-13.91f, -0.31f, -7.66f}, {13.91f, 10.26f, 7.66f}, ""},
    {"plant", 1552, 0, 5, {-2, 0, -2}, {3, 2.6f, 2}, "|floor|back wall|far wall|window|leaves|"},
    {"table", 1038, 0, 5, {-3, 0, -2}, {3, 3, 3}, "|floor|wall|lamp|"},
    {"gloss", 17832, 0, 14, {-2, 0, -2}, {2, 2.6f, 2}, WALLS},
    {"materials", 42, 0, 17, {-3, -.3f, -.3f}, {3, 4.3f, 0}, "|wall|dome|wrap|alpha|lamp|"},
    {"roughness", 36490, 0, 28, {-3, -.3f, -1}, {3, 5, 6.5f}, WALLS},
    {"courtyard", 156, 0, 4, {-4.3F, -.2F, -3.3F}, {4.3F, 4, 3.3F}, ""},
    {"hall", 204, 0, 4, {-6.3F, -.3F, -3.3F}, {6.3F, 6.3F, 3.3F}, ""},
    {"ring", 8196, 0, 3, {-4, 0, -4}, {4, 5, 4}, "|table|wall|"},
    {"pawns", 6148, 0, 4, {-4, 0, -4}, {4, 5, 4}, "|table|wall|"},
    {"gem", 68, 0, 3, {-4, 0, -4}, {4, 5, 4}, "|table|wall|"},
    {"window",
     256,
     0,
     9,
     {-3.2F, -.2F, -4.2F},
     {3.2F, 5.2F, 3.2F},
     "|red|blue|yellow|green|white|"},
    {"vase", 6556, 0, 4, {-2, 0, -1}, {2, 2, 2}, "|floor|wall|vase|"},
    {"sphere", 20172, 0, 1, {-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}, ""},
};
enum { SCENE_COUNT = sizeof expectations / sizeof expectations[0] };

static void run_tool(int status, const char *folder, const char *names) {
    expect(status, form("mkdir -p @/%s/failures && " BUILD "/scenes/make_scenes @/%s %s", folder,
                        folder, names));
}

/* --- reading back ----------------------------------------------------------------------------- */

struct corner {
    float position[3];
    uint32_t vertex;
};

static int compare_corners(const void *a, const void *b) {
    return memcmp(a, b, sizeof(float[3]));
}

/* The primitive with vertices at the same place made one. */
static struct surface weld(const struct primitive *primitive) {
    struct surface surface = {0};
    uint32_t count = (uint32_t)primitive->vertex_count;
    struct corner *corners = mem_alloc(count, sizeof *corners);
    uint32_t *welded = mem_alloc(count, sizeof *welded);
    for (uint32_t i = 0; i < count; i++) {
        /* Adding 0 makes -0 and 0 the same bytes. */
        for (int k = 0; k < 3; k++)
            corners[i].position[k] = primitive->position[i][k] + 0.0f;
        corners[i].vertex = i;
    }
    qsort(corners, count, sizeof *corners, compare_corners);
    for (uint32_t i = 0; i < count; i++) {
        if (i == 0 || compare_corners(&corners[i], &corners[i - 1]) != 0)
            surface_add_vertex(&surface, corners[i].position, primitive->normal[corners[i].vertex]);
        welded[corners[i].vertex] = surface.vertex_count - 1;
    }
    for (int i = 0; i < primitive->index_count; i += 3)
        surface_add_triangle(&surface, welded[primitive->indices[i]],
                             welded[primitive->indices[i + 1]], welded[primitive->indices[i + 2]]);
    mem_free(corners, welded);
    return surface;
}

static bool may_be_open(const struct expectation *expected, const struct scene *scene,
                        const struct node *node) {
    const struct primitive *primitive = &scene->meshes[node->mesh].primitives[0];
    const char *quoted = form("|%s|", node->name);
    return scene->materials[primitive->material].double_sided || strstr(expected->open, quoted);
}

/* --- checks ----------------------------------------------------------------------------------- */

static void check_materials(const struct expectation *expected, const struct scene *scene) {
    assert_true(scene->material_count >= expected->least_materials);
    for (int i = 0; i < scene->material_count; i++)
        for (int k = 0; k < 3; k++)
            assert_true(scene->materials[i].base_color[k] > 0.0f &&
                        scene->materials[i].base_color[k] <= 1.0f);
}

static void check_vertices(const struct expectation *expected, const struct primitive *primitive) {
    double worst_length = 0.0;
    for (int i = 0; i < primitive->vertex_count; i++) {
        for (int k = 0; k < 3; k++)
            assert_true(primitive->position[i][k] >= expected->low[k] - 1e-5f &&
                        primitive->position[i][k] <= expected->high[k] + 1e-5f);
        worst_length = fmax(worst_length, fabs((double)glm_vec3_norm(primitive->normal[i]) - 1.0));
    }
    check_at_most("normals' distance from unit", worst_length, 1e-4);
}

/* Vertex normals lie on the side that the winding says. In a fold no normal may fit all triangles
 * around: one corner in 5000 is let pass. */
static void check_sides(const struct primitive *primitive) {
    struct surface surface = {.position = primitive->position,
                              .normal = primitive->normal,
                              .indices = primitive->indices,
                              .vertex_count = (uint32_t)primitive->vertex_count,
                              .index_count = (uint32_t)primitive->index_count};
    struct surface_shape shape = measure_surface(&surface);
    check_at_most("corners whose normal points to the back", shape.wrong_normals,
                  primitive->index_count / 5000);
    assert_true(shape.area > 0.0);
}

static void check_mesh(const struct expectation *expected, const struct scene *scene,
                       const struct node *node) {
    const struct primitive *primitive = &scene->meshes[node->mesh].primitives[0];
    printf("  %s, %s: %d triangles\n", expected->name, node->name, primitive->index_count / 3);
    check_vertices(expected, primitive);
    check_sides(primitive);
    if (may_be_open(expected, scene, node))
        return;
    struct surface welded = weld(primitive);
    check_near("open edges", measure_surface(&welded).unpaired_edges, 0.0, 0.0);
    surface_free(&welded);
}

static int lights_of(const struct expectation *expected) {
    if (strcmp(expected->name, "courtyard") == 0)
        return 0;
    if (strcmp(expected->name, "materials") == 0)
        return 6;
    return strcmp(expected->name, "three-lights") == 0 ? 3 : 1;
}

static void check_scene(const struct expectation *expected, const char *path) {
    OWNED(scene) scene;
    check_ok(path, scene_load(&scene, path));
    int triangles = 0;
    for (int i = 0; i < scene.node_count; i++)
        if (scene.nodes[i].mesh >= 0) {
            check_mesh(expected, &scene, &scene.nodes[i]);
            triangles += scene.meshes[scene.nodes[i].mesh].primitives[0].index_count / 3;
        }
    check_near(expected->name, triangles, expected->triangles, expected->tolerance);
    check_materials(expected, &scene);
    assert_int_equal(camera_node_count(&scene), 1);
    assert_int_equal(emitter_node_count(&scene), lights_of(expected));
    assert_int_equal(scene.environment != NULL, strcmp(expected->name, "courtyard") == 0);
    assert_int_equal(medium_exists(&scene.medium), strcmp(expected->name, "hall") == 0 ||
                                                       strcmp(expected->name, "gem") == 0 ||
                                                       strcmp(expected->name, "window") == 0);
}

/* --- tests ------------------------------------------------------------------------------------ */

static void scene_path(const char *name, char *path, size_t size) {
    snprintf(path, size, "%s/%s.glb", scratch("scenes"), name);
}

TEST(every_scene) {
    char path[512];
    run_tool(0, "scenes", "");
    for (int i = 0; i < SCENE_COUNT; i++) {
        scene_path(expectations[i].name, path, sizeof path);
        check_scene(&expectations[i], path);
    }
}

/* The bytes are the same in another folder, and a second run leaves the files alone. */
TEST(the_same_bytes) {
    run_tool(0, "again", "cornell-box sphere metaballs");
    for (int i = 0; i < SCENE_COUNT; i++)
        expect(0, form("test ! -f @/again/%s.glb || cmp @/again/%s.glb @/scenes/%s.glb",
                       expectations[i].name, expectations[i].name, expectations[i].name));
    expect(0, "touch -d '2001-01-01' @/again/sphere.glb");
    run_tool(0, "again", "sphere");
    expect(0, "find @/again -newermt '2002-01-01' -name 'sphere*'");
    assert_string_equal(output, "");
}

TEST(tool_refuses) {
    run_tool(1, "scenes", "no-such-scene");
    expect_text("no-such-scene");
    expect(2, BUILD "/scenes/make_scenes");
    expect(1, BUILD "/scenes/make_scenes /nowhere sphere");
    expect_text("/nowhere/sphere.glb");
}

/* The closed form of the sphere holds to the same degree as its area does. */
TEST(sphere_is_round) {
    char path[512];
    run_tool(0, "scenes", "sphere");
    scene_path("sphere", path, sizeof path);
    OWNED(scene) scene;
    check_ok(path, scene_load(&scene, path));
    struct surface welded = weld(&scene.meshes[0].primitives[0]);
    struct surface_shape shape = measure_surface(&welded);
    check_near("area / 4 pi", shape.area / (4.0 * GLM_PI), 1.0, 1e-3);
    /* Negative: seen from outside it is inside out. */
    check_near("volume / (4 pi / 3)", shape.volume / (4.0 * GLM_PI / 3.0), -1.0, 1e-3);
    double worst = 0.0;
    for (uint32_t i = 0; i < welded.vertex_count; i++)
        for (int k = 0; k < 3; k++)
            worst = fmax(worst, fabs(welded.position[i][k] + welded.normal[i][k]));
    check_at_most("normals' distance from -position", worst, 1e-6);
    surface_free(&welded);
}

RUN_TESTS(NULL, NULL)
