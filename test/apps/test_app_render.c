/* manylight render: exit statuses, messages and files, as a shell sees them; and --aov's layers. */
#include "command_support.h"
#include "gltf_parts.h"
#include "render_support.h"

#include "base/file/file.h"
#include "inspect/aov.h"
#include "shared/vpl.h"

#include <unistd.h>

/* A quick frame of the Cornell box with more arguments. */
static void expect_box(int status, const char *format, ...) {
    char arguments[1600] = "scenes/cornell-box.glb --size 40x30 --set vpls=64 --set vals=4 --set "
                           "map-size=32 --set rsm-size=64 --set shadow-size=128 --set samples=1 ";
    size_t used = strlen(arguments);
    va_list more;
    va_start(more, format);
    vsnprintf(arguments + used, sizeof arguments - used, format, more);
    va_end(more);
    expect_command(status, "render", arguments);
}

/* --- refusals --------------------------------------------------------------------------------- */

TEST(usage_errors) {
    static const char *const wrong[][2] = {
        {"", "manylight render: arguments are missing: SCENE"},
        {"a.glb", "no output: -o FILE"},
        {"a.glb b.glb -o c.png", "one argument too many: 'b.glb'"},
        {"a.glb -o picture", "picture: no extension"},
        {"a.glb -o .exr", ".exr: no extension"},
        {"a.glb -o picture.xyz", "picture.xyz"},
        {"a.glb -o b.png --technique radiosity",
         "no technique is called 'radiosity' (there are cluster-lights, clustered, "},
        {"a.glb -o b.png --size 0x10", "1 to 16384"},
        {"a.glb -o b.png --size 10", "size"},
        {"a.glb -o b.png --set vpls=-1", "vpls: '-1' is not a whole number from 0 to 65536"},
        {"a.glb -o b.png --set terms=17", "terms: '17' is not a whole number from 1 to 16"},
        {"a.glb -o b.png --set vals=many", "vals"},
        {"a.glb -o b.png --set nothing=1", "nothing"},
        {"a.glb -o b.png --set path=slow",
         "path: 'slow' is not one of clustered's: draft, fast, normal, traced, high, maps, paper"},
        {"a.glb -o b.png --direct soft",
         "no direct light is called 'soft' (there is hard, pcss, samples, vssm, msm, cssm)"},
        {"a.glb -o b.png --set vpls=63 --set interleave=8", "interleave=8 needs at least 64 VPLs"},
        {"a.glb -o b.png --context cuda", "context"},
        {"a.glb -o b.png --aov val", "--aov is for formats that hold all layers"},
        {NULL},
    };
    expect_refusals(2, "render", wrong);
}

/* Every setting that has a range states it when a value is outside, and takes its ends. */
TEST(ranges) {
    struct settings settings;
    renderer_settings_init(&settings);
    for (struct setting setting = {0}; settings_next(&settings, &setting);) {
        const struct option *row = setting.option;
        char text[64];
        if (row->type != OPTION_INT && row->type != OPTION_FLOAT)
            continue;
        for (int end = 0; end < 2; end++) {
            double limit = end ? row->maximum : row->minimum;
            snprintf(text, sizeof text, "%.10g", limit);
            check_ok(row->name, setting_parse(&setting, &settings, text));
            snprintf(text, sizeof text, "%.10g", limit + (end ? 1 : -1) * (1 + fabs(limit)));
            assert_false(setting_parse(&setting, &settings, text));
            const char *range = form(row->type == OPTION_INT ? "%.0f to %.0f" : "%g to %g",
                                     row->minimum, row->maximum);
            if (!strstr(error_get(), range))
                fail_msg("'%s' is not in: %s", range, error_get());
        }
        assert_false(setting_parse(&setting, &settings, "nan"));
        assert_false(setting_parse(&setting, &settings, ""));
    }
}

/* A preset goes before what is set beside it, whatever their order. */
TEST(preset_first) {
    static const char *const orders[][2] = {{"path=paper", "cosine=0"}, {"cosine=0", "path=paper"}};
    for (int i = 0; i < 2; i++) {
        struct settings settings;
        renderer_settings_init(&settings);
        check_ok("assign", renderer_settings_assign(&settings, technique_default, orders[i], 2));
        assert_true(settings_number(&settings, "blur.cosine") == 0);
        assert_true(settings_number(&settings, "clustered.visibility-block") == 0);
    }
}

TEST(failures) {
    expect_command(1, "render", "nowhere.glb -o a.png");
    expect_text("manylight render: cannot open nowhere.glb: No such file");
    expect_box(1, "--camera nobody -o a.png");
    expect_text("nobody");
    expect_box(1, "--light 0,lamp -o a.png");
    expect_text("no light 'lamp' (there is: 0=spot)");
    expect_box(1, "--light 7 -o a.png");
    expect_box(1, "-o /nowhere/at/all.png");
    expect_text("/nowhere/at/all.png");
    expect_box(1, "--glsl /nowhere -o %s", scratch("glsl.png"));
    expect_text("cannot open /nowhere/");
    assert_int_not_equal(access(scratch("glsl.png"), F_OK), 0);
    expect_box(1, "--technique unshadowed --aov val -o %s", scratch("aov.exr"));
    expect_text("aov: technique 'unshadowed' has no layer 'val' to add (there are vpl, gathered, ");
    expect_box(1, "--aov vpl,rsm-normal -o %s", scratch("aov.exr")); /* of the light's size */
    expect_text("aov: technique 'clustered' has no layer 'rsm-normal' to add (there are ");
    expect_box(1, "--aov vpl, -o %s", scratch("aov.exr"));
    expect_text("no layer '' to add");
}

/* When the second output cannot be written, nothing half-written lies beside it. */
TEST(nothing_half_written) {
    expect(0, "rm -rf @/whole && mkdir -p @/whole && chmod 555 @/whole");
    if (access(scratch("whole"), W_OK) != 0) /* root writes all the same */
        expect_box(1, "-o @/whole/a.exr");
    expect(0, "chmod 755 @/whole; mkdir @/whole/b.exr");
    expect_box(1, "-o @/whole/b.exr"); /* a folder of that name */
    expect(0, "ls @/whole");
    assert_string_equal(output, "b.exr\n");
}

/* A texture of the scene is no place for the picture, whether it is shown or not. */
TEST(own_texture) {
    unsigned char red[4] = {255, 0, 0, 255};
    struct file_bytes before, after;
    check_ok("texture", bitmap_write(&(struct bitmap){1, 1, red}, scratch("own.png")));
    check_ok("read", file_read(&before, scratch("own.png")));
    /* Named so, used or not, it is the scene's. */
    static const char *const names[] = {"own.png", "./own.png", "nowhere/../own.png", "%6fwn.png"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const char *images = form("\"images\": [{\"uri\": \"%s\"}],", names[i]);
        expect_command(1, "render",
                       form("%s --size 8x8 -o %s", write_parts("own.glb", &PARTS(.more = images)),
                            scratch("own.png")));
        expect_text("own.png: it is the input");
    }
    check_ok("read again", file_read(&after, scratch("own.png")));
    assert_int_equal(after.size, before.size);
    assert_memory_equal(after.data, before.data, after.size);
    mem_free(before.data, after.data);
}

/* --- files ------------------------------------------------------------------------------------ */

static struct image read_picture(const char *path) {
    struct image image;
    check_ok(path, image_read(&image, path));
    assert_int_equal(image.width, 40);
    assert_int_equal(image.height, 30);
    return image;
}

static float at(const struct image *image, const char *name, int x, int y) {
    int channel = image_find_channel(image, name);
    if (channel < 0)
        fail_msg("no channel %s", name);
    return image_at(image, x, y)[channel];
}

/* beauty = albedo x (direct + indirect), Z of what is seen, unit normals. */
static void check_layers(const struct image *image) {
    static const char rgb[] = "RGB";
    double worst_sum = 0, worst_normal = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            float length = 0;
            for (int c = 0; c < 3; c++) {
                char names[5][16];
                const char *layers[5] = {"", "albedo.", "direct.", "indirect.", "normal."};
                for (int l = 0; l < 5; l++)
                    snprintf(names[l], sizeof names[l], "%s%c", layers[l],
                             (l == 4 ? "XYZ" : rgb)[c]);
                float sum = at(image, names[1], x, y) *
                            (at(image, names[2], x, y) + at(image, names[3], x, y));
                worst_sum =
                    fmax(worst_sum, fabs((double)(at(image, names[0], x, y) / (sum + .01f) - 1)) -
                                        .01 / ((double)sum + .01));
                length += powf(at(image, names[4], x, y), 2);
            }
            if (at(image, "A", x, y) > 0)
                worst_normal = fmax(worst_normal, fabs((double)length - 1));
            assert_true((at(image, "Z", x, y) > 0) == (at(image, "A", x, y) > 0));
        }
    check_at_most("beauty over albedo (direct + indirect), in halves", worst_sum, 2e-3);
    check_at_most("normals' distance from unit", worst_normal, 4e-3);
}

static double mean_of(const struct image *image) {
    double sum = 0;
    for (int i = 0; i < 40 * 30; i++)
        sum += (double)at(image, "G", i % 40, i / 40) / (40 * 30);
    return sum;
}

/* One run, a file of each kind; they agree. */
TEST(files) {
    const char *exr = scratch("files.exr"), *png = scratch("files.png"),
               *jpeg = scratch(knows_format("jpg") ? "files.jpg" : "again.png"),
               *pfm = scratch("files.pfm"), *hdr = scratch("files.hdr");
    expect_box(0, "-q -o %s -o %s -o %s -o %s -o %s", exr, png, jpeg, pfm, hdr);
    assert_string_equal(output, "");
    OWNED(image) layers = read_picture(exr), display = read_picture(png),
                 lossy = read_picture(jpeg), plain = read_picture(pfm), rgbe = read_picture(hdr);
    assert_int_equal(layers.channel_count, 17);
    check_layers(&layers);
    assert_true(display.encoded && lossy.encoded);
    double worst_display = 0, worst_plain = 0, lossy_sum = 0;
    for (int i = 0; i < 40 * 30; i++) {
        double linear = fmin(1, fmax(0, (double)at(&layers, "G", i % 40, i / 40)));
        double srgb = linear <= .0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - .055;
        double shown = (double)at(&display, "G", i % 40, i / 40);
        worst_display = fmax(worst_display, fabs(shown - srgb));
        lossy_sum += fabs(shown - (double)at(&lossy, "G", i % 40, i / 40)) / (40 * 30);
        double half = (double)at(&layers, "G", i % 40, i / 40);
        worst_plain =
            fmax(worst_plain, fabs((double)at(&plain, "G", i % 40, i / 40) - half) / (half + 1e-3));
    }
    check_at_most("PNG less the EXR's radiance, encoded", worst_display, 1.1 / 255);
    check_at_most("JPEG less PNG, mean", lossy_sum, .03);
    check_at_most("PFM less EXR's half floats, relative", worst_plain, 1e-3);
    check_near("mean of HDR over that of EXR", mean_of(&rgbe) / mean_of(&layers), 1, .01);
}

TEST(exposure) {
    const char *plain = scratch("plain.exr"), *bright = scratch("bright.exr"),
               *dark_png = scratch("dark.png");
    expect_box(0, "-o %s", plain);
    expect_box(0, "--set exposure=3 -o %s", bright);
    expect_box(0, "--set exposure=-30 -o %s", dark_png);
    OWNED(image) a = read_picture(plain), b = read_picture(bright), c = read_picture(dark_png);
    assert_true(same_pixels(&a, &b)); /* radiance is radiance */
    for (int i = 0; i < 40 * 30; i++)
        assert_true(at(&c, "R", i % 40, i / 40) == 0);
}

TEST(stats) {
    expect_box(0, "--stats -o %s", scratch("stats.png"));
    static const char *const texts[] = {"faces  36",
                                        "VPLs   64, of which",
                                        "VALs   4, of which",
                                        "all GPU memory",
                                        "frame",
                                        "gbuffer",
                                        "clustering",
                                        "depth maps",
                                        "gather",
                                        "blur",
                                        "composite",
                                        " ms"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        expect_text(texts[i]);
    int lines = 0;
    for (const char *at = output; (at = strstr(at, " MiB\n")); at++)
        lines++;
    printf("    %d lines of GPU memory: the eight largest, the others, all\n", lines);
    assert_int_equal(lines, 10);
    expect_box(0, "--technique unshadowed --stats -o %s", scratch("stats.png"));
    assert_null(strstr(output, "VALs   4"));
    expect_box(0, "--technique cluster-lights --set area-lights=16 --stats -o %s",
               scratch("stats.png"));
    expect_text("area lights 16, of which 16 in use");
}

/* --glsl reads the very shaders that are embedded. */
/* -v tells how long the phases of the start took, once. */
TEST(phases) {
    static const char *const names[] = {"start: scene ",      " ms, OpenGL ",
                                        " ms, programs ",     " ms, simplify ",
                                        " ms, tree of rays ", " ms, first picture "};
    expect_box(0, "-v -o %s --frames 0,1", scratch("phases.#.png"));
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        expect_text(names[i]);
    assert_null(strstr(strstr(output, "start: ") + 1, "start: "));
    assert_null(strstr(output, "OpenGL 0 ms"));
    expect_box(0, "-o %s", scratch("phases.png"));
    assert_null(strstr(output, "start: "));
}

/* On a terminal, which script makes. */
TEST(passes_progress) {
    need_command("script -qec true /dev/null");
    expect(0, "script -qec '% render scenes/moving-spot.glb --size 64x48 --frames 2,5 --passes 4 "
              "-o @/passes-#.exr' /dev/null");
    expect_text(" left  frame 2, pass ");
    expect_text("of 4\033[K");
    expect_text("2 frames in ");
}

/* Higher or wider than half of what textures may be, which lists of pixels take twice. */
TEST(strips) {
    static const char *const sizes[] = {"8x9000", "9000x8", "7x8193"};
    for (int i = 0; i < 3; i++) {
        if (!is_tried_here((size_t)i, 2))
            continue;
        expect_command(
            0, "render",
            form("scenes/moving-spot.glb --size %s -o %s", sizes[i], scratch("strip.png")));
    }
}

TEST(shader_folder) {
    const char *embedded = scratch("embedded.exr"), *folder = scratch("folder.exr");
    if (access("src/passes/gather/gather.frag", R_OK) != 0)
        skip();
    expect_box(0, "-o %s", embedded);
    expect_box(0, "--glsl glsl -o %s", folder);
    OWNED(image) a = read_picture(embedded), b = read_picture(folder);
    assert_true(same_pixels(&a, &b));
}

/* --- outputs as layers ------------------------------------------------------------------------ */

TEST(aov) {
    const char *with = scratch("with.exr"), *without = scratch("without.exr");
    expect_box(0, "--aov vpl,visibility,gathered,val,vpl,irradiance -o %s", with);
    expect_box(0, "-o %s", without);
    OWNED(image) a = read_picture(with), b = read_picture(without);
    assert_int_equal(a.channel_count, b.channel_count + 13);
    for (int i = 0; i < 40 * 30; i++) {
        int x = i % 40, y = i / 40;
        float share = at(&a, "visibility.Y", x, y);
        assert_true(share >= 0 && share <= 1);
        assert_true(at(&a, "val.G", x, y) >= 0 && at(&a, "val.G", x, y) <= 1);
        assert_true(at(&a, "vpl.B", x, y) >= 0);
        assert_true(at(&a, "irradiance.G", x, y) == at(&a, "indirect.G", x, y));
        assert_true(at(&a, "R", x, y) == at(&b, "R", x, y));
        assert_true(at(&a, "indirect.R", x, y) == at(&b, "indirect.R", x, y));
    }
}

static struct image append_layers(const struct stage *stage, const char *technique,
                                  const char *settings, const char *names,
                                  struct renderer *renderer) {
    struct renderer_desc desc = desc_of(stage, technique, settings, 64, 64);
    struct image image;
    open_renderer(renderer, desc);
    check_ok("layers", renderer_read_layers(renderer, &image));
    check_ok("more layers", aov_append(renderer, names, NULL, &image));
    return image;
}

/* Without interleaving and blur what is gathered is the indirect layer. */
TEST(gathered) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    OWNED(image) image = append_layers(&stage, "unshadowed", "vpls=256 interleave=4 blur-radius=0",
                                       "gathered", &renderer);
    double worst = 0;
    for (int i = 0; i < 64 * 64; i++)
        worst = fmax(worst, fabs((double)at(&image, "gathered.G", i % 64, i / 64) -
                                 (double)at(&image, "indirect.G", i % 64, i / 64)));
    check_at_most("gathered less indirect, worst pixel", worst, 0);
}

/* With a VAL for each VPL the share is the clustered light over the unshadowed. */
TEST(visibility_share) {
    const char *settings =
        "vpls=64 vals=64 interleave=1 clamp=disk visibility=hard visibility-block=0 map-size=128";
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    OWNED(image) image = append_layers(&stage, "clustered", settings, "visibility", &renderer);
    OWNED(image) open = render_stage(&stage, "unshadowed", settings, 64);
    double sum = 0, difference = 0;
    for (int i = 0; i < 64 * 64; i++) {
        double most = 0, arrives = 0;
        for (int c = 0; c < 3; c++) {
            static const char *const names[] = {"indirect.R", "indirect.G", "indirect.B"};
            most += (double)at(&open, names[c], i % 64, i / 64);
            arrives += (double)at(&image, names[c], i % 64, i / 64);
        }
        if (most <= 0)
            continue;
        sum++;
        difference += fabs(arrives / most - (double)at(&image, "visibility.Y", i % 64, i / 64));
    }
    /* VPLs have an area, VALs of one VPL none: next to a VPL the weights differ. */
    check_at_most("share less light over unshadowed light, mean", difference / sum, .02);
}

/* Area lights of clusters have a layer of their own: no more of them than there are, and nearly all
 * their light. */
TEST(light_layer) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct image image =
        append_layers(&stage, "cluster-lights", "vpls=1024 area-lights=64 vals=8 map-size=32",
                      "light,vpl", &renderer);
    int lights = 0, vpls = 0;
    double of_lights = 0, of_vpls = 0;
    for (int i = 0; i < 64 * 64; i++) {
        double light = (double)at(&image, "light.R", i % 64, i / 64);
        double vpl = (double)at(&image, "vpl.R", i % 64, i / 64);
        lights += light > 0;
        vpls += vpl > 0;
        of_lights += light;
        of_vpls += vpl;
    }
    printf("    seen: %d lights of %.4g W, VPLs in %d pixels of %.4g W\n", lights, of_lights, vpls,
           of_vpls);
    assert_true(lights > 8 && lights <= 64 && vpls > 64);
    check_near("light that is seen", of_lights, of_vpls, .2 * of_vpls);
    image_free(&image);
}

/* No more flux in the picture than there is, and those VPLs that the camera sees. */
TEST(vpl_layer) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct image image =
        append_layers(&stage, "clustered", "vpls=1024 vals=8 map-size=32", "vpl", &renderer);
    struct vpl *vpls = read_vpls(&renderer);
    double all = 0, seen = 0;
    for (int i = 0; i < 1024; i++)
        all += (double)vpls[i].flux[0];
    for (int i = 0; i < 64 * 64; i++)
        seen += (double)at(&image, "vpl.R", i % 64, i / 64);
    printf("    seen %.4g of %.4g W\n", seen, all);
    assert_true(seen <= all * 1.001 && seen > .1 * all);
    free(vpls);
    image_free(&image);
}

RUN_TESTS(open_group_context, close_group_context)
