/* Lights with a size: what they give where nothing hides them, in the path tracer and in shaders,
 * beside closed forms; and how files tell of them. */
#include "render_support.h"

#include "gltf_parts.h"

#include "reference/scene/emission.h"
#include "scene/lights/flat_shape.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

/* --- light of the whole ----------------------------------------------------------------------- */

/* A light, a receiver, and the irradiance for radiance 1 (a sun's and a sphere's: intensity 1). */
struct answer {
    const char *what;
    struct emitter light;
    float position[3], normal[3];
    double irradiance;
};

/* Looks down from height 1. */
static struct emitter lamp(enum emitter_type type, float intensity, float width, float height) {
    struct emitter light = {.type = type,
                            .intensity = {intensity, intensity, intensity},
                            .size = {width, height},
                            .position = {0, 1, 0},
                            .cos_outer = type == EMITTER_SPOT ? .5F : 0};
    emitter_aim(&light, (float[]){0, -1, 0});
    return light;
}

/* An area light of radiance 1. */
static struct emitter face(float width, float height) {
    struct emitter light = lamp(EMITTER_AREA, 1, width, height);
    float area = (float)emitter_extent(&light);
    glm_vec3_broadcast(area, light.intensity);
    return light;
}

/* On the axis of an angle whose cosine that is. */
static struct answer above_sphere(double cosine, double expected) {
    struct answer answer = {
        "sphere of s2 = 1/4", lamp(EMITTER_POINT, 0, 1, 0), {0, 0, 0}, {0}, expected};
    answer.normal[0] = (float)sqrt(1 - cosine * cosine);
    answer.normal[1] = (float)cosine;
    glm_vec3_broadcast(GLM_PIf / 4, answer.light.intensity);
    return answer;
}

enum { ANSWERS = 17 };

static void make_answers(struct answer answers[ANSWERS]) {
    const struct answer made[ANSWERS] = {
        {"square, below its middle", face(1, 1), {0, 0, 0}, {0, 1, 0}, .752275},
        {"square, below a corner", face(1, 1), {.5F, 0, .5F}, {0, 1, 0}, .435210},
        {"square, aside, half of it seen", face(1, 1), {-.5F, 0, 0}, {1, 0, 0}, .223347},
        {"square, turned, all below", face(1, 1), {0, 0, 0}, {0, -1, 0}, 0},
        {"square, from behind", face(1, 1), {0, 2, 0}, {0, -1, 0}, 0},
        {"square, far away", face(1, 1), {0, -999, 0}, {0, 1, 0}, 1e-6},
        {"square of a micrometre", face(1e-6F, 1e-6F), {0, 0, 0}, {0, 1, 0}, 1e-12},
        {"disk, below its middle", face(1, 0), {0, 0, 0}, {0, 1, 0}, .628319},
        {"disk, below its rim", face(1, 0), {.5F, 0, 0}, {0, 1, 0}, .460076},
        above_sphere(.9, .70686),
        above_sphere(.1, .13419),
        above_sphere(-.1, .05565),
        above_sphere(-.6, 0),
        {"sun, overhead", lamp(EMITTER_DIRECTIONAL, 3, .0093F, 0), {0, 0, 0}, {0, 1, 0}, 3},
        {"wide sun, aslant", lamp(EMITTER_DIRECTIONAL, 1, 1, 0), {0, 0, 0}, {.6F, .8F, 0}, .8},
        {"sun half set",
         lamp(EMITTER_DIRECTIONAL, 1, .2F, 0),
         {0, 0, 0},
         {1, 0, 0},
         (.1 - sin(.1) * cos(.1)) / (GLM_PI * sin(.1) * sin(.1))},
        {"spot with a disk, aslant",
         lamp(EMITTER_SPOT, 2, 1e-3F, 0),
         {0, 0, 0},
         {.6F, .8F, 0},
         1.6},
    };
    memcpy(answers, made, sizeof made);
}

static const double tolerance = 1e-4;

static void check_answer(const struct answer *answer, double got) {
    check_near(answer->what, got, answer->irradiance,
               tolerance * fmin(1, fmax(answer->irradiance, 1e-9)) + 1e-12);
}

/* The mean over places, by which the path tracer finds it. */
static double traced(const struct answer *answer) {
    enum { SIDE = 400 };
    struct geometry geometry = {.radius = 1};
    struct emission emission;
    struct emitter light = answer->light;
    struct hit hit = {.position = to_vec3s(answer->position),
                      .normal = to_vec3s(answer->normal),
                      .geometric_normal = to_vec3s(answer->normal)};
    struct arrival arrival;
    double sum = 0;
    emission_init(&emission, &(struct emitters){.items = &light, .count = 1}, &geometry, NULL, 0);
    for (int i = 0; i < SIDE * SIDE; i++) {
        vec2s sample = {{((float)(i % SIDE) + .5F) / SIDE, ((float)(i / SIDE) + .5F) / SIDE}};
        vec2s place = emission_place(&emission, 0, sample, &hit);
        if (emission_reach(&emission, 0, place, &hit, &arrival))
            sum += (double)arrival.irradiance.x;
    }
    emission_free(&emission);
    return sum / (SIDE * SIDE);
}

TEST(traced) {
    struct answer answers[ANSWERS];
    make_answers(answers);
    for (int i = 0; i < ANSWERS; i++)
        check_answer(&answers[i], traced(&answers[i]));
}

/* What shaders find: of each light at its place, for intensity 1. */
static void shade(struct answer *answers, int count, float *got) {
    struct emitter lights[ANSWERS];
    struct geometry geometry = {.radius = 1};
    static struct light_block block;
    vec4 points[ANSWERS][2] = {0};
    for (int i = 0; i < count; i++) {
        lights[i] = answers[i].light;
        glm_vec3_copy(answers[i].position, points[i][0]);
        glm_vec3_copy(answers[i].normal, points[i][1]);
    }
    views_of_emitters(&block, &(struct emitters){.items = lights, .count = count}, &geometry);
    ask_shader(&FILLED(questions, .shader = "unshadowed.comp", .asked = points,
                       .asked_bytes = (size_t)count * sizeof *points, .answers = got,
                       .answer_bytes = (size_t)count * sizeof *got, .groups = {1},
                       .blocks = {{BLOCK_LIGHTS, &block, sizeof block}}));
}

TEST(shaded) {
    struct answer answers[ANSWERS];
    float got[ANSWERS];
    make_answers(answers);
    shade(answers, ANSWERS, got);
    for (int i = 0; i < ANSWERS; i++)
        check_answer(&answers[i], (double)(got[i] * answers[i].light.intensity[0]));
}

/* A rectangle cut in two gives what it gave whole. */
TEST(halves) {
    static const struct answer wholes[] = {
        {"below the middle", {0}, {0, 0, 0}, {0, 1, 0}, 0},
        {"aside, tilted", {0}, {.3F, 0, .7F}, {.6F, .8F, 0}, 0},
        {"half of it seen", {0}, {-.2F, .9F, 0}, {1, 0, 0}, 0},
    };
    for (size_t i = 0; i < sizeof wholes / sizeof *wholes; i++) {
        struct answer parts[3] = {wholes[i], wholes[i], wholes[i]}; /* the whole, its halves */
        float got[3];
        for (int p = 0; p < 3; p++)
            parts[p].light = face(p ? .5F : 1, .6F);
        for (int p = 1; p < 3; p++)
            glm_vec3_muladds(parts[p].light.right, p == 1 ? .25F : -.25F, parts[p].light.position);
        shade(parts, 3, got);
        double whole = (double)got[0] * .6, halves = (double)(got[1] + got[2]) * .3;
        check_near(wholes[i].what, halves, whole, 1e-6);
        assert_true(got[1] != got[2] || i == 0);
    }
}

/* --- flux ------------------------------------------------------------------------------------- */

/* Places on a light, and what its pieces have together: its intensity, in its middle. */
TEST(pieces) {
    enum { SIDE = 32 };
    const struct emitter lights[] = {face(2, .5F), face(2, 0), lamp(EMITTER_SPOT, 3, .5F, .25F),
                                     lamp(EMITTER_POINT, 5, .3F, 0),
                                     lamp(EMITTER_DIRECTIONAL, 2, .4F, 0)};
    for (size_t n = 0; n < sizeof lights / sizeof *lights; n++) {
        const struct emitter *light = &lights[n];
        double flux = 0, aside[3] = {0};
        for (int i = 0; i < SIDE * SIDE; i++) {
            float place[2] = {((float)(i % SIDE) + .5F) / SIDE, ((float)(i / SIDE) + .5F) / SIDE};
            struct emitter piece = emitter_piece(light, place);
            assert_int_equal(emitter_shape(&piece), EMITTER_IS_POINT);
            flux += emitter_flux(&piece, 1) / (SIDE * SIDE);
            for (int c = 0; c < 3; c++)
                aside[c] += (double)(piece.position[c] - light->position[c]) / (SIDE * SIDE);
        }
        /* Across the beam the sun's pieces have more: they cross areas that face its
         * middle aslant. */
        double slant = light->type == EMITTER_DIRECTIONAL ? 2 / (1 + cos(.2)) : 1;
        check_near("flux of all pieces", flux, slant * emitter_flux(light, 1), 1e-5 * flux);
        check_near("their middle, aside", hypot(hypot(aside[0], aside[1]), aside[2]), 0, 1e-6);
    }
}

/* In a sphere of albedo 1/2 VPLs have half of the flux, whatever shines: rho pi L A of an area
 * light. */
TEST(vpl_flux) {
    const struct emitter lights[] = {face(.5F, .25F), face(.3F, 0), lamp(EMITTER_POINT, 2, .2F, 0)};
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        OWNED(stage) stage = open_stage("scenes/sphere.glb");
        OWNED(renderer) renderer;
        stage.emitters.items[0] = lights[i];
        glm_vec3_copy((vec3){.1F, .2F, -.1F}, stage.emitters.items[0].position);
        open_renderer(&renderer, desc_of(&stage, "unshadowed", "vpls=4096", 16, 16));
        struct vpl *vpls = read_vpls(&renderer);
        double sum = 0;
        for (int v = 0; v < 4096; v++)
            sum += (double)vpls[v].flux[0];
        double expected = .5 * emitter_flux(&stage.emitters.items[0], 1);
        check_near("flux of all VPLs", sum, expected, .01 * expected);
        free(vpls);
    }
}

/* --- files ------------------------------------------------------------------------------------ */

static void open_parts(struct scene *scene, const struct gltf_parts *parts) {
    static unsigned char glb[32768];
    size_t size = parts_glb(parts, glb, sizeof glb);
    write_bytes(scratch("area.glb"), glb, size);
    check_ok("load", scene_load(scene, scratch("area.glb")));
}

static void check_place(const char *what, const float *got, double x, double y, double z) {
    printf("    %s:\n", what);
    check_near("x", (double)got[0], x, 1e-4);
    check_near("y", (double)got[1], y, 1e-4);
    check_near("z", (double)got[2], z, 1e-4);
}

static void check_size(const struct emitter *light, enum emitter_shape shape, double width,
                       double height) {
    assert_int_equal(emitter_shape(light), shape);
    check_near("width", (double)light->size[0], width, 1e-4);
    check_near("height", (double)light->size[1], height, 1e-4);
}

/* The greatest scale of the node counts, both ways; -Z is the front. */
TEST(extension) {
    OWNED(scene) scene;
    struct emitter light;
    open_parts(
        &scene,
        &PARTS(.more = "extensionsRequired: [EXT_lights_area], extensions: {EXT_lights_area: "
                       "{lights: [{name: panel, type: rect, color: [1, 0.5, 0.25], intensity: 4, "
                       "size: 0.5, rect: {aspect: 3}}, {type: disk}]}, KHR_lights_punctual: "
                       "{lights: [{type: point}]}},",
               .nodes = "[{mesh: 0}, {scale: [1, 2, -0.5], translation: [1, 2, 3], extensions: "
                        "{EXT_lights_area: {light: 0}}}, {extensions: {EXT_lights_area: {light: "
                        "1}}}, {extensions: {KHR_lights_punctual: {light: 0}}}]"));
    assert_int_equal(emitter_node_count(&scene), 3);
    emitter_place(&light, &scene, emitter_find(&scene, "panel"), 0);
    assert_int_equal(light.type, EMITTER_AREA);
    check_size(&light, EMITTER_IS_RECTANGLE, 3, 1);
    check_place("intensity", light.intensity, 12, 6, 3);
    check_place("place", light.position, 1, 2, 3);
    check_near("flux, pi L A", emitter_flux(&light, 1), GLM_PI * 3 * (4 + 2 + 1) / 3, 1e-4);
    emitter_place(&light, &scene, 1, 0);
    check_size(&light, EMITTER_IS_DISK, 1, 0);
    check_near("nits", (double)light.intensity[0], 1000 * GLM_PI / 4, 1e-3);
    emitter_place(&light, &scene, 2, 0);
    assert_int_equal(light.type, EMITTER_POINT);
}

TEST(extras) {
    OWNED(scene) scene;
    struct emitter light;
    open_parts(
        &scene,
        &PARTS(.more = "extensions: {KHR_lights_punctual: {lights: [{type: point, extras: {radius: "
                       "0.25, size: of}}, {type: spot, spot: {}, extras: {radius: 0.5}}, {type: "
                       "spot, spot: {}, extras: {size: [2, 3]}}, {type: directional, extras: "
                       "{angle: 0.0093}}, {type: point, extras: {radius: 0}}]}},",
               .nodes = "[{mesh: 0}, {extensions: {KHR_lights_punctual: {light: 0}}}, {extensions: "
                        "{KHR_lights_punctual: {light: 1}}}, {extensions: {KHR_lights_punctual: "
                        "{light: 2}}}, {extensions: {KHR_lights_punctual: {light: 3}}}, "
                        "{extensions: {KHR_lights_punctual: {light: 4}}},"
                        /* Extras of nodes count where the light has none. */
                        " {extensions: {KHR_lights_punctual: {light: 4}}, extras: {radius: 0.1}}, "
                        "{extensions: {KHR_lights_punctual: {light: 0}}, extras: {radius: 9}}, "
                        "{extensions: {KHR_lights_punctual: {light: 4}}, extras: {radius: wide}}, "
                        "{extras: {radius: 0.2}, children: [10]}, {extensions: "
                        "{KHR_lights_punctual: {light: 4}}}]"));
    static const struct {
        enum emitter_shape shape;
        double width, height;
    } expected[] = {
        {EMITTER_IS_SPHERE, .5, 0}, {EMITTER_IS_DISK, 1, 0},  {EMITTER_IS_RECTANGLE, 2, 3},
        {EMITTER_IS_CAP, .0093, 0}, {EMITTER_IS_POINT, 0, 0}, {EMITTER_IS_SPHERE, .2, 0},
        {EMITTER_IS_SPHERE, .5, 0}, {EMITTER_IS_POINT, 0, 0}, {EMITTER_IS_SPHERE, .4, 0}};
    for (int n = 0; n < 9; n++) {
        emitter_place(&light, &scene, n, 0);
        check_size(&light, expected[n].shape, expected[n].width, expected[n].height);
    }
}

/* The quad of 1 x 1 in the xy plane, from 0 to 1. */
TEST(emissive_quad) {
    OWNED(scene) scene;
    struct emitter front, back;
    open_parts(&scene,
               &PARTS(.materials =
                          "[{name: glow, emissiveFactor: [1, 0.5, 0], doubleSided: true, "
                          "extensions: {KHR_materials_emissive_strength: {emissiveStrength: 8}}}]",
                      .nodes = "[{name: pane, mesh: 0, scale: [2, 3, -1]}]"));
    assert_int_equal(emitter_node_count(&scene), 2);
    assert_int_equal(emitter_find(&scene, "pane"), 0);
    emitter_place(&front, &scene, 0, 0);
    emitter_place(&back, &scene, 1, 0);
    check_near("area", emitter_extent(&front), 6, 1e-4);
    check_place("intensity", front.intensity, 48, 24, 0);
    check_place("front, which the node turns", front.direction, 0, 0, -1);
    check_place("back", back.direction, 0, 0, 1);
    check_place("place", front.position, 1, 1.5, 0);
    assert_true(front.position[2] < 0 && back.position[2] > 0);
}

/* --- shapes ----------------------------------------------------------------------------------- */

enum { CORNERS_MAX = 64 };

/* A polygon around the origin, in a tilted plane far from it, as a fan from its middle. */
struct fan {
    struct primitive primitive;
    float position[CORNERS_MAX + 1][3];
    uint32_t indices[3 * CORNERS_MAX];
};

static void make_fan(struct fan *fan, int corners, const float (*corner)[2]) {
    *fan = (struct fan){.primitive = {.vertex_count = corners + 1, .index_count = 3 * corners}};
    fan->primitive.position = fan->position;
    fan->primitive.indices = fan->indices;
    for (int i = 0; i <= corners; i++) {
        float x = i ? corner[i - 1][0] : 0, y = i ? corner[i - 1][1] : 0;
        const float place[3] = {10 + .6F * x, -4 + y, 7 - .8F * x};
        memcpy(fan->position[i], place, sizeof place);
    }
    for (int i = 0; i < corners; i++) {
        const uint32_t triangle[3] = {0, (uint32_t)i + 1, (uint32_t)((i + 1) % corners) + 1};
        memcpy(&fan->indices[3 * i], triangle, sizeof triangle);
    }
}

static void make_polygon(struct fan *fan, int corners, float squeeze) {
    float corner[CORNERS_MAX][2];
    for (int i = 0; i < corners; i++) {
        float turn = 2 * GLM_PIf * (float)i / (float)corners;
        corner[i][0] = 3 * cosf(turn);
        corner[i][1] = 3 * squeeze * sinf(turn);
    }
    make_fan(fan, corners, (const float(*)[2])corner);
}

TEST(shapes) {
    struct fan fan;
    struct flat_shape shape;
    /* Eight corners, of which four lie on sides. */
    static const float oblong[8][2] = {{2, 1},   {1, 1},  {-2, 1}, {-2, 0},
                                       {-2, -1}, {0, -1}, {2, -1}, {2, .5F}};
    make_fan(&fan, 8, oblong);
    assert_true(flat_shape_of(&shape, &fan.primitive));
    check_near("longer side", fmax((double)shape.size[0], (double)shape.size[1]), 4, 1e-4);
    check_near("shorter side", fmin((double)shape.size[0], (double)shape.size[1]), 2, 1e-4);
    check_place("centre", shape.center, 10, -4, 7);
    check_place("normal", shape.normal, .8, 0, .6);
    for (int corners = 8; corners <= CORNERS_MAX; corners *= 2) {
        make_polygon(&fan, corners, 1);
        assert_true(flat_shape_of(&shape, &fan.primitive));
        double area = corners * 4.5 * sin(2 * GLM_PI / corners);
        check_near("disk, as large as its polygon", GLM_PI / 4 * pow((double)shape.size[0], 2),
                   area, 1e-3 * area);
        check_near("second size", (double)shape.size[1], 0, 0);
    }
    make_polygon(&fan, 7, 1);
    assert_false(flat_shape_of(&shape, &fan.primitive));
    make_polygon(&fan, 32, .9F);
    assert_false(flat_shape_of(&shape, &fan.primitive));
    static const float slanted[4][2] = {{2, 1}, {-1, 1}, {-2, -1}, {1, -1}};
    make_fan(&fan, 4, slanted);
    assert_false(flat_shape_of(&shape, &fan.primitive));
    make_fan(&fan, 8, oblong);
    fan.position[1][1] += .5F;
    assert_false(flat_shape_of(&shape, &fan.primitive));
    make_fan(&fan, 8, oblong);
    fan.position[0][0] += .5F;
    assert_false(flat_shape_of(&shape, &fan.primitive));
    fan.primitive.index_count = 0;
    assert_false(flat_shape_of(&shape, &fan.primitive));
}

RUN_TESTS(open_group_context, close_group_context)
