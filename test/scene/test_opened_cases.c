/* Files of public reports that other readers open: the picture that is right, where they
 * are there. */
#include "command_support.h"
#include "gltf_parts.h"

#include "base/image.h"

#include <unistd.h>

/* Whether the case is there; its path. */
static bool find_case(const char *name, char path[512]) {
    snprintf(path, 512, "../shared/cases/%s", name);
    return access(path, R_OK) == 0;
}

static void render(const char *path, const char *options, struct image *image) {
    const char *picture = scratch("case.exr");
    remove(picture);
    expect(0, form("%% render %s %s --size 32x32 -o @/case.exr", path, options));
    check_ok(picture, image_read(image, picture));
}

/* The middle of the layer. */
static void check_layer(const struct image *image, const char *layer, const float expected[3],
                        double tolerance) {
    int channels[3];
    check_ok(layer, image_find_layer(image, layer, channels));
    for (int c = 0; c < 3; c++)
        check_near(*layer ? layer : "beauty", (double)image_at(image, 16, 16)[channels[c]],
                   (double)expected[c], tolerance);
}

/* A plane of base colour .5 under a sun of pi lux. */
TEST(planes) {
    static const char *const cases[] = {
        "bad-clip/equal-times.gltf",   "bad-clip/negative-time.gltf",
        "buffer-longer/bin.gltf",      "data-uri-type/buffer-charset.gltf",
        "glb-tail/tail.glb",           "loose-numbers/count-4.0.gltf",
        "loose-numbers/stride-0.gltf", "loose-numbers/roughness-1.0000001.gltf",
        "matrix-row/m44.gltf",         "part-of-primitive/no-position.gltf",
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char path[512];
        struct image image;
        if (!find_case(cases[i], path))
            continue;
        printf("  %s\n", cases[i]);
        render(path, "", &image);
        check_layer(&image, "", (float[]){.5F, .5F, .5F}, .01);
        check_layer(&image, "direct", (float[]){1, 1, 1}, .01);
        image_free(&image);
    }
}

/* The colour of a picture. */
TEST(pictures) {
    static const char *const cases[] = {
        "data-uri-type/jpg.gltf",
        "data-uri-type/empty.gltf",
        "data-uri-type/webp.gltf",
        "parent-folder/model/parent.gltf",
        "parent-folder/model/backslash.gltf",
        "parent-folder/model/dots-inside.gltf",
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char path[512];
        struct image image;
        if (!find_case(cases[i], path))
            continue;
        printf("  %s\n", cases[i]);
        render(path, "", &image);
        check_layer(&image, "albedo", (float[]){.5776F, .1274F, .0319F}, .02);
        image_free(&image);
    }
}

#define QUAD(material)                                                                             \
    "{primitives: [{attributes: {POSITION: 0}, indices: 1, material: " material "}]}"
#define NODE(mesh) "{rotation: [0.18, 0.24, 0, 0.9539392], mesh: " mesh "}"
#define COLOUR(rgb)                                                                                \
    "{doubleSided: true, pbrMetallicRoughness: {metallicFactor: 0, baseColorFactor: [" rgb ", "    \
    "1]}}"

/* Of two surfaces at one depth the later material shows, in frames and references. */
TEST(coplanar) {
    static const char *const commands[] = {"render --quality draft", "reference --spp 1"};
    const char *path = write_parts(
        "decal.glb",
        &PARTS(.meshes = "[" QUAD("0") "," QUAD("1") "]", .nodes = "[" NODE("0") "," NODE("1") "]",
               .materials = "[" COLOUR("1, 0, 0") "," COLOUR("0, 1, 0") "]"));
    for (int i = 0; i < 2; i++) {
        OWNED(image) image;
        expect_command(0, commands[i], form("%s --size 32x32 -o @/decal.exr", path));
        check_ok("decal.exr", image_read(&image, scratch("decal.exr")));
        check_layer(&image, "albedo", (float[]){0, 1, 0}, .01);
    }
}

/* What is shown of a file, in one layer. */
TEST(shown) {
    static const struct {
        const char *name, *options, *layer;
        float expected[3];
    } cases[] = {
        {"json-not-utf8/latin1.gltf", "", "direct", {1, 1, 1}},
        {"node-visibility/mesh.gltf", "", "albedo", {1, 1, 1}},
        {"node-visibility/required-hidden.gltf", "", "albedo", {1, 1, 1}},
        {"scene-root-has-parent/parent-inside.gltf", "", "direct", {1, 1, 1}},
        {"scene-root-has-parent/parent-outside.gltf", "", "direct", {1, 1, 1}},
        {"variants-and-scenes/variants.gltf", "", "albedo", {1, 1, 1}},
        {"variants-and-scenes/variants.gltf", "--variant red", "albedo", {1, 0, 0}},
        {"variants-and-scenes/two-scenes.gltf", "", "albedo", {1, 0, 0}},
        {"variants-and-scenes/two-scenes.gltf", "--scene 0", "albedo", {1, 1, 1}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char path[512];
        struct image image;
        if (!find_case(cases[i].name, path))
            continue;
        printf("  %s %s\n", cases[i].name, cases[i].options);
        render(path, cases[i].options, &image);
        check_layer(&image, cases[i].layer, cases[i].expected, .01);
        image_free(&image);
    }
}

TEST(skies) {
    static const char *const skies[] = {"negative", "inf", "odd"};
    char plane[512], sky[512];
    if (!find_case("sky-values/plane.gltf", plane))
        skip();
    for (int i = 0; i < 3; i++) {
        struct image image;
        const char *name = form("sky-values/%s.exr", skies[i]);
        if (!find_case(name, sky))
            continue;
        printf("  %s\n", name);
        const char *options = form("--light sky --environment %s", sky);
        render(plane, options, &image);
        if (strcmp(skies[i], "negative") == 0)
            check_layer(&image, "direct", (float[]){1, 1, 1}, .05);
        image_free(&image);
    }
}

/* What info says of each, and its status. */
TEST(messages) {
    static const struct {
        const char *name;
        int status;
        const char *text;
    } cases[] = {
        {"draco-count/count.gltf", 0, "2 triangles (2 without"},
        {"meshopt-unmarked/unmarked.gltf", 0, "2 triangles (2 without"},
        {"meshopt-unmarked/khr.gltf", 0, "2 triangles (2 without"},
        {"messages/gltf1.gltf", 1, "glTF version 1.0; 2.0 is read"},
        {"messages/pointer.glb", 1, "a Git LFS pointer"},
        {"messages/comment.gltf", 1, "parse error at line 1, column 1"},
        {"messages/points.gltf", 0, "points     primitives 1"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char path[512];
        if (!find_case(cases[i].name, path))
            continue;
        expect_command(cases[i].status, "info", path);
        expect_text(cases[i].text);
    }
}

RUN_TESTS(be_quiet, NULL)
