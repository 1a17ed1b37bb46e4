/* The floor that measures, called as a library: what it reads from renderers, and what
 * it refuses. */
#include "render_support.h"

#include "lab/measure/clip.h"
#include "lab/measure/baseline.h"
#include "lab/measure/reference.h"
#include "lab/measure/variants.h"
#include "inspect/aov.h"
#include "inspect/lights.h"

static const char small[] = "vpls=64 vals=6 map-size=32 rsm-size=64 shadow-size=128 interleave=1";

/* --- figures ---------------------------------------------------------------------------------- */

TEST(summary) {
    float values[101];
    for (int i = 0; i < 101; i++)
        values[i] = (float)((i * 37) % 101); /* 0 to 100, shuffled */
    struct summary summary = summary_of(values, 101);
    assert_int_equal(summary.count, 101);
    check_near("median", summary.value, 50, 0);
    check_near("p5", summary.p5, 5, 0);
    check_near("p95", summary.p95, 95, 0);
    check_near("minimum", summary.minimum, 0, 0);
    check_near("maximum", summary.maximum, 100, 0);
    summary = summary_of((float[]){7}, 1);
    check_near("median of one", summary.value, 7, 0);
    check_near("p95 of one", summary.p95, 7, 0);
}

TEST(interpolation) {
    /* y = 8 / sqrt x, then up and down again. */
    const double at[] = {1, 4, 64, 256, 512}, error[] = {8, 4, 1, 4, .5};
    check_near("on a power law", log_interpolate(at, error, 5, 2), 16, 1e-9);
    check_near("at its first point", log_interpolate(at, error, 5, 8), 1, 0);
    check_near("at one of two", log_interpolate(at, error, 5, 4), 4, 1e-9);
    check_near("at its last", log_interpolate(at, error, 5, .5), 512, 1e-9);
    check_near("before it", log_interpolate(at, error, 5, 8.1), 0, 0);
    assert_true(isinf(log_interpolate(at, error, 5, .49)));
    assert_true(isinf(log_interpolate(at, error, 0, 8)));
}

/* --- grids ------------------------------------------------------------------------------------ */

/* The variants and points of a subject that is varied by one text or two. */
static void check_grid(const char *first, const char *second, const char *expected) {
    struct measure_desc desc = measure_default(NULL, 60, 40);
    struct measure_list list = {0};
    char joined[512] = "";
    check_ok("variant", variant_apply(&desc, "fast"));
    measure_list_add(&list, &desc);
    check_ok(first, measure_vary(&list, first));
    check_ok(second, !second || measure_vary(&list, second));
    for (int i = 0; i < list.count; i++)
        snprintf(joined + strlen(joined), sizeof joined - strlen(joined), "%s%s: %s", i ? "; " : "",
                 list.items[i].variant, list.items[i].point);
    assert_string_equal(joined, expected);
    free(list.items);
}

TEST(grids) {
    check_grid("vals=2,8,30", NULL, "fast: vals=2; fast: vals=8; fast: vals=30");
    check_grid("M=2..12", NULL, "fast: vals=2; fast: vals=4; fast: vals=8; fast: vals=12");
    check_grid("N=64..128", NULL, "fast: vpls=64; fast: vpls=128");
    check_grid("K=1,2..4", NULL, "fast: terms=1; fast: terms=2; fast: terms=4");
    check_grid("tolerance=.5,1", NULL, "fast: tolerance=.5; fast: tolerance=1");
    check_grid("technique=clustered,unshadowed", NULL, "fast clustered: ; fast unshadowed: ");
    check_grid("size=40x30,80x60", NULL, "fast: size=40x30; fast: size=80x60");
    check_grid("M=2,4", "visibility=cssm,hard",
               "fast cssm: vals=2; fast hard: vals=2; fast cssm: vals=4; fast hard: vals=4");
}

TEST(grid_refusals) {
    static const char *const wrong[] = {"",        "vals",   "vals=",          "=3",
                                        "vals=x",  "vals=0", "vals=8..2",      "vals=2..",
                                        "vals=2,", "woof=1", "technique=woof", "visibility=a..b"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct measure_desc desc = measure_default(NULL, 60, 40);
        struct measure_list list = {0};
        measure_list_add(&list, &desc);
        if (measure_vary(&list, wrong[i]))
            fail_msg("'%s' was taken for a grid", wrong[i]);
        printf("    %s\n", error_get());
        free(list.items);
    }
}

TEST(subjects) {
    struct measure_desc desc = measure_default(NULL, 60, 40);
    check_ok("variant", variant_apply(&desc, "mine:technique=unshadowed,rsm-size=64"));
    check_ok("settings", measure_assign(&desc, "vals=4,visibility=hard vpls=128,size=30x20"));
    assert_string_equal(desc.technique->name, "unshadowed");
    assert_string_equal(desc.variant, "mine");
    check_near("texels", measure_setting(&desc, "rsm-size"), 64, 0);
    check_near("VALs that it has not", measure_setting(&desc, "vals"), 0, 0);
    check_near("VPLs of all pixels", measure_pixel_vpls(&desc), 30 * 20 * 128 / 64., 1e-9);
    char *settings = measure_settings(&desc);
    assert_string_equal(
        settings, "lights.vpls=128 lights.rsm-size=64 clustered.vals=4 clustered.visibility=hard");
    free(settings);
    assert_false(variant_apply(&desc, "woof"));
    assert_false(variant_apply(&desc, "a,b:vals=3"));
    assert_false(variant_apply(&desc, "a:vals=x"));
}

/* --- references ------------------------------------------------------------------------------- */

static void check_other_file(const struct measure_desc *desc, const char *first, const char *what,
                             bool other) {
    char *path = reference_path(&(struct reference_desc){REFERENCE_PATH, "cache", .02}, desc);
    printf("    %-16s %s\n", what, path);
    assert_int_equal(strcmp(path, first) != 0, other);
    free(path);
}

/* What a reference shows, and nothing else, has a part in its name. */
TEST(reference_names) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    struct measure_desc desc = measure_default(&stage, 16, 16);
    char *first = reference_path(&(struct reference_desc){REFERENCE_PATH, "cache", .02}, &desc);
    check_other_file(&desc, first, "the same", false);
    check_ok("setting", measure_assign(&desc, "vals=3"));
    check_other_file(&desc, first, "a setting", false);
    check_ok("materials", measure_assign(&desc, "materials=diffuse"));
    check_other_file(&desc, first, "materials", true);
    check_ok("materials", measure_assign(&desc, "materials=full"));
    check_ok("setting", measure_assign(&desc, "bounces=2"));
    check_other_file(&desc, first, "two bounces", true);
    check_ok("setting", measure_assign(&desc, "bounces=1"));
    stage.geometry.position[5][1] += .001F;
    check_other_file(&desc, first, "a vertex", true);
    stage.geometry.position[5][1] -= .001F;
    pose_stage(&stage);
    check_other_file(&desc, first, "posed again", false);
    stage.scene.materials[1].base_color[2] *= .5F;
    check_other_file(&desc, first, "a colour", true);
    stage.scene.materials[1].base_color[2] *= 2;
    stage.camera.eye[0] += 1;
    check_other_file(&desc, first, "the camera", true);
    pose_stage(&stage);
    stage.emitters.items[0].intensity[0] += 1;
    check_other_file(&desc, first, "the light", true);
    free(first);
}

/* Diffuse materials are asked of the reference and of the tracer beside a technique, too: neither
 * then has reflections, and the tracer errs by its noise alone. */
TEST(matt_reference) {
    struct image references[2];
    struct results results = {0};
    struct reference_desc reference = {REFERENCE_PATH, scratch("references"), .1};
    int channels[3];
    OWNED(stage) stage = open_stage("scenes/gloss.glb");
    struct measure_desc desc = measure_default(&stage, 24, 24);
    check_ok("full", reference_get(&reference, &desc, &references[0]));
    check_ok("materials", measure_assign(&desc, "materials=diffuse"));
    check_ok("diffuse", reference_get(&reference, &desc, &references[1]));
    assert_true(image_find_layer(&references[0], "specular", channels));
    assert_false(image_find_layer(&references[1], "specular", channels));
    check_ok("tracer", baseline_measure(&results, &desc, &reference, "path"));
    check_near("bias of the tracer with 16 samples, %",
               results_value(&results, results.subject_count - 1, "relative-bias", NULL), 0, 3);
    results_free(&results);
    images_free(&references[0], &references[1]);
}

/* The reference that was just made is the one that is there the next time, bit for bit. */
TEST(same_reference) {
    struct image references[2];
    struct reference_desc reference = {REFERENCE_PATH, scratch("fresh-references"), .5};
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    struct measure_desc desc = measure_default(&stage, 16, 16);
    char *path = reference_path(&reference, &desc);
    remove(path);
    for (int i = 0; i < 2; i++)
        check_ok("reference", reference_get(&reference, &desc, &references[i]));
    assert_int_equal(references[0].channel_count, references[1].channel_count);
    assert_memory_equal(references[0].pixels, references[1].pixels,
                        16 * 16 * (size_t)references[0].channel_count * sizeof(float));
    for (int i = 0; i < 2; i++)
        image_free(&references[i]);
    free(path);
}

/* --- virtual lights --------------------------------------------------------------------------- */

TEST_WITH(lights, open_group_context, close_group_context) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct lights lights;
    open_renderer(&renderer, desc_of(&stage, "clustered", small, 16, 16));
    check_ok("lights", lights_read(&lights, &renderer));
    assert_int_equal(lights.vpl_count, 64);
    assert_int_equal(lights.val_count, 6);
    check_at_most("lit VPLs", lights.lit, 64);
    check_at_most("VALs in use", lights.used, 6);
    assert_true(lights.lit > 32 && lights.used > 3);
    double counted = 0;
    for (int i = 0; i < 6; i++)
        counted += (double)lights.centers[i][3];
    check_near("VPLs of all VALs", counted, lights.lit, 0);
    lights_free(&lights);
}

/* --- a technique of its own kind -------------------------------------------------------------- */

static struct contribution nothing(const void *state) {
    (void)state;
    return (struct contribution){0};
}

/* Without VPLs, VALs and anything gathered: what needs them says so. */
TEST_WITH(without_vpls, open_group_context, close_group_context) {
    struct technique voxels = {.name = "voxels", .contribution = nothing};
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct lights lights;
    open_renderer(&renderer, desc_of(&stage, "unshadowed", small, 16, 16));
    const struct technique *own = renderer.technique;
    renderer.technique = &voxels;
    check_refused(lights_read(&lights, &renderer), "technique 'voxels' has no VPLs");
    lights_free(&lights);
    check_refused(aov_check(&renderer, "vpl"), "'voxels' has no layer 'vpl' to add (there are ao");
    renderer.technique = own;
}

/* --- the baseline ----------------------------------------------------------------------------- */

static void add_subject(struct results *results, struct measure_desc *desc, int width, double cpu,
                        double error, double flip) {
    desc->width = width;
    results_begin(results, desc);
    results_add(results, "cpu", "", "ms", cpu);
    results_add(results, "relative-rmse", "path", "%", error);
    results_add(results, "ldr-flip", "path", "1", flip);
}

/* Of its scene and size alone: the baseline needs 16 ms for an error of 2, and errs by a FLIP of .5
 * at the most. */
TEST_WITH(baseline, open_group_context, close_group_context) {
    struct results results = {0};
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    struct measure_desc desc = measure_default(&stage, 16, 16), baseline = desc;
    baseline.technique = NULL;
    add_subject(&results, &baseline, 8, 1, 2, .6);
    add_subject(&results, &baseline, 16, 1, 8, .5);
    add_subject(&results, &baseline, 16, 64, 1, .1);
    add_subject(&results, &desc, 16, 4, 2, .6);
    baseline_add_ratios(&results);
    check_near("at equal RMSE", results_value(&results, 3, "baseline-at-rmse", NULL), 4, 1e-9);
    check_near("at equal FLIP", results_value(&results, 3, "baseline-at-flip", NULL), 0, 0);
    add_subject(&results, &desc, 32, 4, 2, .6);
    baseline_add_ratios(&results);
    assert_null(results_find(&results, 4, "baseline-at-rmse", NULL));
    results_free(&results);
}

/* --- clips ------------------------------------------------------------------------------------ */

static int subject_of(const struct results *results, const char *variant, const char *point) {
    for (int i = 0; i < results->subject_count; i++)
        if (strcmp(results->subjects[i].desc.variant, variant) == 0 &&
            strcmp(results->subjects[i].desc.point, point) == 0)
            return i;
    fail_msg("nothing of %s, %s", variant, point);
    return -1;
}

static double value_of(const struct results *results, const char *variant, const char *point,
                       const char *what) {
    const struct result *row =
        results_find(results, subject_of(results, variant, point), what, NULL);
    if (!row)
        fail_msg("no %s of %s, %s", what, variant, point);
    printf("    %-20s %-28s %-16s %g %s\n", variant, point, what, row->figure.value, row->unit);
    return row->figure.value;
}

/* The reference does not flicker against itself; what is interleaved and blurred does. */
TEST_WITH(flicker, open_group_context, close_group_context) {
    struct results results = {0};
    OWNED(stage) stage = open_stage("scenes/moving-spot.glb");
    struct measure_desc r = measure_default(&stage, 16, 16), fast = r;
    struct measure_list subjects = {0};
    check_ok("R", variant_apply(&r, reference_vpls));
    check_ok("fast", variant_apply(&fast, "fast"));
    check_ok("settings", measure_assign(&r, "vpls=64,map-size=32,rsm-size=64"));
    check_ok("settings", measure_assign(&fast, "vpls=64,map-size=32,rsm-size=64"));
    measure_list_add(&subjects, &r);
    measure_list_add(&subjects, &fast);
    check_ok("clip",
             clip_measure(&results,
                          &(struct clip_desc){
                              .stage = &stage, .subjects = &subjects, .frames = 3, .all_vpls = r}));
    assert_true(value_of(&results, "R", "", "flicker") == 0);
    double mean = value_of(&results, "fast", "", "flicker"), sum = 0;
    static const char *const points[] = {"time=0", "time=3.33333", "time=6.66667"};
    for (int i = 0; i < 3; i++)
        sum += value_of(&results, "fast", points[i], "frame-flicker");
    assert_true(mean > 0);
    check_near("mean of the frames", sum / 2, mean, 1e-9);
    assert_true(value_of(&results, "fast", "", "most-vals") > 20);
    assert_null(results_find(&results, subject_of(&results, "R", ""), "most-vals", NULL));
    static const char *const when[] = {"after a tenth of the clip", "at its end"};
    double objects = value_of(&results, "memory", when[0], "gl-objects");
    assert_true(objects > 0 && value_of(&results, "memory", when[1], "gl-objects") == objects);
    for (int i = 0; i < 2; i++)
        assert_true(value_of(&results, "memory", when[i], "most-resident") >=
                    value_of(&results, "memory", when[i], "resident-memory"));
    free(subjects.items);
    results_free(&results);
}

RUN_TESTS(NULL, NULL)
