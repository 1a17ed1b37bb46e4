/* --background: what is seen behind all surfaces. A square of one colour, whose left and right
 * edges cover a quarter of a pixel each, by render and reference. */
#include "command_support.h"
#include "gltf_parts.h"

#include "base/file/file.h"
#include "metrics/colour.h"

enum {
    SIDE = 20,
    EDGE = 3,
    MIDDLE = 10,
    OUTSIDE = 0
}; /* columns: a quarter, all, none is covered */

static const float colour[3] = {.5F, .25F, .8F}; /* of the square */

/* Renders the square with more arguments: back.exr and back.EXTENSION. */
static void render(const char *scene, const char *extension, const char *more) {
    expect(0, form("%% render @/%s -o @/back.exr -o @/back.%s --size 20x20 -q "
                   "--set vpls=16,vals=2,map-size=32,rsm-size=32,shadow-size=64,interleave=1 %s",
                   scene, extension, more));
}

/* The row in the middle of the picture, colours and alpha as they are stored. */
static void read_row(const char *name, unsigned char row[SIDE][4]) {
    struct file_bytes bytes;
    OWNED(bitmap) bitmap;
    check_ok(name, file_read(&bytes, scratch(name)));
    check_ok(name, bitmap_decode(&bitmap, bytes.data, bytes.size));
    assert_true(bitmap.width == SIDE && bitmap.height == SIDE);
    memcpy(row, bitmap.rgba + (size_t)SIDE * SIDE / 2 * 4, (size_t)SIDE * 4);
    free(bytes.data);
}

/* Of back.exr. */
static void read_pixel(int x, float rgba[4]) {
    OWNED(image) image;
    check_ok("back.exr", image_read(&image, scratch("back.exr")));
    for (int c = 0; c < 4; c++)
        rgba[c] =
            image_at(&image, x, SIDE / 2)[image_find_channel(&image, (const char[]){"RGBA"[c], 0})];
}

static float edge_coverage(void) {
    float rgba[4];
    read_pixel(EDGE, rgba);
    check_near("coverage of the edge", (double)rgba[3], .25, .1);
    return rgba[3];
}

static void check_bytes(const char *what, const unsigned char rgba[4], const float light[3],
                        float alpha, double tolerance) {
    for (int c = 0; c < 3; c++)
        check_near(what, rgba[c], 255 * (double)srgb_encode(light[c]), tolerance);
    check_near(what, rgba[3], 255 * (double)alpha, .51);
}

static int make_scenes(void **state) {
    (void)state;
    static const char camera[] = "\"cameras\": [{\"type\": \"orthographic\", \"orthographic\":"
                                 " {\"xmag\": 0.8, \"ymag\": 0.8, \"znear\": 0.1, \"zfar\": 9}}],"
                                 " \"extensionsUsed\": [\"KHR_materials_unlit\"], ";
    struct gltf_parts parts = {
        .materials = "[{\"pbrMetallicRoughness\": {\"metallicFactor\": 0, \"baseColorFactor\":"
                     " [0.5, 0.25, 0.8, 1]}, \"extensions\": {\"KHR_materials_unlit\": {}}}]",
        .nodes = "[{\"mesh\": 0}, {\"camera\": 0, \"translation\": [0.5, 0.5, 2]}]",
        .more = camera};
    write_parts("square.glb", &parts);
    parts.materials = "[{\"pbrMetallicRoughness\": {\"metallicFactor\": 0}}]";
    write_parts("white.glb", &parts);
    OWNED(image) sky;
    image_init(&sky, 2, 1, "R G B");
    for (int i = 0; i < 6; i++)
        sky.pixels[i] = .5F;
    bool ok = image_write(&sky, scratch("sky.exr"));
    return ok ? 0 : -1;
}

/* --- pictures --------------------------------------------------------------------------------- */

/* The edge has the surface's colour, not one darkened by what lies behind. */
static void check_transparent(const char *name, double tolerance) {
    unsigned char row[SIDE][4];
    float a = edge_coverage();
    read_row(name, row);
    check_bytes("middle", row[MIDDLE], colour, 1, tolerance);
    check_bytes("edge", row[EDGE], colour, a, tolerance);
    assert_int_equal(row[OUTSIDE][3], 0);
}

TEST(transparent) {
    render("square.glb", "png", "--background none");
    check_transparent("back.png", .51);
    if (knows_format("tga")) {
        render("square.glb", "tga", "--background none");
        check_transparent("back.tga", .51);
    }
    render("square.glb", "png", "--background none --passes 2");
    check_transparent("back.png", .51);
}

/* Exposure and tone map are the surface's alone. */
TEST(transparent_exposed) {
    unsigned char row[SIDE][4];
    float brighter[3] = {1, .5F, 1};
    render("square.glb", "png", "--background none --set exposure=1");
    read_row("back.png", row);
    check_bytes("edge", row[EDGE], brighter, edge_coverage(), .51);
    render("square.glb", "png", "--background none --set tone-map=filmic");
    read_row("back.png", row);
    assert_memory_equal(row[EDGE], row[MIDDLE], 3);
}

TEST(colour) {
    static const struct {
        const char *arguments;
        float light[3];
    } cases[] = {{"--background 1,.5,0", {1, .5F, 0}},
                 {"--background \"#3060c0\"", {48, 96, 192}},
                 {"--background 3060C0 --passes 2", {48, 96, 192}},
                 {"--background 0,0,0", {0, 0, 0}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        unsigned char row[SIDE][4];
        float behind[3], blended[3];
        render("square.glb", "png", cases[i].arguments);
        float a = edge_coverage();
        for (int c = 0; c < 3; c++) {
            float value = cases[i].light[c];
            behind[c] = value > 1 ? srgb_decode(value / 255) : value;
            blended[c] = a * colour[c] + (1 - a) * behind[c];
        }
        read_row("back.png", row);
        check_bytes("middle", row[MIDDLE], colour, 1, .51);
        check_bytes("edge", row[EDGE], blended, 1, .6);
        check_bytes("outside", row[OUTSIDE], behind, 1, .51);
    }
}

/* Without the option: black, as a colour of 0, and no alpha channel. */
TEST(without) {
    unsigned char plain[SIDE][4], black[SIDE][4];
    render("square.glb", "png", "");
    read_row("back.png", plain);
    render("square.glb", "png", "--background 000000");
    read_row("back.png", black);
    assert_memory_equal(plain, black, sizeof plain);
    assert_int_equal(plain[OUTSIDE][3], 255);
}

/* TIFF has the light that it has without the option, and EXR's coverage. */
TEST(tiff) {
    struct file_bytes files[2];
    struct image tiff, exr;
    static const char *const backgrounds[] = {"", "--background none"};
    for (int i = 0; i < 2; i++) {
        render("square.glb", "tif", backgrounds[i]);
        check_ok("back.tif", file_read(&files[i], scratch("back.tif")));
    }
    assert_true(files[0].size == files[1].size);
    assert_memory_equal(files[0].data, files[1].data, files[0].size);
    check_ok("back.tif", image_read(&tiff, scratch("back.tif")));
    check_ok("back.exr", image_read(&exr, scratch("back.exr")));
    for (int x = 0; x < SIDE; x++)
        for (int c = 0; c < 4; c++) {
            int channel = image_find_channel(&exr, (const char[]){"RGBA"[c], 0});
            check_near("as in EXR", (double)image_at(&tiff, x, SIDE / 2)[c],
                       (double)image_at(&exr, x, SIDE / 2)[channel], 1e-3);
        }
    images_free(&tiff, &exr);
    for (int i = 0; i < 2; i++)
        free(files[i].data);
}

/* --- skies ------------------------------------------------------------------------------------ */

/* The sky is not seen, in EXR either, and lights the square as before. */
TEST(sky) {
    static const char *const backgrounds[] = {"", "--background none", "--background 1,0,0"};
    float lit[3][4], outside[3][4], edge[3][4];
    for (int i = 0; i < 3; i++) {
        const char *arguments = form("--environment @/sky.exr --light sky %s", backgrounds[i]);
        render("white.glb", "png", arguments);
        read_pixel(MIDDLE, lit[i]);
        read_pixel(OUTSIDE, outside[i]);
        read_pixel(EDGE, edge[i]);
    }
    for (int i = 1; i < 3; i++) {
        assert_memory_equal(lit[0], lit[i], sizeof lit[0]);
        check_near("no sky", (double)outside[i][1], 0, 0);
        check_near("EXR is associated", (double)edge[i][1], (double)(edge[i][3] * lit[i][1]), .02);
    }
    check_near("lit by half a sky of .5", (double)lit[0][1], .5, .05);
    check_near("sky", (double)outside[0][1], .5, .001);
}

TEST(reference) {
    float seen[4], hidden[4], lit[2][4];
    expect(
        0,
        "% reference @/white.glb -o @/back.exr --size 20x20 --spp 16 -q --environment @/sky.exr");
    read_pixel(OUTSIDE, seen);
    read_pixel(MIDDLE, lit[0]);
    expect(0,
           "% reference @/white.glb -o @/back.exr --size 20x20 --spp 16 -q --environment @/sky.exr"
           " --background none");
    read_pixel(OUTSIDE, hidden);
    read_pixel(MIDDLE, lit[1]);
    check_near("sky", (double)seen[1], .5, .001);
    check_near("no sky", (double)hidden[1] + (double)hidden[3], 0, 0);
    assert_memory_equal(lit[0], lit[1], sizeof lit[0]);
}

/* --- refusals --------------------------------------------------------------------------------- */

TEST(refusals) {
    static const char *const formats[] = {"jpg", "bmp", "ppm", "hdr", "pfm", "gif", "webp"};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (!knows_format(formats[i]))
            continue;
        expect(2, form("%% render a.glb -o a.png -o b.%s --background none", formats[i]));
        const char *message =
            form("--background none: b.%s: %s is written without alpha", formats[i], formats[i]);
        expect_text(message);
    }
    static const char *const wrong[] = {"red", "#12345",  "#1234567", "1,2,3",
                                        "1,0", "0,0,0,0", "nan,0,0",  "\"\""};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        expect(2, form("%% render a.glb -o a.png --background '%s'", wrong[i]));
        expect_text("is neither none, #rrggbb nor r,g,b from 0 to 1");
    }
    expect(2, "% render a.glb -o a.exr --background 1,1,1");
    expect_text("--background COLOUR is for PNG");
    expect(2, "% reference a.glb -o a.exr --background 1,1,1");
    expect_text("--background COLOUR is for PNG");
}

RUN_TESTS(make_scenes, NULL)
