/* Animation on the CPU: values between keys, skins, morph targets, metaballs, and that a pose
 * depends on its time alone. */
#define _XOPEN_SOURCE 700
#include "gltf_parts.h"

#include "scene/animation.h"
#include "scene/camera.h"
#include "scene/clips.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"
#include "scene/read_rules.h"

/* Three keys' times at 64, values from 96 on. */
enum { TIMES, VALUES = 8, EXTRA_FLOATS = 64 };

/* The node's quad, moved by one sampler of values of that type and count. */
#define CLIP_ACCESSORS(values)                                                                     \
    "[" PARTS_QUAD ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 3, type: "       \
    "SCALAR}, {bufferView: 0, byteOffset: 96, componentType: 5126, " values "}]"
#define CLIP(path, interpolation)                                                                  \
    "{name: '" path "', channels: [{sampler: 0, target: {node: 0, path: '" path                    \
    "'}}], samplers: [{input: 2, output: 3, interpolation: '" interpolation "'}]}"
#define CLIPS(clips) "animations: [" clips "],"

static void load_clip(struct scene *scene, const char *accessors, const char *more,
                      const float *values, int count) {
    float extra[EXTRA_FLOATS] = {1, 2, 4};
    memcpy(extra + VALUES, values, (size_t)count * sizeof *values);
    struct gltf_parts parts = {.accessors = accessors, .more = more, EXTRA(extra)};
    check_ok("clip", load_parts(scene, "clip.glb", &parts));
}

static float translation_x(const struct scene *scene, double time) {
    float worlds[8][16];
    assert_true(scene->node_count <= 8);
    scene_node_worlds(scene, time, worlds);
    return worlds[0][12];
}

TEST(interpolation) {
    static const float values[] = {3, 0, 0, 5, 0, 0, -1, 0, 0};
    static const struct {
        const char *clip;
        double expected[6];
    } cases[] = {
        {CLIPS(CLIP("translation", "LINEAR")), {3, 3, 4, 5, 2, -1}},
        {CLIPS(CLIP("translation", "STEP")), {3, 3, 3, 5, 5, -1}},
    };
    static const double times[6] = {0, 1, 1.5, 2, 3, 9};
    for (int i = 0; i < 2; i++) {
        OWNED(scene) scene;
        load_clip(&scene, CLIP_ACCESSORS("count: 3, type: VEC3"), cases[i].clip, values, 9);
        for (int t = 0; t < 6; t++)
            check_near("x", (double)translation_x(&scene, times[t]), cases[i].expected[t], 1e-6);
        check_near("duration", scene_duration(&scene), 4, 0);
    }
}

/* Keys at times of frames, which floats round up (1/10, 4/10) and down (7/10), hold from that frame
 * on. */
TEST(keys_at_frames) {
    static const float values[] = {3, 0, 0, 5, 0, 0, -1, 0, 0}, keys[] = {.1F, .4F, .7F};
    static const double expected[] = {3, 3, 3, 3, 5, 5, 5, -1, -1};
    float extra[EXTRA_FLOATS];
    memcpy(extra, keys, sizeof keys);
    memcpy(extra + VALUES, values, sizeof values);
    OWNED(scene) scene;
    check_ok("clip",
             load_parts(&scene, "frames.glb",
                        &(struct gltf_parts){.accessors = CLIP_ACCESSORS("count: 3, type: VEC3"),
                                             .more = CLIPS(CLIP("translation", "STEP")),
                                             EXTRA(extra)}));
    for (int i = 0; i < 9; i++)
        check_near("x", (double)translation_x(&scene, i / 10.), expected[i], 0);
}

/* A cubic through keys of x = t^3 with its tangents is t^3. */
TEST(cubic) {
    static const double keys[3] = {1, 2, 4};
    float values[27] = {0};
    for (int k = 0; k < 3; k++) {
        values[9 * k] = values[9 * k + 6] = (float)(3 * keys[k] * keys[k]);
        values[9 * k + 3] = (float)pow(keys[k], 3);
    }
    OWNED(scene) scene;
    load_clip(&scene, CLIP_ACCESSORS("count: 9, type: VEC3"),
              CLIPS(CLIP("translation", "CUBICSPLINE")), values, 27);
    for (double t = 1; t <= 4; t += .25)
        check_near("x", (double)translation_x(&scene, t), t * t * t, 1e-5);
}

/* A quarter turn about z, then on the way back by the quaternion of other sign: the short way. */
TEST(rotation) {
    const float h = (float)sqrt(.5);
    const float values[12] = {0, 0, 0, 1, 0, 0, -h, -h, 0, 0, 0, 1};
    OWNED(scene) scene;
    load_clip(&scene, CLIP_ACCESSORS("count: 3, type: VEC4"), CLIPS(CLIP("rotation", "LINEAR")),
              values, 12);
    static const double times[] = {1, 1.25, 1.5, 2, 3, 4}, degrees[] = {0, 22.5, 45, 90, 45, 0};
    for (int i = 0; i < 6; i++) {
        float world[8][16];
        scene_node_worlds(&scene, times[i], world);
        check_near("cos", (double)world[0][0], cos(degrees[i] * M_PI / 180), 1e-6);
        check_near("sin", (double)world[0][1], sin(degrees[i] * M_PI / 180), 1e-6);
    }
}

TEST(clip_choice) {
    static const float values[] = {3, 0, 0, 5, 0, 0, -1, 0, 0};
    OWNED(scene) scene;
    load_clip(&scene, CLIP_ACCESSORS("count: 3, type: VEC3"),
              CLIPS(CLIP("translation", "LINEAR") "," CLIP("scale", "LINEAR")), values, 9);
    assert_int_equal(scene.playing_count, 2);
    check_ok("by name", clips_select(&scene, "scale"));
    assert_int_equal(scene.playing_count, 1);
    assert_int_equal(scene.playing[0], 1);
    check_near("at rest", (double)translation_x(&scene, 3), 0, 0);
    check_ok("by number", clips_select(&scene, "0"));
    check_near("moved", (double)translation_x(&scene, 3), 2, 1e-6);
    assert_false(clips_select(&scene, "walk"));
    assert_string_equal(error_get(), "no clip 'walk' (there is: 0=translation 1=scale)");
}

static bool is_rigid(const char *clips) {
    static const float values[] = {0, 0, 0, 1, 1, 1, 2, 2, 2};
    OWNED(scene) scene;
    OWNED(geometry) geometry;
    load_clip(&scene, CLIP_ACCESSORS("count: 3, type: VEC3"), clips, values, 9);
    check_ok("geometry", geometry_init(&geometry, &scene, 1));
    bool rigid = geometry.parts[0].rigid;
    return rigid;
}

/* What begins as a point must not be simplified as one. */
TEST(rigid) {
    assert_true(is_rigid(CLIPS(CLIP("translation", "LINEAR"))));
    assert_false(is_rigid(CLIPS(CLIP("scale", "LINEAR"))));
    assert_false(is_rigid(CLIPS(CLIP("translation", "LINEAR") "," CLIP("scale", "LINEAR"))));
}

/* Camera and light hang on a node that moves. */
TEST(camera_and_light) {
    const float h = (float)sqrt(.5);
    const float values[12] = {0, 0, 0, 1, 0, h, 0, h, 0, h, 0, h};
    OWNED(scene) scene;
    float extra[EXTRA_FLOATS] = {1, 2, 4};
    memcpy(extra + VALUES, values, sizeof values);
    struct gltf_parts parts = {
        .accessors = CLIP_ACCESSORS("count: 3, type: VEC4"),
        .nodes = "[{children: [1, 2]}, {mesh: 0, camera: 0, translation: [0,0,5]}, {translation: "
                 "[3,0,0], extensions: {KHR_lights_punctual: {light: 0}}}]",
        .more =
            "cameras: [{type: perspective, perspective: {yfov: 1, znear: 0.1}}], extensions: "
            "{KHR_lights_punctual: {lights: [{type: point}]}}," CLIPS(CLIP("rotation", "LINEAR")),
        EXTRA(extra)};
    check_ok("scene", load_parts(&scene, "clip.glb", &parts));
    struct camera camera;
    struct emitter light;
    camera_place(&camera, &scene, 0, 1.5);
    emitter_place(&light, &scene, 0, 2);
    /* An eighth of a turn about y takes +z towards +x; a quarter takes +x to -z. */
    check_near("eye x", (double)camera.eye[0], 5 * sqrt(.5), 1e-5);
    check_near("eye z", (double)camera.eye[2], 5 * sqrt(.5), 1e-5);
    check_near("forward x", (double)camera.forward[0], -sqrt(.5), 1e-6);
    check_near("light x", (double)light.position[0], 0, 1e-5);
    check_near("light z", (double)light.position[2], -3, 1e-5);
}

/* --- deformation ------------------------------------------------------------------------------ */

/* The quad's displacements by two targets, and weights that move from one to the other. */
TEST(morph) {
    /* Times at 0, weights at 8 for three keys, a displacement for each of 4 vertices from 16 on. */
    float extra[EXTRA_FLOATS] = {1, 2, 4, 0, 0, 0, 0, 0, 0, .5F, 1, 0, 1, 2};
    for (int v = 0; v < 4; v++)
        extra[16 + 3 * v + 2] = (float)(v + 1);
    for (int v = 0; v < 4; v++)
        extra[28 + 3 * v] = 10;
    struct gltf_parts parts = {
        .accessors =
            "[" PARTS_QUAD
            ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 3, type: SCALAR}, "
            "{bufferView: 0, byteOffset: 96, componentType: 5126, count: 6, type: SCALAR}, "
            "{bufferView: 0, byteOffset: 128, componentType: 5126, count: 4, type: VEC3}, "
            "{bufferView: 0, byteOffset: 176, componentType: 5126, count: 4, type: VEC3}]",
        .meshes = "[{primitives: [{attributes: {POSITION: 0}, indices: 1, targets: [{POSITION: 4}, "
                  "{POSITION: 5}]}]}]",
        .more = CLIPS(CLIP("weights", "LINEAR")),
        EXTRA(extra)};
    OWNED(scene) scene;
    OWNED(geometry) geometry;
    check_ok("scene", load_parts(&scene, "morph.glb", &parts));
    check_ok("geometry", geometry_init(&geometry, &scene, 1.5));
    /* No normals: vertices of two triangles 0 1 2, 0 2 3; weights are (0.5, 0.25). */
    static const int corner[6] = {0, 1, 2, 0, 2, 3};
    static const double x[4] = {0, 1, 1, 0};
    for (int i = 0; i < 6; i++) {
        check_near("x", (double)geometry.position[i][0], x[corner[i]] + 2.5, 1e-6);
        check_near("z", (double)geometry.position[i][2], .5 * (corner[i] + 1), 1e-6);
    }
    /* The first triangle rises by 0.5 along x and then along y: normal (-.5, -.5, 1). */
    check_near("flat normal", (double)geometry.normal[0][2], 1 / sqrt(1.5), 1e-6);
    check_ok("pose", geometry_pose(&geometry, &scene, 4));
    check_near("x", (double)geometry.position[0][0], 20, 1e-6);
    check_near("z", (double)geometry.position[0][2], 1, 1e-6);
}

static const char skin_accessors[] =
    "[" PARTS_QUAD
    ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 3, type: SCALAR}, {bufferView: "
    "0, byteOffset: 76, componentType: 5126, count: 3, type: VEC4}, {bufferView: 0, byteOffset: "
    "124, componentType: 5126, count: 4, type: VEC4}, {bufferView: 0, byteOffset: 188, "
    "componentType: 5121, count: 4, type: VEC4}, {bufferView: 0, byteOffset: 204, componentType: "
    "5126, count: 1, type: MAT4}]";

/* One joint with an inverse bind matrix, and one whose is the identity but for want of a second:
 * the file gives each skin one joint, and the second skin none. */
TEST(skin) {
    const float h = (float)sqrt(.5), turn[12] = {0, 0, 0, 1, 0, 0, h, h, 0, 0, 0, 1};
    const float bind[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
    float extra[EXTRA_FLOATS] = {1, 2, 4};
    memcpy(extra + 3, turn, sizeof turn);
    for (int v = 0; v < 4; v++) { /* unnormalised weights of joints 0 and 1 */
        extra[15 + 4 * v] = (float)(4 - v);
        extra[15 + 4 * v + 1] = (float)v;
    }
    memcpy(extra + 35, bind, sizeof bind);
    for (int v = 0; v < 4; v++)
        ((unsigned char *)(extra + 31))[4 * v + 1] = 1;
    struct gltf_parts parts = {
        .accessors = skin_accessors,
        .meshes =
            "[{primitives: [{attributes: {POSITION: 0, JOINTS_0: 5, WEIGHTS_0: 4}, indices: 1}]}]",
        /* The joint that turns stands at (1, 0, 0), the other at (0, 7, 0); where the mesh's own
         * node stands must not matter. */
        .nodes = "[{translation: [1,0,0]}, {translation: [0,7,0]}, {mesh: 0, skin: 0, translation: "
                 "[100,100,100]}]",
        .more = "skins: [{joints: [0, 1]}]," CLIPS(CLIP("rotation", "LINEAR")),
        EXTRA(extra)};
    struct scene scene;
    struct geometry geometry;
    check_ok("scene", load_parts(&scene, "skin.glb", &parts));
    check_ok("geometry", geometry_init(&geometry, &scene, 0));
    check_ok("pose", geometry_pose(&geometry, &scene, 1.5));
    /* A second implementation: each joint places the vertex; the places are mixed. */
    static const int corner[6] = {0, 1, 2, 0, 2, 3};
    static const double quad[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 6; i++) {
        const double *p = quad[corner[i]], w = corner[i] / 4.;
        double c = cos(M_PI / 4), s = sin(M_PI / 4);
        double turned[2] = {1 + c * p[0] - s * p[1], s * p[0] + c * p[1]};
        double moved[2] = {p[0], p[1] + 7};
        for (int a = 0; a < 2; a++)
            check_near("skinned", (double)geometry.position[i][a],
                       (1 - w) * turned[a] + w * moved[a], 1e-5);
    }
    geometry_free(&geometry);
    scene_free(&scene);
    parts.more = "skins: [{joints: [0], inverseBindMatrices: 6}],";
    check_refused(load_parts(&scene, "skin.glb", &parts), "follows joint 1, but its skin has 1");
    parts.more = "skins: [{joints: [0, 1], inverseBindMatrices: 6}],";
    check_refused(load_parts(&scene, "skin.glb", &parts),
                  "skin 0: inverseBindMatrices: 1 for 2 joints");
}

/* --- the same pose whatever came before ------------------------------------------------------- */

static const char moving_scene[] = "scenes/metaballs.glb";

/* The triangles of a geometry without the room that dynamic parts leave. */
static void check_same_triangles(const struct geometry *a, const struct geometry *b) {
    assert_int_equal(a->part_count, b->part_count);
    assert_memory_equal(a->bounds_min, b->bounds_min, sizeof a->bounds_min);
    assert_memory_equal(&a->radius, &b->radius, sizeof a->radius);
    for (int i = 0; i < a->part_count; i++) {
        const struct geometry_part *x = &a->parts[i], *y = &b->parts[i];
        assert_int_equal(x->index_count, y->index_count);
        for (uint32_t k = 0; k < x->index_count; k++) {
            uint32_t u = a->indices[x->first_index + k], v = b->indices[y->first_index + k];
            assert_memory_equal(a->position[u], b->position[v], sizeof *a->position);
            assert_memory_equal(a->normal[u], b->normal[v], sizeof *a->normal);
        }
    }
}

TEST(order_of_poses) {
    static const double times[] = {3.2, 0, 19.96, 7.04, 3.2};
    struct scene scene;
    struct geometry one, other;
    check_ok("scene", scene_load(&scene, moving_scene));
    assert_true(scene_duration(&scene) > 0);
    check_ok("geometry", geometry_init(&one, &scene, 0));
    for (int i = 0; i < 5; i++) {
        check_ok("pose", geometry_pose(&one, &scene, times[i]));
        check_ok("geometry", geometry_init(&other, &scene, times[i]));
        printf("    at %5.2f s %u triangles\n", times[i], geometry_triangle_count(&one));
        check_same_triangles(&one, &other);
        geometry_free(&other);
    }
    /* The walls have not moved since the first pose. */
    for (int i = 0; i < one.part_count; i++)
        assert_int_equal(one.parts[i].moved == one.laid_out, !one.parts[i].dynamic);
    geometry_free(&one);
    scene_free(&scene);
}

/* --- bounds ----------------------------------------------------------------------------------- */

static void check_bounds(const struct geometry *geometry, const float low[3], const float high[3]) {
    for (int c = 0; c < 3; c++) {
        check_near("low", (double)geometry->bounds_min[c], (double)low[c], 1e-6);
        check_near("high", (double)geometry->bounds_max[c], (double)high[c], 1e-6);
    }
}

/* A unit square goes to x = 10 and back to 4: its clip's bounds are the same at all times, and its
 * sphere holds it at each. */
TEST(bounds_of_clip) {
    static const float values[] = {0, 0, 0, 10, 0, 0, 4, 0, 0};
    OWNED(scene) scene;
    OWNED(geometry) geometry, first;
    load_clip(&scene, CLIP_ACCESSORS("count: 3, type: VEC3"),
              CLIPS(CLIP("translation", "LINEAR") "," CLIP("scale", "LINEAR")), values, 9);
    check_ok("one clip", clips_select(&scene, "translation"));
    check_ok("geometry", geometry_init(&first, &scene, 0));
    check_ok("geometry", geometry_init(&geometry, &scene, 3.3));
    check_bounds(&first, (float[]){0, 0, 0}, (float[]){11, 1, 0});
    check_near("radius", (double)first.radius, 5 + sqrt(.5), 1e-6);
    for (double time = 0; time <= 5; time += .37) {
        check_ok("pose", geometry_pose(&geometry, &scene, time));
        assert_memory_equal(geometry.bounds_min, first.bounds_min, sizeof first.bounds_min);
        assert_memory_equal(geometry.bounds_max, first.bounds_max, sizeof first.bounds_max);
        assert_memory_equal(geometry.center, first.center, sizeof first.center);
        assert_memory_equal(&geometry.radius, &first.radius, sizeof first.radius);
        assert_true(geometry.parts[0].farthest <= geometry.radius);
    }
    check_ok("other clip", clips_select(&scene, "scale"));
    check_ok("pose", geometry_pose(&geometry, &scene, 0));
    check_bounds(&geometry, (float[]){0, 0, 0}, (float[]){10, 0, 0});
}

/* Of one pose alone where that is asked for, and where nothing moves. */
TEST(bounds_of_pose) {
    static const float values[] = {0, 0, 0, 10, 0, 0, 4, 0, 0};
    static const struct gltf_parts quad = {0};
    struct scene scene;
    struct geometry moved, still, whole;
    load_clip(&scene, CLIP_ACCESSORS("count: 3, type: VEC3"), CLIPS(CLIP("translation", "LINEAR")),
              values, 9);
    check_ok("geometry", geometry_init_still(&moved, &scene, 2));
    check_bounds(&moved, (float[]){10, 0, 0}, (float[]){11, 1, 0});
    geometry_free(&moved);
    scene_free(&scene);
    check_ok("quad", load_parts(&scene, "quad.glb", &quad));
    check_ok("geometry", geometry_init_still(&still, &scene, 0));
    check_ok("geometry", geometry_init(&whole, &scene, 0));
    assert_memory_equal(whole.bounds_min, still.bounds_min, sizeof still.bounds_min);
    assert_memory_equal(whole.bounds_max, still.bounds_max, sizeof still.bounds_max);
    assert_memory_equal(whole.center, still.center, sizeof still.center);
    assert_memory_equal(&whole.radius, &still.radius, sizeof still.radius);
    geometry_free(&still);
    geometry_free(&whole);
    scene_free(&scene);
}

/* --- what is left out ------------------------------------------------------------------------- */

/* Channels of nobody, or of what no node has, and joints beyond four are dropped; the rest moves */
TEST(left_out) {
    OWNED(scene) scene;
    hear_notes();
    load_clip(&scene, CLIP_ACCESSORS("count: 3, type: VEC3"),
              CLIPS("{channels: [{sampler: 0, target: {path: scale}}, {sampler: 0, target: {node: "
                    "0, path: pointer}}, {sampler: 0, target: {node: 0, path: translation}}], "
                    "samplers: [{input: 2, output: 3}]}"),
              (float[]){10, 0, 0, 20, 0, 0, 40, 0, 0}, 9);
    printf("    %s\n", notes);
    assert_non_null(strstr(notes, "animation of 'pointer'"));
    assert_int_equal(scene.clips[0].channel_count, 1);
    check_near("x", (double)translation_x(&scene, 1.5), 15, 1e-5);
    scene_free(&scene);
    struct {
        unsigned char joints[4][4];
        float weights[4][4];
    } extra = {{{0}}, {{1}, {1}, {1}, {1}}};
    check_ok(
        "joints",
        load_parts(&scene, "joints.glb",
                   &PARTS(.accessors = "[" PARTS_QUAD
                                       ", {bufferView: 0, byteOffset: 64, componentType: 5121, "
                                       "count: 4, type: VEC4}, {bufferView: 0, byteOffset: 80, "
                                       "componentType: 5126, count: 4, type: VEC4}]",
                          .meshes = "[{primitives: [{attributes: {POSITION: 0, JOINTS_0: 2, "
                                    "WEIGHTS_0: 3, JOINTS_1: 2, WEIGHTS_1: 3}, indices: 1}]}]",
                          .nodes = "[{mesh: 0, skin: 0}]", .more = "skins: [{joints: [0]}],",
                          EXTRA(extra))));
    end_notes();
    printf("    %s\n", notes);
    assert_non_null(strstr(notes, "more than four joints a vertex"));
    assert_int_equal(scene.meshes[0].primitives[0].joint_bound, 1);
}

/* A mesh at two places, each with the node's own weights of its morph targets. */
TEST(weights_of_places) {
    float places[2][3] = {{1, 0, 0}, {2, 0, 0}};
    OWNED(scene) scene;
    check_ok(
        "places",
        load_parts(&scene, "places.glb",
                   &PARTS(.accessors = "[" PARTS_QUAD ", {bufferView: 0, byteOffset: 64, "
                                       "componentType: 5126, count: 2, type: VEC3}]",
                          .meshes = "[{weights: [0.5], primitives: [{attributes: {POSITION: 0}, "
                                    "indices: 1, targets: [{POSITION: 0}]}]}]",
                          .nodes = "[{mesh: 0, weights: [0.25], extensions: "
                                   "{EXT_mesh_gpu_instancing: {attributes: {SCALE: 2}}}}]",
                          EXTRA(places))));
    assert_int_equal(scene.node_count, 3);
    for (int i = 1; i < 3; i++) {
        check_near("weight", (double)scene.nodes[i].weights[0], .25, 0);
        check_near("scale", (double)scene.nodes[i].scale[0], i, 0);
    }
    check_near("the mesh's own", (double)scene.meshes[0].weights[0], .5, 0);
}

/* --- refusals --------------------------------------------------------------------------------- */

/* Bad channels are left out; under --strict they are refused, as the last one is anyway. */
TEST(refusals) {
    static const struct {
        const char *message, *accessors, *more;
        float extra[EXTRA_FLOATS];
    } hostile[] = {
        {"channel 0: input: time 1 is 1 s",
         CLIP_ACCESSORS("count: 3, type: VEC3"),
         CLIPS(CLIP("scale", "LINEAR")),
         {1, 1, 2}},
        {"channel 0: input: time 0 is -1 s",
         CLIP_ACCESSORS("count: 3, type: VEC3"),
         CLIPS(CLIP("scale", "LINEAR")),
         {-1, 1, 2}},
        {"channel 0: input: time 2 is inf s",
         CLIP_ACCESSORS("count: 3, type: VEC3"),
         CLIPS(CLIP("scale", "LINEAR")),
         {0, 1, 0x1p127F * 2}},
        {"channel 0: output: 9 elements, not 3",
         CLIP_ACCESSORS("count: 9, type: VEC3"),
         CLIPS(CLIP("scale", "LINEAR")),
         {0, 1, 2}},
        {"channel 0: output: accessor 3 has 2 numbers an element, not 3",
         CLIP_ACCESSORS("count: 3, type: VEC2"),
         CLIPS(CLIP("scale", "LINEAR")),
         {0, 1, 2}},
        {"channel 0: output: number 1 is inf",
         CLIP_ACCESSORS("count: 3, type: VEC3"),
         CLIPS(CLIP("scale", "STEP")),
         {0, 1, 2, [VALUES + 1] = 0x1p127F * 2}},
        {"channel 0: output: value 0 is a quaternion of length 0",
         CLIP_ACCESSORS("count: 3, type: VEC4"),
         CLIPS(CLIP("rotation", "STEP")),
         {0, 1, 2}},
        {"weights of a node without morph targets",
         CLIP_ACCESSORS("count: 3, type: SCALAR"),
         CLIPS(CLIP("weights", "STEP")),
         {0, 1, 2}},
        {"animation 0: channel 0: its sampler is 4, but there are 0",
         NULL,
         CLIPS("{channels: [{sampler: 4, target: {path: scale}}], samplers: []}"),
         {0}},
        {"node: 8, but there are 1 nodes",
         NULL,
         CLIPS("{channels: [{sampler: 0, target: {node: 8, path: scale}}], samplers: []}"),
         {0}},
        {"skin 0: it has no joints", NULL, "skins: [{joints: []}],", {0}},
    };
    for (size_t i = 0; i < sizeof hostile / sizeof *hostile; i++) {
        struct gltf_parts parts = {.accessors = hostile[i].accessors,
                                   .more = hostile[i].more,
                                   .extra = hostile[i].extra,
                                   .extra_size = sizeof hostile[i].extra};
        struct scene scene;
        if (i + 1 < sizeof hostile / sizeof *hostile) {
            check_ok(hostile[i].message, load_parts(&scene, "clip.glb", &parts));
            check_near("channels", scene.clips[0].channel_count, 0, 0);
            scene_free(&scene);
        }
        check_ok("strict", read_rules_set(true, NULL));
        bool loaded = load_parts(&scene, "clip.glb", &parts);
        check_ok("not strict", read_rules_set(false, NULL));
        printf("    %s\n", loaded ? "loaded" : error_get());
        assert_false(loaded);
        if (!strstr(error_get(), hostile[i].message))
            fail_msg("expected '%s'", hostile[i].message);
    }
}

RUN_TESTS(NULL, NULL)
