/* EXR files of other programs: windows in place, parts and layers by name, as read and as `compare`
 * tells. */
#include "command_support.h"
#include "exr_parts.h"

#include "metrics/layer.h"

static bool read_layer(struct image *layer, const char *path, const char *name) {
    bool encoded;
    hear_notes();
    bool ok = layer_read(layer, path, name, &encoded);
    end_notes();
    printf("    '%s' of %s: %s\n    %s", name, path, ok ? "read" : error_get(),
           *notes ? notes : "\n");
    return ok;
}

static void compare(int status, const char *arguments) {
    expect_command(status, "compare", arguments);
}

/* --- windows ---------------------------------------------------------------------------------- */

static bool is_within(const int window[4], int x, int y) {
    return x >= window[0] && y >= window[1] && x < window[0] + window[2] &&
           y < window[1] + window[3];
}

/* Every pixel of the display window against the value that the file has there, or black. The
 * channels' order is B G R. */
static void check_part(const struct image *layer, const struct exr_part *part) {
    int wrong = 0;
    assert_int_equal(layer->width, part->display[2]);
    assert_int_equal(layer->height, part->display[3]);
    for (int y = 0; y < layer->height; y++)
        for (int x = 0; x < layer->width; x++)
            for (int c = 0; c < 3; c++) {
                int px = part->display[0] + x, py = part->display[1] + y;
                float value = is_within(part->data, px, py) ? exr_value(part, 2 - c, px, py) : 0;
                wrong += image_at(layer, x, y)[c] != value;
            }
    printf("    %dx%d, wrong values: %d\n", layer->width, layer->height, wrong);
    assert_int_equal(wrong, 0);
}

TEST(windows) {
    need_all_formats();
    static const struct {
        struct exr_part part;
        const char *note;
    } cases[] = {
        {{0, "B G R", {0, 0, 6, 4}, {0, 0, 6, 4}, .base = 1}, ""},
        {{0, "B G R", {2, 1, 3, 2}, {0, 0, 6, 4}, .base = 1},
         "3x2 at 2,1, lies in the display window, 6x4"},
        {{0, "B G R", {-2, -1, 5, 3}, {0, 0, 6, 4}, .base = 1},
         "5x3 at -2,-1, is cut to the display"},
        {{0, "B G R", {4, 2, 5, 5}, {0, 0, 6, 4}, .base = 1},
         "is cut to the display window, 6x4 at 0,0"},
        {{0, "B G R", {-3, -3, 12, 10}, {0, 0, 6, 4}, .base = 1}, "is cut to"},
        {{0, "B G R", {1, 2, 6, 4}, {0, 0, 6, 4}, .base = 1}, "is cut to"},
        {{0, "B G R", {-9, -7, 3, 3}, {-10, -8, 6, 4}, .base = 1},
         "display window, 6x4 at -10,-8; the rest"},
        {{0, "B G R", {20, 0, 2, 2}, {0, 0, 6, 4}, .base = 1},
         "black: its data window, 2x2 at 20,0"},
        {{0, "B G R", {-2147483000, 0, 2, 2}, {2147483000, 0, 6, 4}, .base = 1}, NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        OWNED(image) layer;
        const char *path = exr_write("window.exr", &cases[i].part, 1);
        bool ok = read_layer(&layer, path, "");
        if (cases[i].note) {
            check_ok(path, ok);
            check_part(&layer, &cases[i].part);
            expect_in(notes, cases[i].note);
            assert_int_equal(!*cases[i].note, !*notes);
        }
    }
}

/* rmse of what is 1 in a quarter of the picture, and else black, is the root of 3 of 4. */
TEST(compared_windows) {
    need_all_formats();
    struct image whole;
    const struct exr_part part = {0, "B G R", {3, 2, 3, 2}, {0, 0, 6, 4}, .base = 1};
    const char *test = exr_write("part.exr", &part, 1), *reference = scratch("whole.pfm");
    char arguments[1200];
    image_init(&whole, 6, 4, "R G B");
    for (int y = 0; y < 4; y++)
        for (int x = 0; x < 6; x++)
            for (int c = 0; c < 3; c++)
                image_at(&whole, x, y)[c] =
                    is_within(part.data, x, y) ? exr_value(&part, 2 - c, x, y) : 1;
    check_ok("written", image_write(&whole, reference));
    image_free(&whole);
    snprintf(arguments, sizeof arguments, "%s %s -m rmse -m bias", test, reference);
    compare(0, arguments);
    check_near("rmse", strtod(strstr(output, "rmse") + 4, NULL), sqrt(.75), 1e-6);
    check_near("bias", strtod(strstr(output, "bias") + 4, NULL), -.75, 1e-6);
    const struct exr_part small = {0, "B G R", {3, 2, 3, 2}, {3, 2, 3, 2}, .base = 1};
    snprintf(arguments, sizeof arguments, "%s %s", test, exr_write("small.exr", &small, 1));
    compare(1, arguments);
    expect_text("part.exr is 6x4 (data window 3x2 at 3,2, display window at 0,0), but ");
    expect_text("small.exr is 3x2\n");
}

/* Little files that claim much: refused at once. */
TEST(hostile_windows) {
    need_all_formats();
    static const int displays[][4] = {{0, 0, 2000000000, 2000000000},
                                      {0, 0, 2147483647, 1},
                                      {-2147483647, -2147483647, 2147483647, 2147483647},
                                      {0, 0, 16384, 16384},
                                      {0, 0, 16384, 4097}};
    for (size_t i = 0; i < sizeof displays / sizeof *displays; i++) {
        struct exr_part part = {0, "B G R", {0, 0, 2, 2}, {0}, .base = 1};
        struct image layer;
        memcpy(part.display, displays[i], sizeof part.display);
        assert_false(read_layer(&layer, exr_write("huge.exr", &part, 1), ""));
    }
    expect_in(error_get(), "too large: a display window of 16384x4097 at 0,0 around a data window "
                           "of 2x2 at 0,0");
}

/* --- names ------------------------------------------------------------------------------------ */

struct name_case {
    const char *channels, *parts, *layer;
    const char *taken; /* the channels, or the error's end */
    const char *note;  /* NULL: none */
};

static void check_name(const struct name_case *c) {
    OWNED(image) image;
    int channels[3];
    char text[200];
    image_init(&image, 1, 1, c->channels);
    if (c->parts) {
        struct image names; /* for want of another splitter of words */
        image_init(&names, 1, 1, c->parts);
        image.part_count = names.channel_count;
        image.parts = names.names;
        free(names.pixels);
    }
    bool found = image_find_layer(&image, c->layer, channels);
    char *note = image_layer_note(&image, c->layer);
    if (found)
        snprintf(text, sizeof text, "%s %s %s", image.names[channels[0]], image.names[channels[1]],
                 image.names[channels[2]]);
    else
        snprintf(text, sizeof text, "%s", error_get());
    printf("    '%s' of %s: %s (%s)\n", c->layer, c->channels, text, note ? note : "no note");
    assert_string_equal(text, c->taken);
    assert_int_equal(note != NULL, c->note != NULL);
    if (note)
        expect_in(note, c->note);
    free(note);
}

#define BLENDER                                                                                    \
    "ViewLayer.Combined.R ViewLayer.Combined.G ViewLayer.Combined.B ViewLayer.Combined.A "         \
    "ViewLayer.Depth.Z ViewLayer.DiffCol.R ViewLayer.DiffCol.G ViewLayer.DiffCol.B "               \
    "ViewLayer.Normal.X ViewLayer.Normal.Y ViewLayer.Normal.Z"
#define COMBINED "ViewLayer.Combined.R ViewLayer.Combined.G ViewLayer.Combined.B"

TEST(names) {
    static const struct name_case cases[] = {
        {"R G B A Z", NULL, "", "R G B", NULL},
        {"R G B A Z", NULL, "Z", "Z Z Z", NULL},
        {"R G B A Z", NULL, "A", "A A A", NULL},
        {"R G B A Z", NULL, "depth", "no layer 'depth' (there is: beauty, A, Z)", NULL},
        {"r g b", NULL, "", "r g b", NULL},
        {"r g b R G B", NULL, "", "R G B", NULL},
        {"rgba.red rgba.green rgba.blue", NULL, "", "rgba.red rgba.green rgba.blue",
         "'rgba' is taken"},
        {"X Y Z", NULL, "", "X Y Z", "channels X, Y and Z are taken"},
        {"Y Z", NULL, "beauty", "Y Y Y", NULL},
        {"Y A", NULL, "", "Y Y Y", NULL},
        {"X Y", NULL, "", "no layer 'beauty' (there is: X, Y)", NULL},
        {"R", NULL, "", "no layer 'beauty': G and B are missing (there is: R)", NULL},
        {"R", NULL, "R", "R R R", NULL},
        {"R B", NULL, "", "no layer 'beauty': G is missing (there is: R, B)", NULL},
        {"n.X n.Y n.Z U V", NULL, "n", "n.X n.Y n.Z", NULL},
        {"n.X n.Y n.Z U V", NULL, "V", "V V V", NULL},
        {"n.X n.Y n.Z n.Q", NULL, "n.Q", "n.Q n.Q n.Q", NULL},
        {"uv.U uv.V", NULL, "uv", "no layer 'uv' (there is: uv.U, uv.V)", NULL},
        {"a.R a.G", NULL, "a", "no layer 'a': B is missing (there is: a.R, a.G)", NULL},
        {"a.R a.G a.B b.R b.G b.B", NULL, "", "no layer 'beauty' (there is: a, b)", NULL},
        {"a.R a.G a.B b.Z", NULL, "", "a.R a.G a.B", "layer 'a' is taken (there is: a, b)"},
        {BLENDER, NULL, "", COMBINED, "layer 'ViewLayer.Combined' is taken"},
        {BLENDER, NULL, "Combined", COMBINED, "layer 'ViewLayer.Combined' is taken"},
        {BLENDER, NULL, "ViewLayer", COMBINED, "layer 'ViewLayer.Combined' is taken"},
        {BLENDER, NULL, "ViewLayer.Combined", COMBINED, NULL},
        {BLENDER, NULL, "Depth", "ViewLayer.Depth.Z ViewLayer.Depth.Z ViewLayer.Depth.Z", "Depth"},
        {BLENDER, NULL, "Normal", "ViewLayer.Normal.X ViewLayer.Normal.Y ViewLayer.Normal.Z", "N"},
        {BLENDER, NULL, "Mist",
         "no layer 'Mist' (there is: ViewLayer.Combined, ViewLayer.Depth, ViewLayer.DiffCol, "
         "ViewLayer.Normal)",
         NULL},
        {"R G B", NULL, "Combined", "R G B", "channels R, G and B are taken"},
        {"R G B", NULL, "Normal", "no layer 'Normal' (there is: beauty)", NULL},
        {"N.R N.G N.B beauty.R beauty.G beauty.B", "N beauty", "", "beauty.R beauty.G beauty.B",
         "'beauty' is taken (there is: N, beauty)"},
        {"N.R N.G N.B C.R C.G C.B", "N C", "", "C.R C.G C.B", "'C' is taken"},
        {"N.R N.G N.B x.R x.G x.B", "N x", "", "x.R x.G x.B", "'x' is taken (there is: N, x)"},
        {"N.R N.G N.B", "N", "", "N.R N.G N.B", "'N' is taken"},
        {"depth.Z one.R one.G one.B two.R two.G two.B", "depth one two", "", "one.R one.G one.B",
         "'one' is taken"},
        {"depth.Z one.R one.G one.B", "depth one", "depth", "depth.Z depth.Z depth.Z", NULL},
        {"p.d.R p.d.G p.d.B q.R q.G q.B", "p q", "p.d", "p.d.R p.d.G p.d.B", NULL},
        {"p.d.R p.d.G p.d.B q.R q.G q.B", "p q", "d", "p.d.R p.d.G p.d.B", "'p.d' is taken"},
        {"p.d.R p.d.G p.d.B q.R q.G q.B", "p q", "p", "p.d.R p.d.G p.d.B", "'p.d' is taken"},
        {"p.d.R p.d.G p.d.B q.R q.G q.B", "p q", "", "q.R q.G q.B", "'q' is taken"},
        {"a.Z b.U b.V", "a b", "", "no layer 'beauty' (there is: a, b.U, b.V)", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        check_name(&cases[i]);
}

/* More layers than a message holds: as many as there is room for, and that there are more. */
TEST(many_names) {
    char *names[500];
    struct image image;
    int channels[3];
    for (int i = 0; i < 500; i++)
        names[i] = mem_printf("a rather long layer's name, number %d.U", i);
    image_init_named(&image, 1, 1, (const char *const *)names, 500);
    check_refused(image_find_layer(&image, "none", channels), "");
    assert_true(strlen(error_get()) < 1600);
    expect_in(error_get(), ", ...)");
    image_free(&image);
    for (int i = 0; i < 500; i++)
        free(names[i]);
}

/* --- parts ------------------------------------------------------------------------------------ */

TEST(parts) {
    need_all_formats();
    static const struct exr_part parts[3] = {
        {"depth", "Z", {0, 0, 6, 4}, {0, 0, 6, 4}, .base = 1},
        {"N", "B G R", {0, 0, 6, 4}, {0, 0, 6, 4}, .base = 2},
        {"rgba", "B G R spec.B spec.G spec.R", {2, 1, 3, 2}, {0, 0, 6, 4}, .base = 3}};
    const char *path = exr_write("parts.exr", parts, 3);
    struct image layer, all;
    check_ok("beauty", read_layer(&layer, path, ""));
    check_part(&layer, &parts[2]);
    expect_in(notes, "layer 'rgba' is taken (there is: depth, N, rgba, rgba.spec)");
    expect_in(notes, "its data window, 3x2 at 2,1");
    image_free(&layer);
    check_ok("N", read_layer(&layer, path, "N"));
    check_part(&layer, &parts[1]);
    assert_string_equal(notes, "");
    image_free(&layer);
    check_ok("depth", read_layer(&layer, path, "depth"));
    assert_true(image_at(&layer, 5, 3)[1] == exr_value(&parts[0], 0, 5, 3));
    image_free(&layer);
    check_ok("spec", read_layer(&layer, path, "rgba.spec"));
    assert_true(image_at(&layer, 2, 1)[0] == exr_value(&parts[2], 5, 2, 1));
    assert_true(image_at(&layer, 5, 1)[0] == 0);
    image_free(&layer);
    assert_false(read_layer(&layer, path, "nothing"));
    expect_in(error_get(), "parts.exr: no layer 'nothing' (there is: depth, N, rgba, rgba.spec)");
    check_ok("all", image_read(&all, path));
    assert_int_equal(all.channel_count, 10);
    assert_int_equal(all.part_count, 3);
    int at = image_find_channel(&all, "rgba.spec.G");
    assert_true(at >= 0 && image_at(&all, 4, 2)[at] == exr_value(&parts[2], 4, 4, 2));
    image_free(&all);
}

/* A name for each file; JSON tells both. */
TEST(two_names) {
    need_all_formats();
    static const struct exr_part one = {0,
                                        "L.x.B L.x.G L.x.R",
                                        {0, 0, 6, 4},
                                        {0, 0, 6, 4},
                                        .base = 1},
                                 two = {0, "B G R Z", {0, 0, 6, 4}, {0, 0, 6, 4}, .base = 1.5f};
    char arguments[1200];
    const char *paths =
        form("%s %s -m rmse", exr_write("one.exr", &one, 1), exr_write("two.exr", &two, 1));
    snprintf(arguments, sizeof arguments, "%s -l L.x --reference-layer beauty --json", paths);
    compare(0, arguments);
    check_near("rmse", strtod(strstr(output, "rmse\": ") + 7, NULL), .5, 1e-6);
    expect_text("\"layer\": \"L.x\", \"reference-layer\": \"beauty\"");
    snprintf(arguments, sizeof arguments, "%s -l L.x.R --reference-layer Z", paths);
    compare(0, arguments); /* the third channel against the fourth */
    check_near("rmse", strtod(strstr(output, "rmse") + 4, NULL), .625, 1e-6);
    snprintf(arguments, sizeof arguments, "%s -l L.x", paths);
    compare(1, arguments);
    expect_text("two.exr: no layer 'L.x' (there is: beauty, Z)");
}

/* --- inputs of others ------------------------------------------------------------------------- */

TEST(cases) {
    static const struct {
        const char *arguments;
        double relative_rmse;
    } cases[] = {
        {"compare-windows/test.exr compare-windows/elsewhere.exr", 1.8337},
        {"compare-windows/test.exr compare-windows/whole.exr", .822359},
        {"compare-parts/depth-first.exr compare-parts/ref.exr", .10595},
        {"compare-xyz/test.exr compare-xyz/ref.exr", .10595},
        {"compare-names/blender.exr compare-names/ref.exr", .10595},
        {"compare-names/blender.exr compare-names/ref.exr -l ViewLayer.Combined --reference-layer "
         "beauty",
         .10595},
        {"compare-names/blender.exr compare-names/ref.exr -l Combined", .10595},
        {"compare-names/lower.exr compare-names/ref.exr", .10595},
        {"compare-alpha/rgba128.png compare-alpha/rgb.png", 0},
    };
    if (!shared_path())
        return;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        expect(0, form("cd %s/cases && %% compare -m relative-rmse %s", shared_path(),
                       cases[i].arguments));
        check_near("relative-rmse", strtod(strstr(output, "relative-rmse  ") + 13, NULL),
                   cases[i].relative_rmse, 1e-5);
    }
}

RUN_TESTS(NULL, NULL)
