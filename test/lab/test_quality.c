/* How good a picture has to be: errors estimated from some of its pixels, and what is chosen by
 * them. */
#define _POSIX_C_SOURCE 200809L
#include "command_support.h"
#include "render_support.h"

#include "lab/measure/reference.h"
#include "metrics/layer.h"
#include "metrics/metric.h"
#include "quality/estimate.h"
#include "quality/quality.h"

enum { SIDE = 96 };

struct open_box {
    struct context *context;
    struct stage stage;
    struct measure_desc measure;
};

static int open_box(void **state) {
    static struct open_box box;
    box.context = open_context(CONTEXT_AUTO);
    box.stage = open_stage("scenes/cornell-box.glb");
    box.measure = measure_default(&box.stage, SIDE / 2, SIDE / 2);
    *state = &box;
    return 0;
}

static int close_box(void **state) {
    struct open_box *box = *state;
    stage_free(&box->stage);
    context_free(box->context);
    return 0;
}

static struct image trace(const struct open_box *box, int every, int samples) {
    return TRACE(&box->stage, .width = SIDE, .height = SIDE, .every = every, .bounces = 1,
                 .samples = samples);
}

/* Each pixel lies in its square, and all places of a square are taken. */
TEST(places) {
    enum { EVERY = 3, SQUARES = 60 };
    int counts[EVERY * EVERY] = {0};
    for (int y = 0; y < SQUARES; y++)
        for (int x = 0; x < SQUARES; x++) {
            struct pixel pixel = path_tracer_pixel(EVERY, x, y);
            int dx = pixel.x - x * EVERY, dy = pixel.y - y * EVERY;
            assert_true(dx >= 0 && dx <= EVERY - 1);
            assert_true(dy >= 0 && dy <= EVERY - 1);
            counts[dy * EVERY + dx]++;
        }
    for (int i = 0; i < EVERY * EVERY; i++) /* 3600 / 9, and a spread of 19 */
        check_near("a place's share of the squares", counts[i], 400, 80);
    struct pixel same = path_tracer_pixel(1, 5, 7);
    assert_int_equal(same.x, 5);
    assert_int_equal(same.y, 7);
}

/* Some of the pixels are those of the whole picture, within the noise of both. */
TEST(some_pixels) {
    enum { EVERY = 4, SAMPLES = 64 };
    OWNED(image) all = trace(*state, 1, SAMPLES), some = trace(*state, EVERY, SAMPLES);
    int layer[3];
    assert_int_equal(some.width, SIDE / EVERY);
    assert_true(image_find_layer(&all, "indirect", layer));
    double difference = 0, sum = 0;
    for (int y = 0; y < some.height; y++)
        for (int x = 0; x < some.width; x++) {
            struct pixel at = path_tracer_pixel(EVERY, x, y);
            for (int c = 0; c < 3; c++) {
                double a = (double)image_at(&all, at.x, at.y)[layer[c]];
                double b = (double)image_at(&some, x, y)[layer[c]];
                difference += (a - b) * (a - b);
                sum += a;
            }
        }
    double values = 3.0 * some.width * some.height;
    check_at_most("some pixels, relative RMSE", sqrt(difference / values) / (sum / values),
                  2 * (reference_noise(&all) + reference_noise(&some)));
}

/* Of all pixels, slivers at silhouettes as far as they are covered. */
static double error_of(const struct image *picture, const struct image *reference) {
    struct image layers[2];
    struct comparison comparison = {.test = &layers[0], .reference = &layers[1]};
    check_ok("layer", layer_extract_covered(&layers[0], picture, "indirect", reference));
    check_ok("layer", layer_extract_covered(&layers[1], reference, "indirect", reference));
    double error = metric_measure(metric_find("relative-rmse"), &comparison, NULL);
    double noise = reference_noise(reference);
    images_free(&layers[0], &layers[1]);
    return sqrt(error * error - noise * noise);
}

/* The error that some pixels tell is that of all of them. */
TEST(estimate) {
    struct open_box *box = *state;
    struct measure_desc measure = box->measure;
    struct estimate estimate;
    OWNED(renderer) renderer;
    OWNED(image) picture, reference;
    measure.width = measure.height = 2 * SIDE; /* of which a quarter of the pixels is traced */
    double error, first;
    check_ok("estimate", estimate_init(&estimate, &measure, "indirect"));
    assert_int_equal(estimate.every, 2);
    check_ok("renderer", measure_start(&renderer, &measure));
    renderer_render(&renderer);
    check_ok("error", estimate_error(&estimate, &renderer, 1, &first));
    int few = estimate.samples; /* tell that it is not 100 %, and to a twentieth */
    check_ok("error", estimate_error(&estimate, &renderer, first, &error));
    check_at_most("samples where that does not decide", few, estimate.samples / 2.0);
    reference = TRACE(&box->stage, .width = 2 * SIDE, .height = 2 * SIDE, .bounces = 1,
                      .samples = is_long_run() ? 128 : 32);
    check_ok("layers", renderer_read_layers(&renderer, &picture));
    double all = error_of(&picture, &reference);
    check_near("of a quarter of the pixels", error, all, .15 * all);
    check_near("by few paths", first, error, .1 * error);
    estimate_free(&estimate);
}

/* At silhouettes against nothing, the more samples a reference has, the more slivers it knows. The
 * estimate depends on neither. */
TEST(slivers) {
    OWNED(stage) stage = open_stage("scenes/failures/room.glb");
    OWNED(renderer) renderer;
    struct estimate estimate;
    struct image picture, references[2];
    double estimated, errors[2];
    struct measure_desc measure = measure_default(&stage, SIDE / 2, SIDE / 2);
    check_ok("renderer", measure_start(&renderer, &measure));
    renderer_render(&renderer);
    check_ok("layers", renderer_read_layers(&renderer, &picture));
    for (int i = 0; i < 2; i++) {
        references[i] = TRACE(&stage, .width = SIDE / 2, .height = SIDE / 2, .bounces = 1,
                              .samples = i ? 512 : 32);
        errors[i] = error_of(&picture, &references[i]);
    }
    check_near("by many samples", errors[1], errors[0], .05 * errors[0]);
    check_ok("estimate", estimate_init(&estimate, &measure, "indirect"));
    check_ok("error", estimate_picture_error(&estimate, &picture, errors[1], &estimated));
    check_near("estimated", estimated, errors[1], .1 * errors[1]);
    estimate_free(&estimate);
    /* Of the whole picture, slivers and all. */
    double whole = relative_rmse(&picture, &references[1], "");
    check_ok("estimate", estimate_init(&estimate, &measure, ""));
    check_ok("error", estimate_picture_error(&estimate, &picture, whole, &estimated));
    check_near("estimated of all light", estimated, whole, .1 * whole);
    for (int i = 0; i < 2; i++)
        image_free(&references[i]);
    image_free(&picture);
    estimate_free(&estimate);
}

static struct quality_found find(const struct open_box *box, const char *text, double error,
                                 int most_passes) {
    struct quality_found found;
    struct quality_desc desc = {&box->measure, &text, 1, error, most_passes, false, false};
    check_ok("find", quality_find(&desc, &found));
    char *what = quality_describe(&found.choice);
    printf("    %g %% asked for: %s, %.2f %%\n", 100 * error, what, 100 * found.error);
    free(what);
    return found;
}

/* --- the ladder, by errors that are made up --- */

struct made_up {
    double errors[QUALITY_CHOICES_MAX];
    int asked; /* for so many of them */
};

static bool tell_made_up(void *user, const struct quality_choice *choice, double *error) {
    struct made_up *made_up = user;
    (void)choice;
    *error = made_up->errors[made_up->asked++];
    return true;
}

/* What is asked for is the first that reaches it; what cannot be had is no better for
 * taking long. */
TEST(climb) {
    static const struct {
        const char *name;
        double asked, frames[5],
            passes[3]; /* errors: of all later frames the last; of 4, 8 and 16 passes */
        int tried_frames, tried_passes; /* 0 frames: all */
        int frame, passes_chosen;       /* what is chosen: of a frame the place on the ladder */
        bool reached;
    } cases[] = {
        {"the first", .3, {.25}, {0}, 1, 0, 0, 1, true},
        {"one that cannot be made", .1, {.2, INFINITY, .09}, {0}, 3, 0, 2, 1, true},
        {"passes", .05, {.3, .3, .2}, {.1, .04}, 0, 2, 0, 8, true},
        {"no gain from passes", .05, {.3, .3, .2, .11, .2}, {.105, .1}, 0, 2, 3, 1, false},
        {"the best", .01, {.3}, {.2, .1, .08}, 0, 3, 0, 16, false},
        {"none can be made", .1, {INFINITY}, {INFINITY, INFINITY, INFINITY}, 0, 3, 0, 1, false},
    };
    struct quality_choice choices[QUALITY_CHOICES_MAX];
    int frames = quality_ladder(choices, 1);
    assert_int_equal(quality_ladder(choices, 16), frames + 3);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct made_up made_up = {.asked = 0};
        struct quality_found found;
        for (int k = 0, last = 0; k < frames; k++) {
            last = k < 5 && cases[i].frames[k] > 0 ? k : last;
            made_up.errors[k] = cases[i].frames[last];
        }
        memcpy(&made_up.errors[frames], cases[i].passes, sizeof cases[i].passes);
        assert_true(quality_climb(cases[i].asked, 16, tell_made_up, &made_up, &found));
        printf("    %s: %d tried, %d passes of '%s'\n", cases[i].name, made_up.asked,
               found.choice.passes, found.choice.settings);
        assert_int_equal(made_up.asked, (cases[i].tried_frames ? cases[i].tried_frames : frames) +
                                            cases[i].tried_passes);
        assert_int_equal(found.choice.passes, cases[i].passes_chosen);
        if (found.choice.passes == 1)
            assert_string_equal(found.choice.settings, choices[cases[i].frame].settings);
        assert_int_equal(found.reached, cases[i].reached);
    }
}

/* A rung that cannot be made would be passed over in silence. */
TEST(rungs) {
    struct quality_choice choices[QUALITY_CHOICES_MAX];
    int count = quality_ladder(choices, QUALITY_MOST_PASSES);
    check_at_most("rungs", count, QUALITY_CHOICES_MAX);
    for (int i = 0; i < count; i++) {
        struct settings settings;
        const struct technique *technique = quality_technique(&choices[i], technique_default);
        check_ok(choices[i].settings, quality_settings(&choices[i], technique, NULL, 0, &settings));
    }
}

/* --- the ladder, drawn --- */

/* The less it may err, the dearer it gets, and what does not go says so. */
TEST(ladder) {
    const char *small = "vpls=256 vals=8 map.size=64";
    struct quality_found draft = find(*state, small, .5, 1), none = find(*state, small, .03, 1);
    assert_string_equal(draft.choice.settings, "path=draft");
    assert_true(draft.reached);
    assert_false(none.reached);
    assert_ptr_equal(quality_technique(&none.choice, technique_default), technique_default);
    check_at_most("the best there is", none.error, draft.error);
    struct quality_found passes = find(*state, small, .8 * none.error, 8);
    assert_true(passes.choice.passes >= 4 && passes.choice.passes <= 8);
    check_at_most("passes", passes.error, none.error);
}

/* Where light comes from a bright corner, another technique is cheaper; it is taken unless one is
 * named. */
TEST(techniques) {
    OWNED(stage) stage = open_stage("scenes/failures/corner.glb");
    struct measure_desc measure = measure_default(&stage, SIDE, SIDE);
    for (int any = is_long_run() ? 0 : 1; any < 2; any++) {
        struct quality_found found;
        check_ok("find", quality_find(&(struct quality_desc){&measure, NULL, 0, .16, 1, any, false},
                                      &found));
        char *what = quality_describe(&found.choice);
        printf("    %s: %s, %.1f %%\n", any ? "any" : "the default alone", what, 100 * found.error);
        free(what);
        assert_string_equal(quality_technique(&found.choice, technique_default)->name,
                            any ? "cluster-lights" : technique_default->name);
        assert_true(!any || found.reached);
    }
}

/* What is given wins, and a preset that is given is the only one. */
TEST(given) {
    struct open_box *box = *state;
    struct settings settings;
    const char *vals = "vals=5", *path = "path=traced";
    struct quality_choice draft = quality_named(QUALITY_DRAFT);
    check_ok("settings", quality_settings(&draft, technique_default, &vals, 1, &settings));
    assert_int_equal((int)settings_number(&settings, "vals"), 5);
    assert_int_equal((int)settings_number(&settings, "vpls"), 256);
    check_ok("settings", quality_settings(&draft, technique_default, &path, 1, &settings));
    assert_int_equal((int)settings_number(&settings, "vpls"), 1024);
    assert_string_equal(find(box, "path=fast vals=4 map.size=64 vpls=256", .5, 1).choice.settings,
                        "");
    check_refused(quality_settings(&draft, technique_find("unshadowed"), &vals, 1, &settings), "");
}

/* The words, in a shell. */
TEST(words) {
    static const struct {
        const char *arguments;
        int status;
        const char *says;
    } cases[] = {
        {"--quality draft --max-error 5%", 2, "--quality and --max-error exclude each other"},
        {"--quality better", 2, "quality: 'better' is not one of draft, normal, high, final"},
        {"--max-error 200%", 2, "max-error"},
        {"--quality draft --stats", 0, "needs gather.adaptive>0"},
        {"--max-error 90% --set vpls=64,vals=4", 0, "cornell-box: path=draft, which errs"},
        {"--max-error 2% --passes 1 --set vpls=64,vals=4,adaptive=0", 0, "nothing errs much less"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        expect_command(cases[i].status, "render scenes/cornell-box.glb -o @/q.png --size 40x40",
                       cases[i].arguments);
        expect_text(cases[i].says);
    }
}

/* A layer of light of a path-traced picture has the background where nothing is seen. */
TEST(traced_background) {
    if (!gl.software)
        skip();
    OWNED(image) seen;
    expect(0, "% render scenes/cornell-box.glb -o @/seen.png --size 24x24 -q --budget 600000ms "
              "--layer indirect --camera '0 fov=2.2' --background '#ff0000'");
    check_ok("picture", image_read(&seen, scratch("seen.png")));
    const float *corner = image_at(&seen, 0, 0);
    check_near("red", (double)corner[0], 1, 1e-6);
    check_near("green and blue", (double)(corner[1] + corner[2]), 0, 1e-6);
}

/* A path-traced picture is `reference`'s, in each format; what speaks of frames keeps them. */
TEST(traced) {
#define SMALL_BOX "scenes/cornell-box.glb --size 40x40 "
    if (!gl.software)
        skip();
    expect(0, "% render " SMALL_BOX "-o @/traced.exr -o @/traced.png --budget 600000ms --stats "
              "--set seed=5");
    expect_text("chosen by --budget 600000ms: 256 path-traced samples, denoised");
    expect(0, "% reference " SMALL_BOX "-o @/reference.exr --spp 256 --denoise --seed 1073741829");
    expect(0, "% compare @/traced.exr @/reference.exr -l beauty -m mae --max mae=0");
    expect(0, "% compare @/traced.exr @/reference.exr -l indirect -m mae --max mae=0");
    expect(0, "% compare @/traced.png @/traced.exr -m ldr-flip --max ldr-flip=.008");
    for (const char *const *kept =
             (const char *const[]){"--frames 0", "--set vals=8", "--technique clustered", NULL};
         *kept; kept++) {
        expect_command(0, "render " SMALL_BOX "-o @/traced.png --budget 600000ms --stats", *kept);
        expect_text("chosen by --budget 600000ms: level ");
    }
}

RUN_TESTS(open_box, close_box)
