/* Emissive surfaces of any shape: as triangles in the path tracer, beside closed forms, and as the
 * few rectangles that stand in for them. */
#include "hand_made.h"
#include "render_support.h"

#include "gltf_parts.h"

#include "scene/lights/emissive.h"
#include "scene/lights/emissive_triangles.h"
#include "scene/lights/lamp_parts.h"
#include "scene/lights/light_bounds.h"
#include "scene/node.h"
#include "shared/light_tree.h"

/* --- the path tracer -------------------------------------------------------------------------- */

/* A world of which one batch emits, as a lamp that is stood in for. */
struct lit_world {
    struct world world;
    struct geometry_part part;
    struct emissive_surface surface;
};

static void light_batch(struct lit_world *lit, int batch, float radiance) {
    struct world *world = &lit->world;
    const struct geometry_batch *from = &world->batches[batch];
    struct material *material = &world->materials[from->material];
    material->emission_texture = -1;
    for (int c = 0; c < 3; c++)
        material->emission[c] = radiance * (float)(1 << c);
    lit->part =
        (struct geometry_part){.first_index = from->first_index, .index_count = from->index_count};
    lit->surface = (struct emissive_surface){0, 0, 0, (int)from->index_count, 1};
    world->geometry.parts = &lit->part;
    world->geometry.part_count = 1;
    world->scene.surfaces = &lit->surface;
    world->scene.surface_count = 1;
    world->light = (struct emitter){.type = EMITTER_AREA, .lamp = 1, .stands_in = 1};
}

/* Within a sphere that emits 1 and reflects half, each bounce brings half of the one before. */
TEST(furnace) {
    struct lit_world lit;
    OWNED(image) image;
    world_in_sphere(&lit.world);
    light_batch(&lit, 0, 1);
    struct path_tracer_desc desc = describe(&lit.world, 16, is_long_run() ? 128 : 48);
    desc.bounces = 30;
    render(&desc, &image);
    for (int c = 0; c < 3; c++) {
        double radiance = 1 << c;
        check_near("emitted", mean_of(&image, CHANNEL_EMITTED + c), radiance, 1e-6);
        check_near("direct", mean_of(&image, CHANNEL_DIRECT + c), radiance, 4e-3 * radiance);
        check_near("indirect", mean_of(&image, CHANNEL_INDIRECT + c), radiance, 4e-3 * radiance);
        check_near("all", mean_of(&image, CHANNEL_BEAUTY + c), 2 * radiance, 4e-3 * radiance);
    }
    image_free(&image);
    /* Switched off, it is as dark as any. */
    lit.world.light.lamp = 0;
    desc.samples = 1;
    render(&desc, &image);
    check_near("without the lamp, emitted", mean_of(&image, CHANNEL_EMITTED), 0, 0);
    world_free(&lit.world);
}

/* A floor under a square of edge 1 at height 1 that shines down. */
static void make_square(struct lit_world *lit) {
    world_init(&lit->world);
    add_rectangle(&lit->world, 0, at(-5, 0, 5), at(10, 0, 0), at(0, 0, -10));
    add_rectangle(&lit->world, 1, at(-.5F, 1, -.5F), at(1, 0, 0), at(0, 0, 1));
    world_finish(&lit->world);
    look_down(&lit->world, -.005F, -.005F, .01F, .9F);
    light_batch(lit, 1, 1);
}

/* Below its middle E / L = .752275; and both ways alone, from so near and from within its plane's
 * reach. */
TEST(square) {
    struct lit_world lit;
    OWNED(image) image;
    make_square(&lit);
    struct path_tracer_desc desc = describe(&lit.world, 8, 256);
    render(&desc, &image);
    check_near("direct", GLM_PI * mean_of(&image, CHANNEL_DIRECT), .752275, 2e-3);
    check_near("direct, blue", GLM_PI * mean_of(&image, CHANNEL_DIRECT + 2), 4 * .752275, 8e-3);
    world_free(&lit.world);
}

/* A texture of two texels, one of them black: half of the light. */
TEST(texture) {
    struct lit_world lit;
    OWNED(image) image;
    unsigned char rgba[8] = {255, 255, 255, 255, 0, 0, 0, 255};
    struct scene_texture texture = {.bitmap = {2, 1, rgba}, .linear = true, .nearest = true};
    make_square(&lit);
    lit.world.scene.textures = &texture;
    lit.world.scene.texture_count = 1;
    lit.world.materials[1].emission_texture = 0;
    struct path_tracer_desc desc = describe(&lit.world, 8, 256);
    render(&desc, &image);
    check_near("direct", GLM_PI * mean_of(&image, CHANNEL_DIRECT), .752275 / 2, 2e-3);
    world_free(&lit.world);
}

/* Right below a lamp, and beside one that it touches: by triangles alone, points near them would be
 * bright without bound. */
TEST(touching) {
    struct lit_world lit;
    OWNED(image) image;
    world_init(&lit.world);
    add_rectangle(&lit.world, 0, at(0, 0, 1), at(1, 0, 0), at(0, 0, -2));
    add_rectangle(&lit.world, 1, at(0, 0, 1), at(0, 0, -2), at(0, 1, 0));
    world_finish(&lit.world);
    look_down(&lit.world, 0, -.25F, .5F, .9F);
    light_batch(&lit, 1, 1);
    struct path_tracer_desc desc = describe(&lit.world, 16, 256);
    desc.bounces = 1;
    struct path_tracer_progress reached = render(&desc, &image);
    check_at_most("noise", reached.noise, .02);
    check_at_most("brightest, of half the hemisphere",
                  (double)image_at(&image, 0, 8)[CHANNEL_DIRECT], .5);
    world_free(&lit.world);
}

/* --- stand-ins -------------------------------------------------------------------------------- */

enum { TRIANGLES_MAX = 4096 };

struct triangles {
    struct lamp_triangle items[TRIANGLES_MAX];
    int count;
};

static void add_triangle(struct triangles *triangles, const vec3s corners[3]) {
    struct lamp_triangle *to = &triangles->items[triangles->count++];
    vec3s across = glms_vec3_cross(glms_vec3_sub(corners[1], corners[0]),
                                   glms_vec3_sub(corners[2], corners[0]));
    to->area = (double)glms_vec3_norm(across) / 2;
    for (int c = 0; c < 3; c++) {
        to->normal[c] = (double)across.raw[c] / (2 * to->area);
        to->radiance[c] = 1 << c;
        for (int k = 0; k < 3; k++)
            to->corners[k][c] = (double)corners[k].raw[c];
    }
}

/* A point of the unit sphere. */
static vec3s on_sphere(int i, int j, int rings) {
    double polar = GLM_PI * j / rings, turn = GLM_PI * i / rings;
    return at((float)(sin(polar) * cos(turn)), (float)cos(polar), (float)(sin(polar) * sin(turn)));
}

static void make_ball(struct triangles *ball, int rings) {
    ball->count = 0;
    for (int j = 0; j < rings; j++)
        for (int i = 0; i < 2 * rings; i++) {
            vec3s a = on_sphere(i, j, rings), b = on_sphere(i + 1, j, rings),
                  c = on_sphere(i + 1, j + 1, rings), d = on_sphere(i, j + 1, rings);
            if (j > 0)
                add_triangle(ball, (const vec3s[]){a, b, c});
            if (j + 1 < rings)
                add_triangle(ball, (const vec3s[]){a, c, d});
        }
}

static double flux_of_parts(const struct lamp_part *parts, int count) {
    double flux = 0;
    for (int i = 0; i < count; i++)
        flux += (double)(parts[i].size[0] * parts[i].size[1] * parts[i].radiance[0]);
    return flux;
}

/* What a small patch far away gets from all, times the squared distance: intensity. */
static double intensity(const struct lamp_part *parts, int count, vec3s towards) {
    double sum = 0;
    for (int i = 0; i < count; i++) {
        float cosine = glms_vec3_dot(
            (vec3s){{parts[i].normal[0], parts[i].normal[1], parts[i].normal[2]}}, towards);
        sum += fmax((double)cosine, 0) *
               (double)(parts[i].size[0] * parts[i].size[1] * parts[i].radiance[0]);
    }
    return sum;
}

TEST(ball) {
    static struct triangles ball;
    struct lamp_part parts[STAND_INS_MAX];
    make_ball(&ball, 16);
    double area = 0, worst = 0;
    for (int i = 0; i < ball.count; i++)
        area += ball.items[i].area;
    int count = lamp_parts_make(ball.items, ball.count, parts, STAND_INS_MAX);
    assert_int_equal(count, STAND_INS_MAX);
    check_near("flux kept", flux_of_parts(parts, count) / area, 1, 1e-6);
    for (int j = 0; j <= 16; j++)
        for (int i = 0; i < 32; i++)
            worst =
                fmax(worst, fabs(intensity(parts, count, on_sphere(i, j, 16)) / (area / 4) - 1));
    check_at_most("intensity apart from the ball's, in any direction", worst, .3);
    for (int i = 0; i < count; i++) {
        vec3s center = {{parts[i].center[0], parts[i].center[1], parts[i].center[2]}};
        check_near("before the surface", (double)glms_vec3_norm(center), 1, .03);
        for (int c = 1; c < 3; c++)
            check_near("colour", (double)(parts[i].radiance[c] / parts[i].radiance[0]), 1 << c,
                       1e-4);
    }
}

/* A strip of many triangles is one rectangle, whatever they are like. */
TEST(strip) {
    static struct triangles strip;
    struct lamp_part part;
    strip.count = 0;
    for (int i = 0; i < 10; i++) {
        float x = .3F * (float)i, next = x + .3F;
        const vec3s corners[4] = {at(x, 2, 0), at(x, 2, 1), at(next, 2, 1), at(next, 2, 0)};
        add_triangle(&strip, (const vec3s[]){corners[0], corners[1], corners[2]});
        add_triangle(&strip, (const vec3s[]){corners[0], corners[2], corners[3]});
    }
    assert_int_equal(lamp_parts_make(strip.items, strip.count, &part, 1), 1);
    check_near("length", (double)part.size[0], 3, 1e-5);
    check_near("width", (double)part.size[1], 1, 1e-5);
    check_near("radiance", (double)part.radiance[0], 1, 1e-5);
    check_near("normal", (double)part.normal[1], 1, 1e-6);
    check_near("centre", (double)part.center[0], 1.5, 1e-5);
    check_near("above", (double)part.center[1] - 2, 3e-4, 1e-5);
}

/* --- triangles -------------------------------------------------------------------------------- */

static struct emissive_triangles list_triangles(const struct scene *scene) {
    OWNED(geometry) geometry;
    struct emissive_triangles list;
    OWNED(emitters) emitters = emitters_place(scene, 0);
    check_ok("geometry", geometry_init(&geometry, scene, 0));
    emissive_triangles_init(&list, scene, &geometry, &emitters);
    for (int i = 0; i < list.count; i++)
        assert_true(list.places[i].triangle < geometry.index_count / 3);
    return list;
}

/* Power over pi, the sum of RGB, W. */
static double power_of_triangles(const struct emissive_triangles *list) {
    double power = 0;
    for (int i = 0; i < list->count; i++)
        power += 3 * (double)light_bounds_of_triangle(&list->items[i]).power;
    return power;
}

/* The quad's first triangle. */
#define ONE_TRIANGLE                                                                               \
    "[{bufferView: 0, componentType: 5126, count: 4, type: VEC3}, {bufferView: 0, byteOffset: "    \
    "48, componentType: 5123, count: 3, type: SCALAR}]"

/* --- scenes ----------------------------------------------------------------------------------- */

/* Emission, over pi and the sum of RGB, of all lights. */
static double power_of_lights(const struct scene *scene) {
    double power = 0;
    for (int n = 0; n < emitter_node_count(scene); n++) {
        struct emitter light;
        emitter_place(&light, scene, n, 0);
        for (int c = 0; c < 3; c++)
            power += (double)light.intensity[c];
    }
    return power;
}

/* 40 panes, more than can be lights of their own, of which none is lost: the largest are, as they
 * are. */
TEST(many) {
    enum { PANES = 40 };
    char nodes[8192] = "[";
    OWNED(scene) scene;
    int own = 0;
    for (int i = 0; i < PANES; i++)
        sprintf(nodes + strlen(nodes),
                "%s{name: '%d', mesh: 0, scale: [%d, 1, 1], translation: [0, 0, %d]}", i ? "," : "",
                i, 1 + (i * 7) % PANES, i);
    strcat(nodes, "]");
    check_ok("load",
             load_parts(&scene, "many.glb",
                        &PARTS(.materials = "[{emissiveFactor: [1, 1, 1]}]", .nodes = nodes)));
    assert_int_equal(emitter_node_count(&scene), EMISSIVE_LIGHTS_MAX);
    assert_int_equal(scene.surface_count, PANES);
    check_near("power", power_of_lights(&scene), 3. * PANES * (PANES + 1) / 2, .05);
    for (int n = 0; n < EMISSIVE_LIGHTS_MAX; n++) {
        const struct node *node = &scene.nodes[node_carrying(&scene, NODE_LIGHT, n)];
        struct emitter light;
        emitter_place(&light, &scene, n, 0);
        if (light.stands_in)
            continue;
        own++;
        check_at_most("no wider is left out", PANES - EMISSIVE_LIGHTS_MAX + STAND_INS_OF_REST,
                      emitter_extent(&light));
        assert_true(node->parent >= 0);
    }
    assert_int_equal(own, EMISSIVE_LIGHTS_MAX - STAND_INS_OF_REST);
    struct emissive_triangles rest = list_triangles(&scene); /* widths of 1 to 16 */
    assert_int_equal(rest.count, 2 * (PANES - own));
    check_near("power of the rest", power_of_triangles(&rest), 3. * 16 * 17 / 2, 1e-3);
    emissive_triangles_free(&rest);
}

/* A unit ball of radiance 1 before a patch that faces it: E = pi / d^2. */
TEST(ball_of_triangles) {
    static struct triangles ball;
    const float distance = 3;
    double irradiance = 0;
    make_ball(&ball, 32);
    for (int i = 0; i < ball.count; i++) {
        struct light_triangle triangle = {.red = 1, .green = 1, .blue = 1};
        double(*corners)[3] = ball.items[i].corners;
        for (int c = 0; c < 3; c++) {
            triangle.corner[c] = (float)corners[0][c];
            triangle.edge_1[c] = (float)(corners[1][c] - corners[0][c]);
            triangle.edge_2[c] = (float)(corners[2][c] - corners[0][c]);
        }
        struct light_bounds bounds = light_bounds_of_triangle(&triangle);
        vec3 to = {0, 0, distance};
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 3; c++)
                to[c] -= (float)corners[k][c] / 3;
        double sees = fmax((double)glm_vec3_dot(to, bounds.axis), 0), far2 = glm_vec3_norm2(to);
        irradiance += (double)bounds.power * sees * (double)to[2] / (far2 * far2);
    }
    check_near("E", irradiance, GLM_PI / 9, 5e-3 * GLM_PI / 9);
}

/* A shape of one triangle, of both sides, mirrored and turned. */
TEST(listed_triangles) {
    static const struct {
        const char *what, *material, *node;
        int triangles;
        double power;  /* over pi, the sum of RGB, W */
        double facing; /* of the first triangle, along z */
    } rows[] = {
        {"one side", "", "scale: [2, 3, 1]", 1, 3 * 3, 1},
        {"two sides", ", doubleSided: true", "scale: [2, 3, 1]", 2, 2 * 3 * 3, 1},
        {"mirrored", "", "scale: [-1, 1, 1]", 1, 1.5, 1},
        {"turned", "", "rotation: [0, 1, 0, 0], scale: [1, 4, 1]", 1, 6, -1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char material[128], node[128];
        OWNED(scene) scene;
        sprintf(material, "[{emissiveFactor: [1, 1, 1]%s}]", rows[i].material);
        sprintf(node, "[{mesh: 0, %s}]", rows[i].node);
        check_ok(rows[i].what, load_parts(&scene, "listed.glb",
                                          &PARTS(.accessors = ONE_TRIANGLE, .materials = material,
                                                 .nodes = node)));
        struct emissive_triangles list = list_triangles(&scene);
        assert_int_equal(list.count, rows[i].triangles);
        check_near("power", power_of_triangles(&list), rows[i].power, 1e-5);
        struct light_bounds bounds = light_bounds_of_triangle(&list.items[0]);
        check_near("facing", (double)bounds.axis[2], rows[i].facing, 1e-6);
        emissive_triangles_free(&list);
    }
}

/* A triangle, a mirrored one, and one of two sides, below nodes that turn and stretch them. */
TEST(shaped) {
    OWNED(scene) scene;
    const struct gltf_parts parts = {.accessors = ONE_TRIANGLE,
                                     .materials = "[{emissiveFactor: [1, 1, 1], name: glow}]",
                                     .nodes =
                                         "[{mesh: 0, name: flag, scale: [2, 3, 1], translation: "
                                         "[0, 0, 5]}, {mesh: 0, scale: [-1, 1, 1]}]"};
    check_ok("load", load_parts(&scene, "shaped.glb", &parts));
    int count = emitter_node_count(&scene);
    check_near("lights", count, 2, 0);
    check_near("power", power_of_lights(&scene), 3 * (3 + .5), 1e-4);
    struct emitter light;
    emitter_place(&light, &scene, 0, 0);
    check_near("place", (double)light.position[2], 5, 1e-3);
    check_near("direction", (double)light.direction[2], 1, 1e-5);
    assert_string_equal(scene.nodes[node_carrying(&scene, NODE_LIGHT, 0)].name, "flag");
    emitter_place(&light, &scene, 1, 0);
    check_near("direction, mirrored", (double)light.direction[2], 1, 1e-5);
}

/* Which surfaces become lights, and how many: the quad in another material, or moved otherwise. */
TEST(which_shine) {
    static unsigned char half[4 * 4 * 4];
    static const float alphas[4][4] = {{1, 1, 1, 0}, {1, 1, 1, 0}, {1, 1, 1, 0}, {1, 1, 1, 0}};
#define GLOW "emissiveFactor: [1, 1, 1]"
#define ALPHA                                                                                      \
    "[" PARTS_QUAD ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 4, type: VEC4}]"
    static const struct {
        const char *what;
        int lights;
        struct gltf_parts parts;
    } rows[] = {
        {"one side", 1, {.materials = "[{" GLOW "}]"}},
        {"both sides", 2, {.materials = "[{" GLOW ", doubleSided: true}]"}},
        {"dark", 0, {.materials = "[{emissiveFactor: [0, 0, 0]}]"}},
        {"it deforms",
         0,
         {.materials = "[{" GLOW "}]",
          .meshes = "[{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0, targets: "
                    "[{POSITION: 0}]}]}]"}},
        {"without area",
         0,
         {.materials = "[{" GLOW "}]", .nodes = "[{mesh: 0, scale: [0, 1, 1]}]"}},
        {"flat node", 1, {.materials = "[{" GLOW "}]", .nodes = "[{mesh: 0, scale: [1, 1, 0]}]"}},
        {"a hole all over",
         0,
         {.materials = "[{" GLOW ", alphaMode: MASK}]",
          .accessors = ALPHA,
          .meshes =
              "[{primitives: [{attributes: {POSITION: 0, COLOR_0: 2}, indices: 1, material: 0}]}]",
          EXTRA(alphas)}},
        {"masked, without holes", -1 /* some */, {.materials = "[{" GLOW ", alphaMode: MASK}]"}},
        {"a picture of light, half of it",
         -1, /* some */
         {.materials = "[{" GLOW ", emissiveTexture: {index: 0}, doubleSided: true}]",
          .accessors =
              "[" PARTS_QUAD
              ", {bufferView: 0, byteOffset: 0, componentType: 5126, count: 4, type: VEC2}]",
          .meshes = "[{primitives: [{attributes: {POSITION: 0, TEXCOORD_0: 2}, indices: 1, "
                    "material: 0}]}]",
          .more = "images: [{uri: 'glow.png'}], textures: [{source: 0}],"}},
    };
    for (size_t i = 0; i < sizeof half; i++)
        half[i] = i % 4 == 3 || i < sizeof half / 2 ? 255 : 0;
    const struct bitmap picture = {4, 4, half};
    check_ok("picture", bitmap_write(&picture, scratch("glow.png")));
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(scene) scene;
        check_ok(rows[i].what, load_parts(&scene, "lamp.glb", &rows[i].parts));
        printf("    %-32s %d lights\n", rows[i].what, scene.light_count);
        if (rows[i].lights >= 0)
            assert_int_equal(scene.light_count, rows[i].lights);
        else
            assert_true(scene.light_count > 0);
    }
}

/* A lamp's own light, and that it is dark when it does not shine: GL beside rays. */
TEST(glow) {
    enum { SIZE = 32 };
    struct stage stage;
    struct image traced;
    const struct gltf_parts parts = {
        .materials = "[{pbrMetallicRoughness: {metallicFactor: 0}, emissiveFactor: [1, 0.5, 0.25], "
                     "extensions: {KHR_materials_emissive_strength: {emissiveStrength: 100}}}]",
        .more = "extensionsUsed: [KHR_materials_emissive_strength, KHR_lights_punctual], "
                "extensions: {KHR_lights_punctual: {lights: [{type: point}]}},",
        .nodes = "[{mesh: 0}, {name: point, translation: [0, 0, 9], extensions: "
                 "{KHR_lights_punctual: {light: 0}}}]"};
    for (int on = 0; on < 2; on++) {
        const struct stage_desc desc = {
            .path = write_parts("scene.glb", &parts),
            .camera = "eye=.5,.5,2 forward=0,0,-1 fov=.8",
            .light = on ? "emitters,point" : "point",
        };
        check_ok("stage", stage_init(&stage, &desc));
        OWNED(image) shown = render_stage(&stage, "unshadowed", "", SIZE);
        traced = TRACE(&stage, .width = SIZE, .height = SIZE, .samples = 1, .centers = true);
        double share = mean_of(&traced, CHANNEL_ALPHA);
        check_near("emitted, traced", mean_of(&traced, CHANNEL_EMITTED), on ? 100 * share : 0,
                   1e-3);
        for (int c = 0; c < 3; c++)
            check_near("radiance in GL", mean_of(&shown, c), mean_of(&traced, c),
                       1e-3 * mean_of(&traced, c));
        image_free(&traced);
        stage_free(&stage);
    }
}

RUN_TESTS(open_group_context, close_group_context)
