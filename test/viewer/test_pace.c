/* Times of passes over frames, as the viewer keeps them. */
#define _POSIX_C_SOURCE 200809L
#include "support.h"

#include "viewer/picture/pace.h"

static struct timers timers;
static struct pace pace;

static void add(const char *path, int depth, double ms) {
    struct timer_result *result = &timers.results[timers.count++];
    *result = (struct timer_result){.depth = depth, .ms = ms};
    snprintf(result->path, sizeof result->path, "%s", path);
}

static void end_frame(double pixels) {
    pace_add(&pace, &timers, pixels, 0);
    timers.count = 0;
}

/* In the order in which they run, whichever came first. */
TEST(order) {
    static const char *const expected[] = {"frame", "frame/gbuffer", "frame/antialias",
                                           "frame/composite", "frame/last"};
    memset(&pace, 0, sizeof pace);
    add("frame", 0, 7);
    add("frame/gbuffer", 1, 3);
    add("frame/composite", 1, 4);
    end_frame(100);
    add("frame", 0, 10);
    add("frame/gbuffer", 1, 3);
    add("frame/antialias", 1, 2);
    add("frame/composite", 1, 4);
    add("frame/last", 1, 1);
    end_frame(200);
    assert_int_equal(pace.pass_count, 5);
    for (int i = 0; i < 5; i++) {
        printf("    %-20s %.3g ms, then %.3g ms\n", pace.passes[i].path,
               (double)pace.passes[i].history[0], (double)pace.passes[i].history[1]);
        assert_string_equal(pace.passes[i].path, expected[i]);
    }
    assert_true(pace.passes[2].history[0] == 0 && pace.passes[2].history[1] == 2);
    assert_true(pace.frame_pixels[0] == 100 && pace.frame_pixels[1] == 200);
}

/* The history is as long as it is: the oldest frames go. */
TEST(history) {
    memset(&pace, 0, sizeof pace);
    for (int i = 0; i < PACE_HISTORY + 10; i++) {
        add("frame", 0, i);
        add("frame/gather", 1, i);
        end_frame(1);
    }
    assert_int_equal(pace.frame_count, PACE_HISTORY);
    printf("    %d frames, from %g to %g ms; median of the last %g ms\n", pace.frame_count,
           (double)pace.frame_ms[0], (double)pace.frame_ms[PACE_HISTORY - 1],
           (double)pace_median(&pace.passes[1]));
    for (int i = 0; i < PACE_HISTORY; i++) {
        assert_true(pace.frame_ms[i] == (float)(i + 10));
        assert_true(pace.passes[1].history[i] == (float)(i + 10));
    }
    assert_true(pace_median(&pace.passes[1]) == PACE_HISTORY + 2);
    pace_begin_medians(&pace);
    assert_true(pace_median(&pace.passes[1]) == 0);
    assert_true(pace.passes[1].history[0] == 10);
}

RUN_TESTS(NULL, NULL)
