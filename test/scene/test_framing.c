/* Camera and lights for files that bring none: little scenes of boxes, and what is seen of them. */
#define _XOPEN_SOURCE 700
#include "base/unit.h"
#include "cube_parts.h"
#include "render_support.h"

#include "base/log.h"

enum { PICTURE = 160 };

/* Mesh 0 is the cube, whose triangles face outwards, mesh 1 the same inwards; and the two keys of a
 * walk. */
struct cube_and_walk {
    struct cube_bytes cube;
    float times[2], places[2][3];
};

#define CUBE(indices)                                                                              \
    "{primitives: [{attributes: {POSITION: 0}, indices: " indices ", material: 0}]}"
#define BOX(x, y, z, sx, sy, sz)                                                                   \
    "{mesh: 0, translation: [" #x "," #y "," #z "], scale: [" #sx "," #sy "," #sz "]}"
#define HOLLOW(x, y, z, sx, sy, sz)                                                                \
    "{mesh: 1, translation: [" #x "," #y "," #z "], scale: [" #sx "," #sy "," #sz "]}"

static void open_cubes(struct stage *stage, const char *name, const char *nodes, const char *more) {
    struct cube_and_walk bytes = {
        .cube = make_cube(), .times = {0, 4}, .places = {{-4, 0, 0}, {4, 0, 0}}};
    *stage = open_stage(write_parts(
        name, &PARTS(.accessors = "[" CUBE_ACCESSORS
                                  ", {bufferView: 0, byteOffset: 232, componentType: 5126, count: "
                                  "2, type: SCALAR}, {bufferView: 0, byteOffset: 240, "
                                  "componentType: 5126, count: 2, type: VEC3}]",
                     .materials = "[{pbrMetallicRoughness: {metallicFactor: 0, baseColorFactor: "
                                  "[0.7, 0.6, 0.5, 1]}}]",
                     .meshes = "[" CUBE("1") "," CUBE("2") "]", .nodes = nodes, .more = more,
                     EXTRA(bytes))));
}

/* The picture, kept for the eye too. What is covered is neither black nor burnt out. */
static void check_picture(const struct stage *stage, const char *name) {
    OWNED(image) image = render_stage(stage, "clustered", "vpls=64 vals=8", PICTURE);
    const char *file = form("%s.exr", name);
    check_ok("write", image_write(&image, scratch(file)));
    int r = image_find_channel(&image, "R"), a = image_find_channel(&image, "A");
    double sum = 0;
    int covered = 0, black = 0;
    for (int i = 0; i < PICTURE * PICTURE; i++) {
        const float *pixel = image.pixels + (size_t)i * (size_t)image.channel_count;
        if (pixel[a] < .999F)
            continue;
        covered++;
        black += pixel[r] < .02F;
        sum += (double)pixel[r];
    }
    check_at_most("a tenth of the picture is covered", .1 * PICTURE * PICTURE, covered);
    check_at_most("share of black", (double)black / covered, .03); /* undersides */
    check_near("mean radiance", sum / covered, .4, .3);
}

/* How far the corners of the bounds are from the middle of the picture, where 1 is its edge. */
static double reach_in_picture(const struct stage *stage) {
    double most = 0;
    for (int corner = 0; corner < 8; corner++) {
        float point[3], place[2];
        for (int c = 0; c < 3; c++)
            point[c] =
                (corner >> c & 1 ? stage->geometry.bounds_max : stage->geometry.bounds_min)[c];
        if (!camera_project(&stage->camera, point, 1, place))
            return INFINITY;
        most = fmax(most, fabs((double)place[0] - .5) * 2);
        most = fmax(most, fabs((double)place[1] - .5) * 2);
    }
    return most;
}

/* Of the bounds, whose edge is at 1, how far out a place lies. */
static double place_in_bounds(const struct stage *stage, const float place[3]) {
    double most = 0;
    for (int c = 0; c < 3; c++) {
        double half = (double)(stage->geometry.bounds_max[c] - stage->geometry.bounds_min[c]) / 2;
        most = fmax(most, fabs((double)(place[c] - stage->geometry.center[c])) / half);
    }
    return most;
}

static const char figure[] =
    "[" BOX(0, 1.2, 0, 0.25, 0.4, 0.15) "," HOLLOW(0, 1.2, 0, 0.24, 0.39, 0.14) "," BOX(
        0, 1.75, 0, 0.1, 0.12,
        0.1) "," BOX(-0.5, 1.4, 0, 0.24, 0.07,
                     0.07) "," BOX(0.5, 1.4, 0, 0.24, 0.07,
                                   0.07) "," BOX(-0.13, 0.4, 0, 0.1, 0.4,
                                                 0.1) "," BOX(0.13, 0.4, 0, 0.1, 0.4, 0.1) "]";

static const char walker[] = "[{children: [1, 2, 3]}," BOX(0, 1.2, 0, 0.25, 0.4, 0.15) "," BOX(
    -0.13, 0.4, 0, 0.1, 0.4, 0.1) "," BOX(0.13, 0.4, 0, 0.1, 0.4, 0.1) "," BOX(0, -0.1, 0, 6, 0.1,
                                                                               2) "]";

static const char walk[] = "animations: [{samplers: [{input: 3, output: 4}], channels: [{sampler: "
                           "0, target: {node: 0, path: translation}}]}],";

/* A thing alone is seen from outside, all of it: a block on a slab; a millimetre far out; a figure
 * whose body is hollow, with walls that face its middle; one that walks, wherever it goes. */
TEST(objects) {
    static const struct {
        const char *name, *nodes, *more;
    } rows[] = {
        {"block", "[" BOX(0, 1, 0, 0.5, 1, 0.5) "," BOX(0, -0.1, 0, 2, 0.1, 2) "]", NULL},
        {"part",
         "[" BOX(50, 3, -20, 0.0005, 0.0005, 0.0005) "," BOX(50, 3.001, -20, 0.0002, 0.001,
                                                             0.0002) "]",
         NULL},
        {"figure", figure, NULL},
        {"walker", walker, walk},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage;
        const char *file = form("%s.glb", rows[i].name);
        open_cubes(&stage, file, rows[i].nodes, rows[i].more);
        check_near("reach in the picture", reach_in_picture(&stage), .95, .03);
        check_at_most("outside of the bounds", 1.2, place_in_bounds(&stage, stage.camera.eye));
        check_at_most("outside of the bounds", 1.2,
                      place_in_bounds(&stage, stage.emitters.items[0].position));
        check_picture(&stage, rows[i].name);
    }
}

/* A room is seen from within: of walls without thickness; with walls that have an outside; with a
 * cupboard in its very middle. */
TEST(rooms) {
    static const struct {
        const char *name, *nodes;
    } rows[] = {
        {"room", "[" HOLLOW(0, 1.5, 0, 3, 1.5, 2) "," BOX(1, 0.4, 0, 0.8, 0.4, 0.4) "]"},
        {"house", "[" HOLLOW(0, 1.5, 0, 3, 1.5, 2) "," BOX(0, 1.5, 0, 3.2, 1.7, 2.2) "]"},
        {"cupboard", "[" HOLLOW(0, 1.5, 0, 3, 1.5, 2) "," BOX(0, 1, 0, 0.4, 1, 0.4) "]"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage;
        const char *file = form("%s.glb", rows[i].name);
        open_cubes(&stage, file, rows[i].nodes, NULL);
        check_at_most("the camera is within", place_in_bounds(&stage, stage.camera.eye), .99);
        assert_int_equal(stage.emitters.count, 2);
        for (int k = 0; k < 2; k++)
            check_at_most("a light is within",
                          place_in_bounds(&stage, stage.emitters.items[k].position), .99);
        check_picture(&stage, rows[i].name);
    }
}

/* Lights stand where the file's camera sees what they light, even from below, and whatever size its
 * node has. */
TEST(camera_of_file) {
    OWNED(stage) stage;
    open_cubes(
        &stage, "camera.glb",
        "[" BOX(0, 1, 0, 0.5, 1, 0.5) "," BOX(
            0, -0.1, 0, 2, 0.1,
            2) ",{camera: 0, translation: [0, 1.5, -6], rotation: [0, 1, 0, 0], scale: [3, 3, 3]}]",
        "cameras: [{type: perspective, perspective: {yfov: 0.7, znear: 1}}],");
    assert_int_equal(stage.emitters.count, 2);
    const struct emitter *spot = &stage.emitters.items[0];
    check_near("the camera is the file's", stage.camera.eye[2], -6, 1e-5);
    check_at_most("the spot is on its side", spot->position[2], -1);
    check_at_most("and above", 2, spot->position[1]);
    vec3 to;
    glm_vec3_sub(stage.geometry.center, (float *)spot->position, to);
    vec3_unit(to);
    check_near("towards the centre", glm_vec3_dot(to, (float *)spot->direction), 1, 1e-5);
    check_picture(&stage, "camera");
}

int main(void) {
    log_set_level(LOG_QUIET);
    return run_file(__FILE__, open_group_context, close_group_context);
}
