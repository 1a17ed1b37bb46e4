/* The scene floor: geometry, lights and cameras of glTF files. */
#define _XOPEN_SOURCE 700
#include "base/unit.h"
#include "gltf_parts.h"

#include "lights/view.h"
#include "scene/camera.h"
#include "scene/lights/brightness.h"
#include "scene/lights/emitter.h"
#include "scene/material.h"
#include "scene/mesh/geometry.h"
#include "scene/open.h"
#include "scene/room.h"
#include "scene/stand_in.h"

static void load(struct scene *scene, struct geometry *geometry, const struct gltf_parts *parts) {
    check_ok("open", scene_open(scene, geometry, write_parts("scene.glb", parts), NULL));
}

static void unload(struct scene *scene, struct geometry *geometry) {
    geometry_free(geometry);
    scene_free(scene);
}

/* The unit normal that a triangle's winding gives it. */
static void winding_normal(const struct geometry *geometry, uint32_t triangle, vec3 out) {
    const uint32_t *corner = &geometry->indices[triangle * 3];
    vec3 a, b;
    glm_vec3_sub(geometry->position[corner[1]], geometry->position[corner[0]], a);
    glm_vec3_sub(geometry->position[corner[2]], geometry->position[corner[0]], b);
    vec3_unit_cross(a, b, out);
}

/* Whatever a node does to a flat mesh, its normals stay perpendicular and its front the front. */
TEST(transformed_normals) {
    static const struct {
        const char *nodes;
        float front; /* the front's z */
    } rows[] = {
        {"[{mesh: 0, scale: [2, 3, 4]}]", 1},
        {"[{mesh: 0, scale: [-1, 1, 1]}]", 1},
        {"[{mesh: 0, scale: [1, 1, -1]}]", -1},
        {"[{mesh: 0, scale: [-1, -1, -1]}]", -1},
        {"[{mesh: 0, scale: [-1, -1, 1]}]", 1},
        {"[{mesh: 0, scale: [1, 1, 0]}]", 1},
        {"[{mesh: 0, scale: [1e-6, -1e-6, 1e-6]}]", 1},
        {"[{scale: [-1, 1, 1], children: [1]}, {mesh: 0, scale: [1, -1, 1]}]", 1},
        /* Sheared and squeezed after a turn about x: the inverse transpose matters. */
        {"[{scale: [1, 5, 0.2], children: [1]}, {mesh: 0, rotation: [0.38268343, 0, 0, "
         "0.92387953]}]",
         1},
        {"[{matrix: [1,0,0,0, 1,1,0,0, 0,1,-1,0, 3,4,5,1], mesh: 0}]", -1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct scene scene;
        struct geometry geometry;
        load(&scene, &geometry, &PARTS(.nodes = rows[i].nodes));
        for (uint32_t t = 0; t < 2; t++) {
            vec3 front;
            winding_normal(&geometry, t, front);
            for (int k = 0; k < 3; k++)
                check_vector("normal", geometry.normal[geometry.indices[t * 3 + k]], front[0],
                             front[1], front[2], 1e-6);
            check_at_most("front", 0, front[2] * rows[i].front);
        }
        unload(&scene, &geometry);
    }
}

/* Two meshes with three materials, the first of them masked, and one primitive without any. */
TEST(batches) {
    struct scene scene;
    struct geometry geometry;
    load(&scene, &geometry,
         &PARTS(.materials = "[{alphaMode: MASK}, {}, {name: unused}, {}]",
                .meshes = "[{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 3}, "
                          "{attributes: {POSITION: 0}, indices: 1, material: 0}]}, {primitives: "
                          "[{attributes: {POSITION: 0}, mode: 5}, {attributes: {POSITION: 0}, "
                          "indices: 1, material: 1}]}]",
                .nodes = "[{mesh: 0}, {mesh: 1}, {mesh: 0, translation: [9, 0, 0]}]"));
    static const struct {
        int material;
        uint32_t first, count;
    } expected[] = {{1, 0, 6}, {3, 6, 12}, {4, 18, 6}, {0, 24, 12}};
    assert_int_equal(geometry.batch_count, 4);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(geometry.batches[i].material, expected[i].material);
        assert_int_equal(geometry.batches[i].first_index, expected[i].first);
        assert_int_equal(geometry.batches[i].index_count, expected[i].count);
    }
    assert_int_equal(geometry.opaque_index_count, 24);
    assert_int_equal(geometry.index_count, 36);
    assert_int_equal(geometry.part_count, 6);
    /* The third node's quads lie 9 m off: they are the second halves of their batches. */
    for (uint32_t k = 0; k < 36; k++) {
        bool moved = (k >= 12 && k < 18) || k >= 30;
        assert_true((geometry.position[geometry.indices[k]][0] > 8) == moved);
    }
    check_vector("least corner", geometry.bounds_min, 0, 0, 0, 0);
    check_vector("greatest corner", geometry.bounds_max, 10, 1, 0, 0);
    check_vector("centre", geometry.center, 5, .5, 0, 0);
    check_near("radius", geometry.radius, sqrt(25.25), 1e-5);
    check_near("white", geometry_color(&geometry, 0)[3], 1, 0);
    check_near("default material", scene.materials[4].base_color[1], 1, 0);
    unload(&scene, &geometry);
}

/* A change marks the parts of its mesh alone, and one of counts or coordinates all. */
TEST(followed) {
    struct scene scene;
    struct geometry geometry, next;
    load(&scene, &geometry, &(struct gltf_parts){.nodes = "[{\"mesh\": 0}, {\"mesh\": 0}]"});
    struct primitive *primitive = scene.meshes[0].primitives;
    for (int step = 0; step < 4; step++) {
        unsigned before = geometry.pose_count;
        scene.nodes[1].translation[0] = step < 1 ? 0 : 2;
        primitive->position[0][0] += step == 2 ? .25F : 0;
        primitive->index_count -= step == 3 ? 3 : 0;
        check_ok("init", geometry_init(&next, &scene, 0));
        geometry_follow(&next, &geometry);
        struct geometry old = geometry;
        geometry = next;
        assert_int_equal(geometry.parts[0].moved > before, step > 1);
        assert_int_equal(geometry.parts[1].moved > before, step > 0);
        assert_int_equal(geometry.changed > before, step > 0);
        assert_int_equal(geometry.laid_out > before, step > 2);
        geometry_free(&old);
    }
    unload(&scene, &geometry);
}

/* Vertices that no triangle uses are not in the bounds. */
TEST(bounds) {
    static const float normals[12] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    struct scene scene;
    struct geometry geometry;
    load(&scene, &geometry,
         &PARTS(.accessors =
                    "[{bufferView: 0, componentType: 5126, count: 4, type: VEC3}, {bufferView: 0, "
                    "byteOffset: 48, componentType: 5123, count: 3, type: SCALAR}, {bufferView: 0, "
                    "byteOffset: 64, componentType: 5126, count: 4, type: VEC3}]",
                .meshes = "[{primitives: [{attributes: {POSITION: 0, NORMAL: 2}, indices: 1}]}]",
                .nodes = "[{mesh: 0, translation: [-1, -1, 0]}]", EXTRA(normals)));
    assert_int_equal(geometry.vertex_count, 4);
    check_vector("least corner", geometry.bounds_min, -1, -1, 0, 0);
    check_vector("greatest corner", geometry.bounds_max, 0, 0, 0, 0);
    unload(&scene, &geometry);
}

static const char *const three_lights =
    "extensions: {KHR_lights_punctual: {lights: [{type: point, color: [1, 0.5, 0.25], intensity: "
    "8, range: 5},{name: lamp, type: spot, intensity: 3, spot: {innerConeAngle: 0.3, "
    "outerConeAngle: 0.6}}, {type: directional}]}},cameras: [{name: wide, type: perspective, "
    "perspective: {yfov: 1.5, znear: 0.1}}, {type: orthographic, orthographic: {xmag: 3, ymag: 2, "
    "znear: 0, zfar: 10}}],";

/* A node turned by 90 degrees about y: -Z becomes -X. Its scale must not matter. */
static const char *const lit_nodes =
    "[{mesh: 0, translation: [0, 0, -5]}, {name: sun, extensions: {KHR_lights_punctual: {light: "
    "2}}}, {name: turned, rotation: [0, 0.70710678, 0, 0.70710678], scale: [2, 3, -4], "
    "translation: [1, 2, 3], children: [3, 4]}, {extensions: {KHR_lights_punctual: {light: 1}}, "
    "scale: [1, 1, -1]}, {extensions: {KHR_lights_punctual: {light: 0}}}, {name: eye, camera: 0}, "
    "{camera: 1, translation: [0, 0, 7]}]";

TEST(lights) {
    struct scene scene;
    struct geometry geometry;
    load(&scene, &geometry, &PARTS(.nodes = lit_nodes, .more = three_lights));
    assert_int_equal(emitter_node_count(&scene), 3);
    struct emitter sun, spot, point;
    emitter_place(&sun, &scene, 0, 0);
    emitter_place(&spot, &scene, 1, 0);
    emitter_place(&point, &scene, 2, 0);
    assert_int_equal(sun.type, EMITTER_DIRECTIONAL);
    check_vector("sun", sun.direction, 0, 0, -1, 1e-7);
    check_near("sun's irradiance", sun.intensity[0], 1, 0);
    assert_int_equal(point.type, EMITTER_POINT);
    check_vector("point", point.position, 1, 2, 3, 1e-6);
    check_vector("point's intensity", point.intensity, 8, 4, 2, 1e-6);
    check_near("point's range", scene.lights[0].range, 5, 0);
    assert_true(isinf(scene.lights[1].range));
    assert_int_equal(spot.type, EMITTER_SPOT);
    check_vector("spot", spot.direction, -1, 0, 0, 1e-6);
    check_vector("spot's up", spot.up, 0, 1, 0, 1e-6);
    vec3 back;
    glm_vec3_cross(spot.right, spot.up, back);
    check_vector("right-handed", back, 1, 0, 0, 1e-6);

    /* KHR_lights_punctual's falloff, and the integral of the cone. */
    check_near("cone, axis", emitter_cone(&spot, 1), 1, 0);
    check_near("cone, inner", emitter_cone(&spot, cosf(.3F)), 1, 1e-6);
    check_near("cone, outer", emitter_cone(&spot, cosf(.6F)), 0, 1e-6);
    check_near("cone, beyond", emitter_cone(&spot, -1), 0, 0);
    double middle = (cos(.45) - cos(.6)) / (cos(.3) - cos(.6));
    check_near("cone, middle", emitter_cone(&spot, cosf(.45F)), middle * middle, 1e-5);
    check_near("cone, point", emitter_cone(&point, -1), 1, 0);
    check_near("solid angle, spot", emitter_solid_angle(&spot), 2 * M_PI * (1 - cos(.6)), 1e-6);
    check_near("solid angle, point", emitter_solid_angle(&point), 4 * M_PI, 1e-12);
    check_near("solid angle, sun", emitter_solid_angle(&sun), 0, 0);

    assert_int_equal(emitter_find(&scene, "sun"), 0);
    assert_int_equal(emitter_find(&scene, "lamp"), 1);
    assert_int_equal(emitter_find(&scene, "2"), 2);
    assert_int_equal(emitter_find(&scene, "3"), -1);
    assert_string_equal(error_get(), "no light '3' (there is: 0=sun 1=lamp 2)");
    assert_int_equal(emitter_find(&scene, ""), -1);
    unload(&scene, &geometry);
}

TEST(cameras) {
    struct scene scene;
    struct geometry geometry;
    load(&scene, &geometry, &PARTS(.nodes = lit_nodes, .more = three_lights));
    assert_int_equal(camera_node_count(&scene), 2);
    assert_int_equal(camera_find(&scene, "wide"), 0);
    assert_int_equal(camera_find(&scene, "eye"), 0);
    assert_int_equal(camera_find(&scene, "1"), 1);
    assert_int_equal(camera_find(&scene, "tall"), -1);
    struct camera camera;
    camera_place(&camera, &scene, 0, 0);
    float origin[3], direction[3];
    camera_ray(&camera, .5F, .5F, 2, origin, direction);
    check_vector("eye", origin, 0, 0, 0, 0);
    check_vector("middle", direction, 0, 0, -1, 1e-7);
    /* Top left; the aspect widens. */
    camera_ray(&camera, 0, 0, 2, origin, direction);
    double t = tan(.75), length = sqrt(1 + 5 * t * t);
    check_vector("corner", direction, -2 * t / length, t / length, -1 / length, 1e-6);
    camera_place(&camera, &scene, 1, 0);
    assert_true(camera.orthographic);
    camera_ray(&camera, 1, 1, 1.5F, origin, direction);
    check_vector("orthographic origin", origin, 3, -2, 7, 1e-6);
    check_vector("orthographic direction", direction, 0, 0, -1, 1e-7);
    unload(&scene, &geometry);
}

/* A file without camera and light: all of it is in the picture and in the light's cone, and its
 * centre gets an irradiance of pi. */
TEST(framing) {
    struct scene scene;
    struct geometry geometry;
    load(&scene, &geometry, &PARTS(.nodes = "[{mesh: 0, translation: [100, 200, 300]}]"));
    assert_int_equal(camera_node_count(&scene), 1);
    assert_int_equal(emitter_node_count(&scene), 2);
    struct camera camera;
    struct emitter light;
    camera_place(&camera, &scene, 0, 0);
    emitter_place(&light, &scene, 0, 0);
    float widest = 0;
    for (uint32_t i = 0; i < geometry.vertex_count; i++) {
        vec3 to;
        glm_vec3_sub(geometry.position[i], camera.eye, to);
        float z = glm_vec3_dot(to, camera.forward), half = z * tanf(camera.fov_y / 2);
        widest = fmaxf(widest, fabsf(glm_vec3_dot(to, camera.right)) / half);
        widest = fmaxf(widest, fabsf(glm_vec3_dot(to, camera.up)) / half);
        glm_vec3_sub(geometry.position[i], light.position, to);
        vec3_unit(to);
        check_at_most("outside the even part of the cone", light.cos_inner,
                      glm_vec3_dot(to, light.direction));
    }
    check_near("share of the picture", widest, .95, .04);
    check_at_most("from above", 200.5, light.position[1]);
    check_near("irradiance",
               light.intensity[1] / glm_vec3_distance2(light.position, geometry.center), M_PI,
               1e-3);
    unload(&scene, &geometry);
}

/* A note says by how much to stop down, and only where it is much. */
static void check_brightness_note(const struct scene *scene, const struct geometry *geometry,
                                  double stops) {
    hear_notes();
    scene_note_brightness(scene, geometry);
    end_notes();
    const char *expected = form("--set exposure=%.0f", -stops);
    printf("    %s\n", *notes ? notes : "no note");
    assert_true(stops > 6 ? strstr(notes, expected) != NULL : *notes == '\0');
}

/* Suns and lamps in the units of photometry are told by how far to stop down; one of our own, and a
 * scene's, are not. */
TEST(brightness) {
    static const struct {
        const char *light;
        double stops;
    } rows[] = {
        {"type: directional, intensity: 102943.7", 15},
        {"type: directional, intensity: 3.14159265", 0},
        /* Beside the middle of a quad with a radius of sqrt(1/2). */
        {"type: point, intensity: 1608.495", 10},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct scene scene;
        struct geometry geometry;
        const char *more =
            form("extensions: {KHR_lights_punctual: {lights: [{%s}]}},", rows[i].light);
        load(&scene, &geometry,
             &PARTS(.nodes = "[{mesh: 0, extensions: {KHR_lights_punctual: {light: 0}}}]",
                    .more = more));
        check_near("stops", scene_brightness(&scene, &geometry), rows[i].stops, 1e-3);
        check_brightness_note(&scene, &geometry, rows[i].stops);
        unload(&scene, &geometry);
    }
    struct scene scene;
    struct geometry geometry;
    load(&scene, &geometry, &PARTS(0));
    check_near("our own", scene_brightness(&scene, &geometry), 0, 1);
    unload(&scene, &geometry);
}

/* What lies far out is moved back, triangles, camera and light. */
TEST(far_out) {
    struct scene scene;
    struct geometry geometry;
    load(&scene, &geometry, &PARTS(.nodes = "[{mesh: 0, translation: [100000, 0, -70000]}]"));
    check_near("origin", scene.origin[0], 100000, 1);
    check_near("origin", scene.origin[2], -70000, 1);
    check_at_most("centre over the radius", glm_vec3_norm(geometry.center), 2 * geometry.radius);
    struct camera camera;
    camera_place(&camera, &scene, 0, 0);
    check_at_most("the camera's distance", glm_vec3_distance(camera.eye, geometry.center),
                  6 * geometry.radius);
    unload(&scene, &geometry);
}

/* And so is what moves there: the values of a clip, but not a cubic's tangents. */
TEST(far_clip) {
    static const char *const kinds[] = {"LINEAR", "CUBICSPLINE"};
    static const float keys[2][20] = {
        {0, 1, 100000, 0, 0, 100001, 0, 0},
        {0, 1, 0, 0, 0, 100000, 0, 0, 1, 0, 0, 1, 0, 0, 100001, 0, 0, 0, 0, 0},
    };
    for (int i = 0; i < 2; i++) {
        struct scene scene;
        struct geometry geometry;
        const char *accessors =
            form("[" PARTS_QUAD
                 ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 2, type: SCALAR}, "
                 "{bufferView: 0, byteOffset: 72, componentType: 5126, count: %d, type: VEC3}]",
                 i ? 6 : 2);
        const char *more =
            form("animations: [{samplers: [{input: 2, output: 3, interpolation: '%s'}], channels: "
                 "[{sampler: 0, target: {node: 0, path: translation}}]}],",
                 kinds[i]);
        load(&scene, &geometry,
             &PARTS(.accessors = accessors, .more = more, .extra = keys[i],
                    .extra_size = sizeof keys[i]));
        check_near("origin", scene.origin[0], 100000, 2);
        const float *values = scene.clips[0].channels[0].values;
        float first = values[i ? 3 : 0], last = values[i ? 12 : 3];
        check_near("from the first key to the last", (double)(last - first), 1, 1e-6);
        check_near("the first key", (double)first, 100000 - scene.origin[0], 1e-6);
        if (i)
            check_near("a tangent", (double)values[6], 1, 0);
        unload(&scene, &geometry);
    }
}

/* A box of 4 x 2 x 10 m about the origin; its faces look inwards, or outwards. */
TEST(room) {
    static float corners[9][3];
    static uint32_t indices[36];
    static const int faces[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                    {4, 6, 7, 5}, {0, 1, 3, 2}, {2, 3, 7, 6}};
    struct geometry box = {.position = corners,
                           .indices = indices,
                           .index_count = 36,
                           .radius = sqrtf(30),
                           .bounds_min = {-2, -1, -5},
                           .bounds_max = {2, 1, 5}};
    for (int i = 0; i < 8; i++)
        memcpy(corners[i], (float[]){i & 1 ? 2 : -2, i & 2 ? 1 : -1, i & 4 ? 5 : -5},
               sizeof corners[i]);
    struct room room;
    for (int inwards = 0; inwards < 2; inwards++) {
        for (int f = 0; f < 6; f++)
            for (int t = 0; t < 2; t++) {
                const uint32_t corner[3] = {(uint32_t)faces[f][0], (uint32_t)faces[f][1 + t],
                                            (uint32_t)faces[f][2 + t]};
                for (int i = 0; i < 3; i++)
                    indices[6 * f + 3 * t + i] = corner[inwards ? i : 2 - i];
            }
        assert_int_equal(room_around(&room, &box, (float[]){0, 0, .5F}), inwards);
    }
    check_near("up", room.up, 1, 1e-5);
    check_near("the longest line", room.ahead + room.behind, 10.5, .5);
    check_near("along z", fabsf(room.forward[2]), 1, .1);
    assert_false(room_around(&room, &box, (float[]){0, 3, 0})); /* outside */
    box.index_count -= 6;                                       /* without its ceiling */
    assert_false(room_around(&room, &box, (float[]){0, 0, 0}));
}

TEST(shared_scenes) {
    static const struct {
        const char *name;
        int triangles;
    } expected[] = {{"cornell-box.glb", 30},
                    {"cornell-horse.glb", 17000},
                    {"sponza-98k.glb", 97999},
                    {"sponza.glb", 262196}};
    if (!shared_path())
        skip();
    for (int i = 0; i < 4; i++) {
        const char *path = form("%s/scenes/%s", shared_path(), expected[i].name);
        struct scene scene;
        struct geometry geometry;
        check_ok("load", scene_load(&scene, path));
        check_ok("geometry", geometry_init(&geometry, &scene, 0));
        check_near(expected[i].name, geometry.index_count / 3, expected[i].triangles, 0);
        assert_int_equal(emitter_node_count(&scene), 1);
        assert_int_equal(camera_node_count(&scene), 1);
        unload(&scene, &geometry);
    }
}

static uint32_t masked_indices(const struct geometry *geometry) {
    return geometry->index_count - geometry->opaque_index_count;
}

/* What decides which programs draw is alike, and all else small. */
TEST(stand_in) {
    static const char *const names[] = {"scenes/cornell-box.glb", "scenes/gloss.glb",
                                        "scenes/atrium.glb", "scenes/character.glb"};
    for (int i = 0; i < 4; i++) {
        struct scene scene;
        struct geometry geometry;
        struct stand_in stand_in;
        check_ok(names[i], scene_open(&scene, &geometry, names[i], NULL));
        stand_in_init(&stand_in, &scene, &geometry);
        printf("    %-28s %u triangles for %u, plain %d\n", names[i],
               stand_in.geometry.index_count / 3, geometry.index_count / 3,
               materials_are_plain(&scene));
        assert_int_equal(materials_are_plain(&stand_in.scene), materials_are_plain(&scene));
        assert_int_equal(masked_indices(&stand_in.geometry) > 0, masked_indices(&geometry) > 0);
        assert_int_equal(stand_in.scene.surface_count > 0, scene.surface_count > 0);
        assert_int_equal(stand_in.scene.texture_count, scene.texture_count);
        assert_true(stand_in.geometry.index_count / 3 <= 2 * (uint32_t)scene.material_count);
        check_near("radius over the scene's", stand_in.geometry.radius / geometry.radius, .7, .3);
        stand_in_free(&stand_in);
        unload(&scene, &geometry);
    }
}

/* The figures of ../shared/scenes/README.md. */
TEST(shared_cornell_box) {
    if (!shared_path())
        skip();
    const char *path = form("%s/scenes/cornell-box.glb", shared_path());
    OWNED(scene) scene;
    check_ok("load", scene_load(&scene, path));
    struct emitter light;
    emitter_place(&light, &scene, 0, 0);
    check_vector("light position", light.position, 1.1, 2.3, 1.9, 1e-3);
    check_vector("light direction", light.direction, -.778, .592, -.209, 1e-3);
    check_vector("light intensity", light.intensity, 500, 500, 500, 1e-3);
    check_near("outer", acos(light.cos_outer) * 180 / M_PI, 29, 1e-3);
    struct camera camera;
    camera_place(&camera, &scene, 0, 0);
    check_vector("eye", camera.eye, 0, 2.73, 10.796, 1e-3);
    check_vector("forward", camera.forward, 0, 0, -1, 1e-6);
    check_near("fov", camera.fov_y * 180 / M_PI, 39.31, 1e-2);
}

/* --- cameras and views ------------------------------------------------------------------------ */

/* Where a point is in the picture; and any difference of two cameras. */
TEST(projection) {
    struct scene scene;
    struct geometry geometry;
    struct camera camera, other;
    struct view view;
    float place[2];
    load(&scene, &geometry, &PARTS(.nodes = lit_nodes, .more = three_lights));
    for (int n = 0; n < 2; n++) {
        camera_place(&camera, &scene, n, 0);
        float origin[3], direction[3], at[3];
        camera_ray(&camera, .75F, .125F, 1.5F, origin, direction);
        for (int c = 0; c < 3; c++)
            at[c] = origin[c] + 5 * direction[c];
        assert_true(camera_project(&camera, at, 1.5F, place));
        check_near("x", (double)place[0], .75, 1e-5);
        check_near("y", (double)place[1], .125, 1e-5);
        glm_vec3_muladds(camera.forward, -9, at);
        assert_false(camera_project(&camera, at, 1.5F, place)); /* behind it */
        view_of_camera(&view, &camera, &geometry, 1.5F);
        assert_int_equal(view.orthographic, n);
        vec3 eye;
        glm_vec3_copy(view.origin, eye);
        view_shift(&view, (float[]){.5F, 0});
        assert_int_equal(glm_vec3_distance(view.origin, eye) > 0, n); /* a perspective one leans */
    }
    float *const parts[] = {&other.fov_y, &other.y_extent, &other.eye[1],
                            &other.up[0], &other.right[2], &other.forward[1]};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        other = camera;
        assert_true(cameras_same(&camera, &other));
        *parts[i] += 1;
        assert_false(cameras_same(&camera, &other));
    }
    other = camera;
    other.orthographic = !camera.orthographic;
    assert_false(cameras_same(&camera, &other));
    unload(&scene, &geometry);
}

RUN_TESTS(be_quiet, NULL)
