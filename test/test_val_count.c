/* How many VALs the light needs: few where a flat wall shines, several times as many where folds do, by the light
 * of the frame alone. */
#include "render_support.h"

#include "inspect/lights.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 24 };

static const char settings[] = "vals=60 distortion=.085 map.size=16 gather.detail=0 samples=1";

/* Of the stage at that time. */
static int count_at(struct renderer *renderer, struct stage *stage, double time) {
    struct lights lights;
    check_ok("pose", stage_pose(stage, time) && stage_show(stage, renderer));
    renderer_render(renderer);
    check_ok("lights", lights_read(&lights, renderer));
    int used = lights.used;
    lights_free(&lights);
    return used;
}

/* A spot goes from a corner along a wall to the ceiling: few VALs throughout, and no jump from one time to the
 * next. */
static void test_wall(void **state) {
    (void)state;
    struct stage stage;
    struct renderer renderer;
    int before = 0, worst = 0;
    open_stage(&stage, "scenes/moving-spot.glb");
    struct renderer_desc desc = desc_of(&stage, "clustered", settings, SIDE, SIDE);
    open_renderer(&renderer, &desc);
    for (int i = 0; i <= 100; i++) {
        int count = count_at(&renderer, &stage, .08 * i);
        printf(" %d", count);
        assert_in_range(count, 3, 10);
        worst = abs(count - before) > worst && i ? abs(count - before) : worst;
        before = count;
    }
    puts("");
    check_at_most("VALs more or less from .08 s to .08 s", worst, 3);
    check_at_most("of a flat wall", count_at(&renderer, &stage, 5.3), 8);
    renderer_free(&renderer);
    stage_free(&stage);
}

static void test_folds(void **state) {
    (void)state;
    struct stage stage;
    struct renderer renderer;
    open_stage(&stage, "scenes/atrium.glb");
    struct renderer_desc desc = desc_of(&stage, "clustered", settings, SIDE, SIDE);
    open_renderer(&renderer, &desc);
    check_at_most("24, of walls with cloths and columns", 24, count_at(&renderer, &stage, 0));
    renderer_free(&renderer);
    stage_free(&stage);
}

/* The same bits, whatever came before. */
static void test_time_alone(void **state) {
    (void)state;
    struct stage stage;
    struct renderer renderer;
    struct image first, again;
    open_stage(&stage, "scenes/moving-spot.glb");
    struct renderer_desc desc = desc_of(&stage, "clustered", settings, SIDE, SIDE);
    open_renderer(&renderer, &desc);
    int count = count_at(&renderer, &stage, 3);
    check_ok("layers", renderer_read_layers(&renderer, &first));
    count_at(&renderer, &stage, 5);
    assert_int_equal(count_at(&renderer, &stage, 3), count);
    check_ok("layers", renderer_read_layers(&renderer, &again));
    assert_true(same_pixels(&first, &again));
    image_free(&first);
    image_free(&again);
    renderer_free(&renderer);
    stage_free(&stage);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_wall),
        cmocka_unit_test(test_folds),
        cmocka_unit_test(test_time_alone),
    };
    return cmocka_run_group_tests_name("VAL count", tests, open_group_context, close_group_context);
}
