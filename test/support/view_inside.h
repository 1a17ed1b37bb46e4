/* A viewer in the test's own process: its tests take turns of its loop, call its functions and read
 * its state. */
#ifndef TEST_VIEW_INSIDE_H
#define TEST_VIEW_INSIDE_H

#include "view_stage.h"

#include "base/clock.h"
#include "viewer/files/opening.h"
#include "viewer/viewer.h"

/* A frame takes milliseconds. */
#define CHEAP_SETTINGS "vpls=64 vals=4 map-size=32 rsm-size=64 shadow-size=128 interleave=4"

enum { TURNS_MS = 1200000 }; /* which only a viewer that hangs takes, on however busy a machine */

static struct viewer viewer;

static inline void turn(void) {
    check_ok("turn", viewer_turn(&viewer));
    pause_ms(2);
}

/* Takes turns until the condition holds; fails after TURNS_MS. */
#define turn_until(condition)                                                                      \
    for (double start_ms = clock_ms(); !(condition); turn())                                       \
    assert_true(clock_ms() - start_ms < TURNS_MS)

/* Takes turns until all that is wanted is shown. */
static inline void rest(void) {
    for (int i = 0; i < 3; i++)
        turn();
    turn_until(!viewer.shown.moving && !viewer.shown.dirty && !viewer.shown.coarse &&
               !viewer.shown.awaits);
    turn();
}

/* Begins the viewer with CHEAP_SETTINGS, and waits until it shows its scene, if any. Skips the test
 * where there is no server. */
static inline void begin_viewer(const struct viewer_desc *desc) {
    struct viewer_desc cheap = *desc;
    need_server();
    cheap.debug = true;
    renderer_settings_init(&cheap.settings);
    check_ok(CHEAP_SETTINGS, settings_assign(&cheap.settings, CHEAP_SETTINGS));
    check_ok("viewer", viewer_begin(&viewer, &cheap));
    keep_driver();
    turn();
    if (!desc->scene)
        return;
    turn_until(viewer.has_scene && viewer.shown.frame_count > 0);
    rest();
}

/* Ends the viewer; OpenGL had nothing to say. */
static inline void finish_viewer(void) {
    assert_int_equal(context_message_count(viewer.host.context), 0);
    viewer_end(&viewer);
}

/* Whether the window shows a message of that tone which has the text. */
static inline bool is_message_told(const char *text, enum ui_tone tone) {
    struct message recent[MESSAGES_SHOWN];
    int count = messages_recent(&viewer.host.messages, recent);
    for (int i = 0; i < count; i++)
        if (recent[i].tone == tone && strstr(recent[i].text, text))
            return true;
    return false;
}

#endif
