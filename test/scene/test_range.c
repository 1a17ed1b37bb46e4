/* How far lights shine and cameras see: a light's range, a camera's znear and zfar. Squares across
 * the axis of a camera, whose light and depth are known; renderer beside path tracer. */
#define _XOPEN_SOURCE 700
#include "gltf_parts.h"
#include "render_support.h"

#include "base/file/file.h"
#include "base/log.h"
#include "direct/direct.h"
#include "scene/placing.h"
#include "techniques/technique.h"

#include <cglm/cglm.h>

enum { SIZE = 48 };

/* --- lights ----------------------------------------------------------------------------------- */

#define LIGHT(place) "{translation: " place ", extensions: {KHR_lights_punctual: {light: 0}}}"

/* A white square of 2 m below a light at 2 m; the camera at 5 m. */
static void open_square(struct stage *stage, const char *light, const char *more_nodes) {
    const char *more = form("cameras: [{type: perspective, perspective: {yfov: 0.2, znear: 0.1}}], "
                            "extensions: {KHR_lights_punctual: {lights: [%s]}},",
                            light);
    const char *nodes = form("[{mesh: 0, scale: [2, 2, 2], translation: [-1, -1, 0]},{camera: 0, "
                             "translation: [0, 0, 5]}," LIGHT("[0, 0, 2]") "%s]",
                             more_nodes);
    *stage = open_stage(write_parts("square.glb", &PARTS(.nodes = nodes, .more = more)));
}

static double at_middle(const struct image *image, const char *channel) {
    return (double)image_at(image, SIZE / 2, SIZE / 2)[image_find_channel(image, channel)];
}

#define POINT(range) "{type: point, intensity: 12.566370614, range: " range "}"
#define SPOT(range)                                                                                \
    "{type: spot, intensity: 12.566370614, range: " range                                          \
    ", spot: {innerConeAngle: 0.5, outerConeAngle: 0.7}}"

/* By KHR_lights_punctual, 1 - (2 / range)^4 of the light arrives. */
TEST(light) {
    static const struct {
        const char *light, *more;
        double value;
    } rows[] = {
        {POINT("1.5"), "", 0},
        {POINT("2"), "", 0},
        {POINT("2.5"), "", 1 - .4096},
        {POINT("4"), "", .9375},
        {POINT("1000"), "", 1},
        {SPOT("1.5"), "", 0},
        {SPOT("4"), "", .9375},
        {POINT("4"), "," LIGHT("[0, 0, 1]"), .9375 + 4 * (1 - 1 / 256.)},
        {POINT("1e-30"), "", 0},
        {"{type: directional, intensity: 3.14159265, range: 1}", "", 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage;
        open_square(&stage, rows[i].light, rows[i].more);
        OWNED(image) image = render_stage(&stage, "clustered", "vpls=64 vals=8", SIZE);
        OWNED(image) traced = trace_stage(&stage, SIZE, 1);
        check_near("direct, rendered", at_middle(&image, "direct.R"), rows[i].value, .004);
        check_near("direct, traced", at_middle(&traced, "direct.R"), rows[i].value, .004);
    }
}

/* All methods of direct light. */
TEST(methods) {
    for (const struct direct_method *const *method = direct_methods; *method; method++) {
        OWNED(stage) stage;
        open_square(&stage, POINT("2.5"), "");
        struct renderer_desc desc = desc_of(&stage, "clustered", "vpls=64 vals=8", SIZE, SIZE);
        desc.direct = *method;
        OWNED(image) image = render_layers(&desc);
        check_near((*method)->name, at_middle(&image, "direct.R"), 1 - .4096, .004);
    }
}

/* A cube of 2 m from within: light in its middle ends at walls' middles, but for a range of
 * 1.2 m. */
static struct {
    float corners[8][3];
    uint8_t inwards[36];
} cube;

static void open_room(struct stage *stage, const char *range) {
    static const uint8_t faces[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                        {4, 6, 7, 5}, {0, 1, 3, 2}, {2, 3, 7, 6}};
    for (int i = 0; i < 8; i++)
        for (int c = 0; c < 3; c++)
            cube.corners[i][c] = i >> c & 1 ? 1 : -1;
    for (int f = 0; f < 6; f++)
        for (int k = 0; k < 6; k++)
            cube.inwards[f * 6 + k] = faces[f][k < 3 ? k : k == 3 ? 0 : k - 2];
    const char *more =
        form("cameras: [{type: perspective, perspective: {yfov: 1.5, znear: 0.01}}], extensions: "
             "{KHR_lights_punctual: {lights: [" POINT("%s") "]}},",
             range);
    *stage = open_stage(write_parts(
        "room.glb",
        &PARTS(.accessors = "[{bufferView: 0, byteOffset: 64, componentType: 5126, count: 8, type: "
                            "VEC3}, {bufferView: 0, byteOffset: 160, componentType: 5121, count: "
                            "36, type: SCALAR}]",
               .nodes = "[{mesh: 0}, {camera: 0, translation: [0, 0, 0.9]}," LIGHT("[0, 0, 0]") "]",
               .more = more, EXTRA(cube))));
}

/* Reflected light begins with what is left of it, in every technique. */
TEST(reflected) {
    OWNED(stage) stage;
    open_room(&stage, "1.2");
    OWNED(image) traced = trace_stage(&stage, SIZE, 64);
    double reference = layer_mean(&traced, "indirect"), direct = layer_mean(&traced, "direct");
    for (const struct technique *const *technique = techniques; *technique; technique++) {
        OWNED(image) image = render_stage(&stage, (*technique)->name, "", SIZE);
        check_near("direct", layer_mean(&image, "direct") / direct, 1, .02);
        check_near((*technique)->name, layer_mean(&image, "indirect") / reference, 1, .12);
    }
    stage_free(&stage);
    image_free(&traced);
    open_room(&stage, "100");
    traced = trace_stage(&stage, SIZE, 16);
    check_at_most("light within the range", 1.5 * reference, layer_mean(&traced, "indirect"));
}

/* --light changes it. */
TEST(text) {
    OWNED(stage) stage;
    OWNED(emitters) emitters = {0};
    open_square(&stage, POINT("4"), "");
    check_near("of the file", stage.emitters.items[0].range, 4, 0);
    check_ok("range=9", emitters_from_text(&emitters, &stage.scene, "0 range=9", 0));
    check_near("changed", emitters.items[0].range, 9, 0);
    char *text = emitters_to_text(&emitters, &stage.scene, 0);
    assert_string_equal(text, "0 range=9");
    assert_false(emitters_from_text(&emitters, &stage.scene, "0 range=-1", 0));
    free(text);
}

/* --- cameras ---------------------------------------------------------------------------------- */

/* Squares of 4 m at 5 m and of 1 m at 2 m of a camera of that kind. */
static void open_squares(struct stage *stage, const char *kind, const char *range) {
    bool flat = strcmp(kind, "orthographic") == 0;
    const char *more =
        form("cameras: [{type: '%s', '%s': {%s, %s}}],extensions: {KHR_lights_punctual: {lights: "
             "[{type: directional, intensity: 3.14159265}]}},",
             kind, kind, flat ? "xmag: 1, ymag: 1" : "yfov: 0.6", range);
    *stage = open_stage(write_parts(
        "squares.glb",
        &PARTS(.nodes =
                   "[{mesh: 0, scale: [4, 4, 4], translation: [-2, -2, 0]},{mesh: 0, translation: "
                   "[-0.5, -0.5, 3]},{camera: 0, translation: [0, 0, 5]}," LIGHT("[0, 0, 9]") "]",
               .more = more)));
}

/* Depths at the middle, and at a corner, 0 where nothing is. Light is not cut: the near square's
 * shadow stays. */
TEST(camera) {
    static const struct {
        const char *range;
        double middle, corner, direct;
    } rows[] = {{"znear: 0.1, zfar: 100", 2, 5, 1},  {"znear: 0.1, zfar: 0", 2, 5, 1},
                {"znear: 4, zfar: 100", 5, 5, 0},    {"znear: 2.5, zfar: 5.5", 5, 5, 0},
                {"znear: 0.1, zfar: 4", 2, 0, 1},    {"znear: 3, zfar: 4", 2, 5, 1},
                {"znear: 100, zfar: 1000", 2, 5, 1}, {"znear: 4, zfar: 3", 5, 5, 0},
                {"znear: -9, zfar: 4", 2, 0, 1}};
    static const char *const kinds[] = {"perspective", "orthographic"};
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
            OWNED(stage) stage;
            open_squares(&stage, kinds[k], rows[i].range);
            struct image images[] = {
                render_stage(&stage, "clustered", "vpls=64 vals=8", SIZE),
                render_stage(&stage, "clustered", "vpls=64 vals=8 samples=8", SIZE),
                trace_stage(&stage, SIZE, 1)};
            for (int n = 0; n < 3; n++) {
                int z = image_find_channel(&images[n], "Z");
                check_near("middle", at_middle(&images[n], "Z"), rows[i].middle, 1e-3);
                check_near("corner", (double)image_at(&images[n], 1, 1)[z], rows[i].corner, 1e-3);
                check_near("direct", at_middle(&images[n], "direct.R"), rows[i].direct, 1e-2);
                image_free(&images[n]);
            }
        }
}

static char beyond[256]; /* the last note of zfar */

static void keep_note(const struct log_sink *sink, enum log_kind kind, const char *message) {
    (void)sink, (void)kind;
    if (strstr(message, "beyond its zfar"))
        snprintf(beyond, sizeof beyond, "%s", message);
}

/* How much of the view lies beyond zfar is noted: the far square, none, or a part of it. */
TEST(beyond) {
    static const struct {
        const char *range, *note;
    } rows[] = {
        {"znear: 0.1, zfar: 4", "2 of 4 triangles in its view reach beyond its zfar of 4 m"},
        {"znear: 0.1, zfar: 1.5", ""}, /* it sees nothing, so it sees all */
        {"znear: 0.1, zfar: 100", ""},
        {"znear: 0.1", ""}};
    const struct log_sink sink = {keep_note};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage;
        *beyond = '\0';
        log_set_sink(&sink);
        open_squares(&stage, "perspective", rows[i].range);
        log_set_sink(NULL);
        printf("    %s: %s\n", rows[i].range, beyond);
        assert_true(*rows[i].note ? strstr(beyond, rows[i].note) != NULL : *beyond == '\0');
    }
}

/* --camera changes it; what is cut is not there in the picture's edges either. */
TEST(camera_text) {
    OWNED(stage) stage;
    char text[PLACING_TEXT_SIZE];
    open_squares(&stage, "perspective", "znear: 0.1, zfar: 100");
    check_ok("near=4", camera_from_text(&stage.camera, &stage.scene, "0 near=4", 0, NULL));
    camera_to_text(&stage.camera, &stage.scene, 0, 0, text);
    assert_string_equal(text, "0 near=4");
    OWNED(image) image = render_stage(&stage, "clustered", "vpls=64 vals=8 samples=8", SIZE);
    check_near("depth", at_middle(&image, "Z"), 5, 1e-3);
}

/* --- cases of the public reports -------------------------------------------------------------- */

TEST(cases) {
    static const struct {
        const char *file, *channel;
        double value;
    } rows[] = {{"camera-near/near.gltf", "Z", 5},
                {"light-range/range-1.5.gltf", "direct.R", 0},
                {"light-range/range-4.gltf", "direct.R", .9375}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows && shared_path(); i++) {
        const char *path = form("%s/cases/%s", shared_path(), rows[i].file);
        if (!file_can_be_read(path))
            continue;
        struct stage stage = open_stage(path);
        OWNED(image) image = render_stage(&stage, "clustered", "vpls=64 vals=8", SIZE);
        OWNED(image) traced = trace_stage(&stage, SIZE, 1);
        check_near(rows[i].file, at_middle(&image, rows[i].channel), rows[i].value, .002);
        check_near(rows[i].file, at_middle(&traced, rows[i].channel), rows[i].value, .002);
        stage_free(&stage);
    }
}

int main(void) {
    log_set_level(LOG_QUIET);
    return run_file(__FILE__, open_group_context, close_group_context);
}
