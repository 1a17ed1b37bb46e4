/* Maps that rays correct: where few VALs let too much light through, or too little, about as much arrives as by rays;
 * where maps are right they stay so. Rays to each VPL are the reference, of the same VPLs. */
#include "render_support.h"

#include <math.h>
#include <stdio.h>

enum { SIDE = 64 };

/* VPLs by flux, as maps of few VALs are wrong for these: placed by importance there is little to correct. */
#define COMMON "samples=1 lights.importance=off "

struct error {
    double bias, rmse;
};

static struct error error_of(const struct stage *stage, const char *settings,
                             const struct image *reference) {
    struct image picture = render_stage(stage, "clustered", settings, SIDE);
    struct error error = {layer_mean(&picture, "indirect") / layer_mean(reference, "indirect") - 1,
                          relative_rmse(&picture, reference, "indirect")};
    image_free(&picture);
    printf("    %-40s relative RMSE %.4f, bias %+.4f\n", settings, error.rmse, error.bias);
    return error;
}

static void compare(const char *scene, const char *without, const char *with, struct error *before,
                    struct error *after) {
    struct stage stage;
    printf("    %s\n", scene);
    open_stage(&stage, scene);
    struct image reference =
        render_stage(&stage, "clustered", COMMON "visibility=traced visibility-block=0", SIDE);
    *before = error_of(&stage, without, &reference);
    *after = error_of(&stage, with, &reference);
    image_free(&reference);
    stage_free(&stage);
}

/* Six VALs: the courtyard's look over walls, and let a third too much light through; the atrium's do not see into
 * its arches. */
static void test_few_vals(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/courtyard.glb", "scenes/atrium.glb"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        struct error before, after;
        compare(scenes[i], COMMON "vals=6 ray-tests=0", COMMON "vals=6", &before, &after);
        check_at_most("bias, over that without", fabs(after.bias / before.bias), .6);
        check_at_most("relative RMSE, over that without", after.rmse / before.rmse, .95);
    }
}

/* In a box the maps are right, and chance must not make them worse: bounds are one hundredth above what is without. */
static void test_right_maps(void **state) {
    (void)state;
    struct error before, after;
    compare("scenes/cornell-box.glb", COMMON "ray-tests=0", COMMON, &before, &after);
    check_at_most("relative RMSE, over that without", after.rmse / before.rmse, 1.01);
    check_at_most("bias", fabs(after.bias), fabs(before.bias) + .001);
}

/* So many tests that hardly any chance is left. */
static void test_many_tests(void **state) {
    (void)state;
    struct error before, after;
    compare("scenes/courtyard.glb", COMMON "vals=6", COMMON "vals=6 ray-tests=8192", &before,
            &after);
    check_at_most("bias, over that with few", fabs(after.bias / before.bias), 1);
    check_at_most("bias", fabs(after.bias), .05);
}

/* A light a tenth brighter is one that rounds elsewhere: corrections are fractions, and stay. Where maps block nothing of
 * what tests ask for, rounding alone would say which part of nothing is missing. */
static void test_rounding(void **state) {
    (void)state;
    const float brighter = 1.1f;
    struct stage stage;
    open_stage(&stage, "scenes/atrium.glb");
    struct image before = render_stage(&stage, "clustered", COMMON, SIDE);
    for (int i = 0; i < stage.emitters.count; i++)
        for (int c = 0; c < 3; c++)
            stage.emitters.items[i].intensity[c] *= brighter;
    struct image after = render_stage(&stage, "clustered", COMMON, SIDE);
    for (int i = 0; i < before.width * before.height * before.channel_count; i++)
        before.pixels[i] *= brighter;
    /* Halves of layers have 11 bits. */
    check_at_most("relative RMSE between", relative_rmse(&after, &before, "indirect"), 1e-3);
    images_free(&before, &after);
    stage_free(&stage);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_few_vals),
        cmocka_unit_test(test_right_maps),
        cmocka_unit_test(test_many_tests),
        cmocka_unit_test(test_rounding),
    };
    return cmocka_run_group_tests_name("correction", tests, open_group_context,
                                       close_group_context);
}
