/* Clips that move numbers of lights, cameras and materials, and nodes by pointer
 * [KHR_animation_pointer]. */
#include "gltf_parts.h"
#include "render_support.h"

enum { SIZE = 24 };

/* A clip of two keys, at 0 s and 2 s, of which each has so many numbers. */
struct keys {
    float times[2], values[8];
};

#define TARGET(pointer)                                                                            \
    "{sampler: 0, target: {path: pointer, extensions: {KHR_animation_pointer: {pointer: '" pointer \
    "'}}}}"
#define NODE_TARGET "{sampler: 0, target: {node: 0, path: translation}}"

/* A white square before a wall, an unlit one beside them, a spot, a disk, a perspective camera and
 * a flat one. */
static const char *write_clip(const char *channels, const float *values, int width) {
    static const char *const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    static char more[4096], accessors[512];
    struct keys keys = {.times = {0, 2}};
    memcpy(keys.values, values, 2 * (size_t)width * sizeof *values);
    snprintf(accessors, sizeof accessors,
             "[" PARTS_QUAD
             ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 2, type: SCALAR}, "
             "{bufferView: 0, byteOffset: 72, componentType: 5126, count: 2, type: '%s'}]",
             types[width]);
    snprintf(more, sizeof more,
             "cameras: [{type: perspective, perspective: {yfov: 1, znear: 0.1, zfar: 9}}, {type: "
             "orthographic, orthographic: {xmag: 1, ymag: 1, znear: 0.1, zfar: 9}}], extensions: "
             "{KHR_lights_punctual: {lights: [{type: spot, intensity: 3, range: 9, spot: "
             "{innerConeAngle: 0.2, outerConeAngle: 0.9}}]}, EXT_lights_area: {lights: [{type: "
             "disk, intensity: 2, size: 0.5}]}}, animations: [{name: first, samplers: [{input: 2, "
             "output: 3}], channels: [%s]}],",
             channels);
    return write_parts(
        "pointers.glb",
        &PARTS(.accessors = accessors, .more = more,
               .materials = "[{pbrMetallicRoughness: {metallicFactor: 0}}, {pbrMetallicRoughness: "
                            "{metallicFactor: 0}, extensions: {KHR_materials_unlit: {}}}]",
               .meshes = "[{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}, "
                         "{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 1}]}]",
               .nodes =
                   "[{mesh: 0}, {camera: 0, translation: [0.9, 0.5, 2]}, {camera: 1, translation: "
                   "[0.5, 0.5, 2]}, {translation: [0.5, 0.5, 3], extensions: {KHR_lights_punctual: "
                   "{light: 0}}}, {translation: [0.5, 0.5, 3], extensions: {EXT_lights_area: "
                   "{light: 0}}}, {mesh: 1, translation: [1.2, 0, 0.5]}, {mesh: 0, translation: "
                   "[0, 0, 1], rotation: [0, 0.70710678, 0, 0.70710678]}, {mesh: 0, extensions: "
                   "{KHR_node_visibility: {visible: false}}}]",
               EXTRA(keys)));
}

/* --- numbers ---------------------------------------------------------------------------------- */

enum object { SPOT, DISK, CAMERA, FLAT_CAMERA, MATERIAL, UNLIT };

struct row {
    const char *pointer;
    enum object object;
    size_t offset;
    int width;
    float values[8];
    double expected; /* at 1 s */
};

static double number_at(const struct stage *stage, const struct row *row) {
    struct camera cameras[2];
    for (int i = 0; i < 2; i++)
        camera_place(&cameras[i], &stage->scene, i, 1);
    const void *const objects[] = {
        &stage->emitters.items[0],  &stage->emitters.items[1], &cameras[0], &cameras[1],
        &stage->scene.materials[0], &stage->scene.materials[1]};
    float number;
    memcpy(&number, (const char *)objects[row->object] + row->offset, sizeof number);
    return (double)number;
}

#define OF_LIGHT "/extensions/KHR_lights_punctual/lights/0/"
#define OF_AREA "/extensions/EXT_lights_area/lights/0/"
#define PBR "/materials/0/pbrMetallicRoughness/"
#define STRENGTH "/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength"
#define EMITTER(field) offsetof(struct emitter, field)
#define VISIBLE "/extensions/KHR_node_visibility/visible"
#define VIEW(field) offsetof(struct camera, field)
#define SURFACE(field) offsetof(struct material, field)

/* Half way between the keys; what leaves its bounds is clamped. */
TEST(numbers) {
    static const struct row rows[] = {
        {OF_LIGHT "intensity", SPOT, EMITTER(intensity), 1, {2, 6}, 4},
        {OF_LIGHT "intensity", SPOT, EMITTER(intensity), 1, {-4, 2}, 0},
        {OF_LIGHT "color", SPOT, EMITTER(intensity), 3, {0, 0, 0, 1, 1, 1}, 1.5},
        {OF_LIGHT "range", SPOT, EMITTER(range), 1, {2, 4}, 3},
        {OF_LIGHT "spot/outerConeAngle", SPOT, EMITTER(cos_outer), 1, {.5F, .7F}, .825336},
        {OF_LIGHT "spot/innerConeAngle", SPOT, EMITTER(cos_inner), 1, {.5F, .7F}, .825336},
        {OF_LIGHT "spot/outerConeAngle", SPOT, EMITTER(cos_inner), 1, {.1F, .1F}, .995004},
        {OF_AREA "color", DISK, EMITTER(intensity), 3, {0, 0, 0, 1, 1, 1}, .19635},
        {OF_AREA "intensity", DISK, EMITTER(intensity), 1, {0, 8}, .785398},
        {"/cameras/0/perspective/yfov", CAMERA, VIEW(fov_y), 1, {1, 2}, 1.5},
        {"/cameras/0/perspective/yfov", CAMERA, VIEW(fov_y), 1, {7, 9}, 3.140593},
        {"/cameras/0/perspective/znear", CAMERA, VIEW(near), 1, {1, 2}, 1.5},
        {"/cameras/0/perspective/zfar", CAMERA, VIEW(far), 1, {4, 6}, 5},
        {"/cameras/0/perspective/zfar", CAMERA, VIEW(far), 1, {0, .1F}, 0},
        {"/cameras/1/orthographic/ymag", FLAT_CAMERA, VIEW(y_extent), 1, {1, 2}, 1.5},
        {"/cameras/1/orthographic/zfar", FLAT_CAMERA, VIEW(far), 1, {4, 6}, 5},
        {PBR "baseColorFactor", MATERIAL, SURFACE(base_color), 4, {0, 0, 0, 1, 1, 0, 0, 1}, .5},
        {PBR "metallicFactor", MATERIAL, SURFACE(metalness), 1, {0, 1}, .5},
        {PBR "roughnessFactor", MATERIAL, SURFACE(roughness), 1, {0, 4}, 1},
        {"/materials/0/emissiveFactor", MATERIAL, SURFACE(emission), 3, {0, 0, 0, 1, 1, 1}, .5},
        {STRENGTH, MATERIAL, SURFACE(emissive_strength), 1, {2, 4}, 3},
        {"/materials/0/normalTexture/scale", MATERIAL, SURFACE(normal_scale), 1, {1, 2}, 1.5},
        {"/materials/1/emissiveFactor", UNLIT, SURFACE(emission), 3, {1, 1, 1, 1, 1, 1}, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const char *channel = form(TARGET("%s"), rows[i].pointer);
        hear_notes();
        OWNED(stage) stage = open_stage(write_clip(channel, rows[i].values, rows[i].width));
        end_notes();
        if (strstr(notes, "shown without") || strstr(notes, "left out"))
            fail_msg("%s: %s", rows[i].pointer, notes);
        check_ok("pose", stage_pose(&stage, 1));
        check_near(rows[i].pointer, number_at(&stage, &rows[i]), rows[i].expected, 1e-5);
    }
}

/* The user's factor and the file's, which multiply, leave area lights and emission alone. */
TEST(punctual_scale) {
    static const float values[] = {2, 6};
    struct stage stage;
    struct stage_desc desc = {.path = write_clip(TARGET(OF_LIGHT "intensity"), values, 1),
                              .punctual_scale = .5F};
    check_ok("open", stage_init(&stage, &desc) && stage_pose(&stage, 1));
    check_near("spot", (double)stage.emitters.items[0].intensity[0], 2, 1e-6);
    check_near("disk", (double)stage.emitters.items[1].intensity[0], .392699, 1e-5);
    stage_free(&stage);
    for (int i = 0; i < 12; i++) {
        static const char *const generators[] = {"v3.3.32", "v3.6.6", "v4.2.1"};
        static const char *const extras[] = {"", ", extras: {punctual_scale: 0.25}"};
        bool emits = i / 6;
        const char *asset = form("{version: '2.0', generator: 'Khronos glTF Blender I/O %s'%s}",
                                 generators[i % 3], extras[i / 3 % 2]);
        desc.path = write_parts(
            "blender.glb",
            &PARTS(.asset = asset, .materials = emits ? "[{emissiveFactor: [1, 1, 1]}]" : NULL,
                   .nodes = "[{mesh: 0}, {extensions: {KHR_lights_punctual: {light: 0}}}]",
                   .more = "extensions: {KHR_lights_punctual: {lights: [{type: point, intensity: "
                           "8}]}},"));
        desc.punctual_scale = 1;
        hear_notes();
        check_ok("open", stage_init(&stage, &desc));
        end_notes();
        bool is_noted = strstr(notes, "--punctual-scale .001464") != NULL;
        check_near(asset, is_noted, emits && i % 3 < 2 && i / 3 % 2 == 0, 0);
        check_near("intensity", (double)stage.emitters.items[0].intensity[0], i / 3 % 2 ? 2 : 8, 0);
        stage_free(&stage);
    }
    desc = (struct stage_desc){.path = "scenes/table.glb", .punctual_scale = 2};
    check_refused(stage_init(&stage, &desc), "no punctual light");
}

TEST(nodes) {
    static const float values[] = {0, 0, 0, 4, 0, 0};
    float worlds[16][16];
    OWNED(stage) stage = open_stage(write_clip(TARGET("/nodes/0/translation"), values, 3));
    scene_node_worlds(&stage.scene, 1, worlds);
    check_near("moved", (double)worlds[0][12], 2, 1e-6);
    stage_free(&stage);
    stage = open_stage(write_clip(TARGET("/nodes/7/translation"), values, 3));
    assert_true(stage.scene.nodes[7].hidden);
    stage_free(&stage);
    stage = open_stage(write_clip(TARGET("/nodes/4/scale") "," NODE_TARGET, values, 3));
    scene_node_worlds(&stage.scene, 1, worlds);
    check_near("moved by its node", (double)worlds[0][12], 2, 1e-6);
    check_near("scaled", (double)worlds[4][0], 2, 1e-6);
}

static bool is_point(const struct geometry *geometry, int part) {
    const struct geometry_part *at = &geometry->parts[part];
    return memcmp(geometry->position[at->first_vertex], geometry->position[at->first_vertex + 2],
                  sizeof *geometry->position) == 0;
}

/* Shown, hidden and shown again with all below, light too; what a clip shows may begin hidden. */
TEST(visibility) {
    static const float values[] = {1, 0};
    OWNED(stage) stage;
    stage = open_stage(write_clip(
        TARGET("/nodes/0" VISIBLE) "," TARGET("/nodes/3" VISIBLE) "," TARGET("/nodes/7" VISIBLE),
        values, 1));
    for (int step = 0; step < 3; step++) {
        bool is_shown = step != 1;
        check_ok("pose", stage_pose(&stage, is_shown ? 0 : 2));
        assert_true(is_point(&stage.geometry, 0) != is_shown);
        assert_false(is_point(&stage.geometry, 1));
        assert_true(is_point(&stage.geometry, 3) != is_shown);
        check_near("spot", (double)stage.emitters.items[0].intensity[0], is_shown ? 3 : 0, 0);
    }
    stage.scene.playing_count = 0;
    check_ok("pose", stage_pose(&stage, 2));
    assert_true(is_point(&stage.geometry, 3));
    assert_false(is_point(&stage.geometry, 0));
}

/* What cannot be played is told by its name; what is not there is a bad channel. */
TEST(notes) {
    static const float values[8] = {0};
    static const struct {
        const char *pointer, *note;
    } rows[] = {
        {"/materials/0/extensions/KHR_materials_sheen/sheenRoughnessFactor",
         "shown without: animation of '/materials/0/extensions/KHR_materials_sheen/"},
        {"/cameras/0/perspective/aspectRatio",
         "shown without: animation of '/cameras/0/perspective/aspectRatio'"},
        {OF_LIGHT "intensity/0", "shown without: animation of '" OF_LIGHT "intensity/0'"},
        {"/cameras/7/perspective/yfov", "channel 0: number 7, but there are 2"},
        {"/extensions/KHR_lights_punctual/lights/1/intensity", "number 1, but there are 1"},
        {"/nodes/0/weights", "channel 0: weights of a node without morph targets"},
        {"/materials/0/emissiveFactor", "output: accessor 3 has 1 numbers an element, not 3"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(scene) scene;
        const char *channel = form(TARGET("%s"), rows[i].pointer);
        hear_notes();
        check_ok(rows[i].pointer, scene_load(&scene, write_clip(channel, values, 1)));
        end_notes();
        if (!strstr(notes, rows[i].note))
            fail_msg("'%s' is not in:\n%s", rows[i].note, notes);
    }
}

/* --- pictures --------------------------------------------------------------------------------- */

static struct image trace(struct stage *stage) {
    return TRACE(stage, .width = SIZE, .height = SIZE, .samples = 16, .bounces = 2,
                 .centers = true);
}

/* A renderer that follows shows at each time what a new one shows, and so does the path tracer. */
static void check_followed(const char *pointer, const float *values, int width,
                           const char *technique, const char *settings) {
    struct stage stage, fresh;
    struct renderer renderer;
    const char *channel = form(TARGET("%s"), pointer);
    const char *path = write_clip(channel, values, width);
    stage = open_stage(path);
    struct renderer_desc desc = desc_of(&stage, technique, settings, SIZE, SIZE);
    open_renderer(&renderer, desc);
    for (int step = 1; step >= 0; step--) {
        OWNED(image) followed, expected;
        double time = step ? 2 : .5;
        check_ok("pose", stage_pose(&stage, time));
        check_ok("show", stage_show(&stage, &renderer));
        renderer_render(&renderer);
        check_ok("layers", renderer_read_layers(&renderer, &followed));
        fresh = open_stage(path);
        check_ok("pose", stage_pose(&fresh, time));
        expected = render_stage(&fresh, technique, settings, SIZE);
        OWNED(image) traced = trace(&fresh), common = common_layers(&traced);
        double mean = layer_mean(&common, "");
        printf("    %s, %s at %g s\n", technique, pointer, time);
        if (!same_pixels(&followed, &expected))
            fail_msg("%s: %s at %g s: another picture than a new renderer's", technique, pointer,
                     time);
        check_near("as the path tracer", layer_mean(&followed, ""), mean, .05 * mean);
        stage_free(&fresh);
    }
    renderer_free(&renderer);
    stage_free(&stage);
}

TEST(pictures) {
    static const struct {
        const char *pointer;
        int width;
        float values[8];
    } rows[] = {
        {OF_LIGHT "intensity", 1, {0, 40}},
        {PBR "baseColorFactor", 4, {0, 0, 0, 1, 1, .5F, 0, 1}},
        {PBR "metallicFactor", 1, {0, 1}},
        {"/nodes/6" VISIBLE, 1, {0, 1}},
        {"/materials/0/emissiveFactor", 3, {0, 0, 0, 3, 3, 0}},
    };
    size_t count = sizeof rows / sizeof *rows;
    for (size_t i = is_long_run() ? 0 : count - 1; i < count; i++) {
        check_followed(rows[i].pointer, rows[i].values, rows[i].width, "clustered",
                       "lights.bounces=2");
        if (is_long_run())
            check_followed(rows[i].pointer, rows[i].values, rows[i].width, "implicit-visibility",
                           "");
    }
}

RUN_TESTS(open_group_context, close_group_context)
