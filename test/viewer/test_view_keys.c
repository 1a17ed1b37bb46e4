/* Keys by real input events, in the window's own process: a key that is held, and an early Esc. */
#define _XOPEN_SOURCE 700
#include "view_inside.h"

#include "viewer/window/ui.h"
#include "viewer/window/window.h"

static void begin(const char *scene) {
    begin_viewer(&(struct viewer_desc){.scene = scene, .width = 96, .height = 96});
    xdo("mousemove 40 40");
    rest();
}

/* How often the window is drawn within so many seconds. */
static int count_draws(double seconds) {
    double last = viewer.host.last_drawn, start = clock_ms();
    int draws = 0;
    for (; clock_ms() - start < 1000 * seconds; last = viewer.host.last_drawn) {
        turn();
        draws += viewer.host.last_drawn != last;
    }
    return draws;
}

/* The window falls asleep 1.5 s after the last event, but not while a key comes again and again: a
 * field's key would stop. This key types nothing, as text would wake the window, too. */
TEST(held_key) {
    begin("scenes/cornell-box.glb");
    turn_until(window_time() > viewer.host.newest_message + 9); /* messages go */
    count_draws(3);
    int idle = count_draws(1);
    xdo("keydown Right");
    count_draws(3);
    int held = count_draws(1);
    xdo("keyup Right");
    count_draws(3);
    int released = count_draws(1);
    printf("    draws a second: %d at rest, %d while a key is held, %d afterwards\n", idle, held,
           released);
    assert_int_equal(idle, 0);
    assert_true(held >= 5);
    assert_int_equal(released, 0);
    finish_viewer();
}

/* The first Esc of all comes in the window's first two seconds, and quits nothing. */
TEST(early_escape) {
    begin_viewer(&(struct viewer_desc){.width = 96, .height = 96});
    xdo("mousemove 40 40 key Escape");
    turn_until(viewer.done || is_message_told("Esc once more quits", UI_NORMAL));
    printf("    Esc after %.2f s: quits %d\n", viewer.hand.last_escape, viewer.done);
    assert_false(viewer.done);
    finish_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
