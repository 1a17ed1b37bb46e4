/* Pictures of several passes: what they are made of, that they converge, and that they may be
 * split. */
#include "command_support.h"
#include "render_support.h"

#include "gl/pass.h"
#include "quality/picture.h"
#include "reference/path_tracer.h"

enum { SIZE = 48 };

static const char *const box = "scenes/cornell-box.glb";

/* The worst difference of a layer, over its mean. */
static double worst_difference(const struct image *a, const struct image *b, const char *layer) {
    int channels[3];
    double worst = 0;
    assert_true(image_find_layer(a, layer, channels));
    for (int i = 0; i < a->width * a->height; i++)
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs((double)(a->pixels[i * a->channel_count + channels[c]] -
                                              b->pixels[i * b->channel_count + channels[c]])));
    return worst / image_mean(b, channels);
}

static void check_alike(const struct image *a, const struct image *b, double bound) {
    static const char *const layers[] = {"beauty", "direct", "indirect", "albedo"};
    for (size_t i = 0; i < sizeof layers / sizeof *layers; i++)
        check_at_most(layers[i], worst_difference(a, b, layers[i]), bound);
}

/* --- the mean --------------------------------------------------------------------------------- */

/* The first pass is the frame; the next are others, and the same each time. */
TEST(passes) {
    OWNED(stage) stage = open_stage(box);
    struct renderer_desc desc = desc_of(&stage, NULL, "vpls=256 vals=8 samples=8", SIZE, SIZE);
    struct image frame = render_layers(&desc), first = render_mean(&desc, 0, 1);
    struct image second = render_mean(&desc, 1, 1), third = render_mean(&desc, 2, 1);
    struct image again = render_mean(&desc, 2, 1);
    check_alike(&first, &frame, 1e-4); /* of a frame, light at edges is a quotient of sums */
    assert_true(worst_difference(&second, &frame, "indirect") > .05);
    assert_true(worst_difference(&second, &third, "indirect") > .05);
    assert_true(same_pixels(&third, &again));
    struct image *all[] = {&frame, &first, &second, &third, &again};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        image_free(all[i]);
}

static void check_mean(const char *what, struct renderer *renderer, const struct image *expected) {
    OWNED(image) image;
    check_ok("layers", renderer_read_layers(renderer, &image));
    printf("    %s: indirect differs by %g\n", what,
           worst_difference(&image, expected, "indirect"));
    assert_true(same_pixels(expected, &image));
}

/* Renders a pass, changes the renderer, and says whether the mean is kept. */
static bool keeps(struct renderer *renderer, const struct renderer_desc *changed) {
    renderer_add_pass(renderer, 5);
    assert_int_equal(renderer_pass_count(renderer), 1);
    check_ok("change", renderer_follow(renderer, changed));
    return renderer_pass_count(renderer) == 1;
}

/* What changes a picture begins another mean; exposure does not. Passes depend on their number
 * alone: not on those before, nor on the picture before that. */
TEST(beginning_anew) {
    OWNED(stage) stage = open_stage("scenes/moving-spot.glb");
    struct renderer_desc desc =
        desc_of(&stage, NULL, "vpls=128 vals=8 map-size=64 shadow-size=256", SIZE, SIZE);
    desc.progressive = desc.keep_lights = true;
    OWNED(image) fresh = render_mean(&desc, 0, 3);
    OWNED(renderer) renderer;
    check_ok("renderer", renderer_init(&renderer, &desc));
    for (int i = 0; i < 3; i++)
        renderer_add_pass(&renderer, i);
    check_mean("the mean", &renderer, &fresh);
    struct renderer_desc changed = renderer.desc;
    assert_true(keeps(&renderer, &changed));
    check_ok("settings", settings_assign(&changed.settings, "exposure=1"));
    assert_true(keeps(&renderer, &changed));
    check_ok("settings", settings_assign(&changed.settings, "vals=4"));
    assert_false(keeps(&renderer, &changed));
    changed.camera.eye[0] += .1F;
    assert_false(keeps(&renderer, &changed));
    changed.width /= 2;
    assert_false(keeps(&renderer, &changed));
    renderer_add_pass(&renderer, 5);
    check_ok("pose", stage_pose(&stage, .5) && stage_show(&stage, &renderer));
    assert_int_equal(renderer_pass_count(&renderer), 0);

    renderer_add_pass(&renderer, 5);
    check_ok("back", stage_pose(&stage, 0) && stage_show(&stage, &renderer));
    desc.emitters = stage.emitters;
    check_ok("back", renderer_follow(&renderer, &desc));
    for (int i = 0; i < 3; i++)
        renderer_add_pass(&renderer, i);
    check_mean("back again", &renderer, &fresh);
    for (int i = 0; i < 3; i++) /* of the same picture once more */
        renderer_add_pass(&renderer, i);
    check_mean("once more", &renderer, &fresh);
}

/* --- where it goes ---------------------------------------------------------------------------- */

static struct image trace(const struct stage *stage, double noise) {
    struct path_tracer_progress reached;
    struct image reference;
    check_ok("tracer",
             picture_trace_paths(stage,
                                 &(struct path_tracer_desc){
                                     .width = SIZE, .height = SIZE, .bounces = 1, .noise = noise},
                                 &reference, &reached));
    return reference;
}

/* RMS of the difference of the indirect layers over the mean, where the layers beside
 * them differ. */
static double error(const struct image *test, const struct image *reference) {
    int a[3], b[3];
    double sum = 0;
    assert_true(image_find_layer(test, "indirect", a) &&
                image_find_layer(reference, "indirect", b));
    for (int i = 0; i < SIZE * SIZE; i++)
        for (int c = 0; c < 3; c++)
            sum += pow((double)(image_at(test, i % SIZE, i / SIZE)[a[c]] -
                                image_at(reference, i % SIZE, i / SIZE)[b[c]]),
                       2);
    return sqrt(sum / (3. * SIZE * SIZE)) / image_mean(reference, b);
}

static double bias(const struct image *test, const struct image *reference) {
    return layer_mean(test, "indirect") / layer_mean(reference, "indirect") - 1;
}

/* The mean of few passes and of four times as many, by one renderer. */
static void render_means(const struct renderer_desc *desc, int few, struct image means[2]) {
    OWNED(renderer) renderer;
    struct renderer_desc progressive = *desc;
    progressive.progressive = true;
    check_ok("renderer", renderer_init(&renderer, &progressive));
    for (int i = 0; i < 4 * few; i++) {
        renderer_add_pass(&renderer, i);
        if (i + 1 == few)
            check_ok("layers", renderer_read_layers(&renderer, &means[0]));
    }
    check_ok("layers", renderer_read_layers(&renderer, &means[1]));
}

/* Towards the path tracer's picture: both are the mean over pixels' areas. */
TEST(convergence) {
    static const char *const scenes[] = {"scenes/cornell-box.glb", "scenes/metaballs.glb"};
    enum { FEW = 8 };
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        if (!is_tried_here(i, 2))
            continue;
        OWNED(stage) stage = open_stage(scenes[i]);
        struct renderer_desc desc = desc_of(&stage, NULL, "samples=8", SIZE, SIZE);
        struct image reference = trace(&stage, is_long_run() ? .006 : .015),
                     frame = render_layers(&desc);
        struct image means[2];
        render_means(&desc, FEW, means);
        double first = error(&frame, &reference);
        double after_few = error(&means[0], &reference);
        double after_many = error(&means[1], &reference);
        printf("    %s: error %.4f, of %d passes %.4f, of %d %.4f\n", scenes[i], first, FEW,
               after_few, 4 * FEW, after_many);
        check_at_most("8 passes over one", after_few / first, .8);
        check_at_most("32 passes over one", after_many / first, .4);
        check_at_most("32 passes over 8", after_many / after_few, .7); /* K^-.26 */
        check_near("bias of 32", bias(&means[1], &reference), 0, .01);
        struct image *all[] = {&reference, &frame, &means[0], &means[1]};
        for (size_t k = 0; k < sizeof all / sizeof *all; k++)
            image_free(all[k]);
    }
}

/* --- split ------------------------------------------------------------------------------------ */

static void read_scratch(struct image *image, const char *name) {
    check_ok(name, image_read(image, scratch(name)));
}

/* 4 + 4 passes, averaged, are 8 but for the rounding of sums; so are 2 + 6 in other order. */
TEST(split) {
#define RENDER                                                                                     \
    "render scenes/cornell-box.glb -q --size 48x40 --set \"vpls=256 vals=8 "                       \
    "map-size=64 rsm-size=128 shadow-size=256\" "
    static const char *const commands[] = {
        RENDER "--passes 8 -o @/whole.exr",
        RENDER "--passes 4 -o @/a.exr",
        RENDER "--passes 4 --first-pass 4 -o @/b.exr",
        RENDER "--passes 2 --first-pass 6 -o @/c.exr",
        RENDER "--passes 2 --first-pass 4 -o @/d.exr",
        "average @/a.exr @/b.exr -o @/ab.exr",
        "average @/c.exr @/a.exr @/d.exr -o @/cad.exr",
        "average @/c.exr @/a.exr -o @/ca.exr",
        "average @/d.exr @/ca.exr -o @/dca.exr",
    };
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        expect_command(0, commands[i], "");
    struct image whole, part;
    read_scratch(&whole, "whole.exr");
    assert_string_equal(whole.passes, "0..7");
    static const char *const parts[] = {"ab.exr", "cad.exr", "dca.exr"};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        read_scratch(&part, parts[i]);
        check_alike(&part, &whole, 1e-5); /* of the mean: some pixels are ten times as bright */
        assert_string_equal(part.passes, "0..7");
        check_near("weight", part.weight, whole.weight, 1e-6);
        image_free(&part);
    }
    read_scratch(&part, "ca.exr");
    assert_string_equal(part.passes, "0..3,6..7");
    images_free(&part, &whole);
}

/* The mean of two pixels, of albedo .2 and .6: light that the albedo multiplies is weighted by it,
 * other light is not. Facts of the first picture stay. The least weight of 1e-6 is the tolerance.
 */
TEST(layers_of_average) {
    static const char *const names[] = {"direct.R", "caustic.R", "direct.specular.R",
                                        "indirect.specular.R"};
    static const double expected[] = {2.5, 2.5, 2, 2};
    const float matrix[16] = {1, 2, 3, [15] = 4};
    for (int i = 0; i < 2; i++) {
        OWNED(image) image;
        image_init(&image, 1, 1,
                   "A albedo.R direct.R caustic.R direct.specular.R indirect.specular.R");
        const float light = i == 0 ? 1 : 3;
        memcpy(image.pixels, (float[]){1, i == 0 ? .2F : .6F, light, light, light, light},
               6 * sizeof(float));
        image.passes = mem_strdup(i == 0 ? "0" : "1");
        image.weight = 1;
        image_add_text(&image, "cryptomatte/aaf0e57/name", "crypto_node");
        image_add_numbers(&image, "manylight:time", IMAGE_NUMBER, &(float){.5F});
        image_add_numbers(&image, "worldToNDC", IMAGE_MATRIX, matrix);
        check_ok("write", image_write(&image, scratch(i == 0 ? "l0.exr" : "l1.exr")));
    }
    expect(0, "% average @/l0.exr @/l1.exr -o @/l.exr");
    OWNED(image) mean;
    read_scratch(&mean, "l.exr");
    for (int i = 0; i < 4; i++)
        check_near(names[i], (double)mean.pixels[image_find_channel(&mean, names[i])], expected[i],
                   1e-5);
    assert_int_equal(mean.attribute_count, 3);
    assert_string_equal(mean.attributes[0].text, "crypto_node");
    check_near("time", (double)mean.attributes[1].numbers[0], .5, 0);
    assert_memory_equal(mean.attributes[2].numbers, matrix, sizeof matrix);
}

/* The frame alone is a part, too, of its own weight: 1 + 7 passes are 8. */
TEST(one_pass) {
    OWNED(image) whole, part;
    static const char *const commands[] = {
        RENDER "--passes 1 --first-pass 0 -o @/one.exr",
        RENDER "--passes 7 --first-pass 1 -o @/seven.exr",
        "average @/one.exr @/seven.exr -o @/eight.exr",
    };
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        expect_command(0, commands[i], "");
    read_scratch(&whole, "whole.exr");
    read_scratch(&part, "eight.exr");
    check_alike(&part, &whole, 1e-5);
    assert_string_equal(part.passes, "0..7");
    check_near("weight", part.weight, whole.weight, 1e-6);
}

/* What is set by the user holds for all passes, where they have settings of their own, too; what a
 * preset sets does not, nor what nobody set. */
TEST(given) {
    static const struct {
        const char *given;
        bool differs;
    } rows[] = {{"vpls=64", false}, {"vpls=128", true}, {"path=draft", false}};
    OWNED(stage) stage = open_stage(box);
    struct renderer_desc plain = desc_of(&stage, NULL, "samples=8", SIZE, SIZE);
    OWNED(image) second = render_mean(&plain, 1, 1);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct renderer_desc desc = desc_of(&stage, NULL, rows[i].given, SIZE, SIZE);
        OWNED(image) other = render_mean(&desc, 1, 1);
        double worst = worst_difference(&other, &second, "indirect");
        printf("    second pass with %s: differs by %g\n", rows[i].given, worst);
        assert_true(rows[i].differs == (worst > 0));
    }
}

/* What cannot be averaged, and what cannot be a mean. */
TEST(refusals) {
    static const char *const wrong[][2] = {
        {"average", "arguments are missing"},
        {"average @/a.exr", "no output"},
        {"average @/a.exr -o x.png", "only EXR"},
        {RENDER "--passes 2 --aov val -o @/x.exr", "aov"},
        {RENDER "--passes -1 -o @/x.exr", "passes"},
        {NULL},
    };
    static const char *const failures[][2] = {
        {"average @/a.exr @/a.exr -o @/x.exr", "pass 0 is in it and in one before"},
        {"average @/whole.exr @/b.exr -o @/x.exr", "pass 4"},
        {"average @/a.exr @/b.exr -o @/b.exr", "b.exr"},
        {"average @/a.exr @/plain.exr -o @/x.exr", "does not tell its passes"},
        {"average @/a.exr @/small.exr -o @/x.exr", "pixels"},
        {NULL},
    };
    expect(0, "% " RENDER "-o @/plain.exr");
    expect(0, "% render scenes/cornell-box.glb -q --size 8x8 --first-pass 9 -o @/small.exr");
    expect(0, "% average --help");
    expect_text("weight");
    expect_refusals(2, "", wrong);
    expect_refusals(1, "", failures);
    struct image none;
    assert_false(image_read(&none, scratch("x.exr")));
}

RUN_TESTS(open_group_context, close_group_context)
