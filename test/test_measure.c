/* The floor that measures, called as a library: what it reads from renderers, and what it refuses.
 */
#include "render_support.h"

#include "base/error.h"
#include "measure/lights.h"
#include "measure/vpl_trace.h"
#include "inspect/aov.h"

#include <stdio.h>
#include <string.h>

static const char small[] = "vpls=64 vals=6 map-size=32 rsm-size=64 shadow-size=128 interleave=1";

/* --- virtual lights --------------------------------------------------------------------------- */

static void test_lights(void **state) {
    (void)state;
    struct stage stage;
    struct renderer renderer;
    struct lights lights;
    open_stage(&stage, "scenes/cornell-box.glb");
    struct renderer_desc desc = desc_of(&stage, "clustered", small, 16, 16);
    open_renderer(&renderer, &desc);
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
    renderer_free(&renderer);
    stage_free(&stage);
}

/* --- a technique of its own kind -------------------------------------------------------------- */

static struct contribution nothing(const void *state) {
    (void)state;
    return (struct contribution){0};
}

static void check_refused(bool ok, const char *message) {
    assert_false(ok);
    printf("    %s\n", error_get());
    assert_non_null(strstr(error_get(), message));
}

/* Without VPLs, VALs and anything gathered: what needs them says so. */
static void test_without_vpls(void **state) {
    (void)state;
    struct technique voxels = {.name = "voxels", .contribution = nothing};
    struct stage stage;
    struct renderer renderer;
    struct lights lights;
    struct image image;
    open_stage(&stage, "scenes/cornell-box.glb");
    struct renderer_desc desc = desc_of(&stage, "unshadowed", small, 16, 16);
    open_renderer(&renderer, &desc);
    const struct technique *own = renderer.technique;
    renderer.technique = &voxels;
    check_refused(lights_read(&lights, &renderer), "technique 'voxels' has no VPLs");
    lights_free(&lights);
    check_refused(vpl_trace(&renderer, 8, 8, NULL, &image), "technique 'voxels' has no VPLs");
    check_refused(aov_check(&renderer, "vpl"),
                  "'voxels' has no layer 'vpl' to add (there are none");
    renderer.technique = own;
    renderer_free(&renderer);
    stage_free(&stage);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lights),
        cmocka_unit_test(test_without_vpls),
    };
    return cmocka_run_group_tests_name("measure", tests, open_group_context, close_group_context);
}
