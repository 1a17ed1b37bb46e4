/* What happened to a window, cut into turns: in order, and each with no more than it can tell the
 * order of. */
#include "support.h"

#include "viewer/window/events.h"

enum { CONTROL = 341 }; /* any code */

/* Two letters an event: k and its key, pressed; K, released; t and a character; b B a button; m the
 * mouse, s the wheel. */
static struct events events_of(const char *text) {
    struct events events = {0};
    for (; *text; text += 2) {
        struct event event = {.code = text[1] == '^' ? CONTROL : text[1], .x = text[1], .y = 1};
        event.kind = strchr("kK", *text)   ? EVENT_KEY
                     : *text == 't'        ? EVENT_TEXT
                     : strchr("bB", *text) ? EVENT_BUTTON
                     : *text == 'm'        ? EVENT_CURSOR
                                           : EVENT_SCROLL;
        event.down = strchr("kb", *text);
        events_add(&events, &event);
    }
    return events;
}

/* How many events each turn takes, in a row. */
static void check_turns(const char *text, const char *expected) {
    char turns[64] = "";
    struct events events = events_of(text);
    for (int count; (count = events_of_turn(&events)) > 0;) {
        snprintf(turns + strlen(turns), sizeof turns - strlen(turns), "%d ", count);
        events_drop(&events, count);
    }
    printf("    %-32s %s\n", text, turns);
    assert_string_equal(turns, expected);
    events_free(&events);
}

TEST(turns) {
    check_turns("", "");
    check_turns("kata", "2 ");
    check_turns("kataKakbtbKb", "2 3 1 ");     /* ab */
    check_turns("k^kaKaK^kbtb", "1 1 4 ");     /* Ctrl A, then b: never b with Ctrl */
    check_turns("k^kaK^Ka", "1 1 2 ");         /* nor A without */
    check_turns("k^kaKakaKaK^", "1 1 1 1 2 "); /* twice the same key */
    check_turns("tatb", "2 ");
    check_turns("m1m2m3b0B0", "1 1 1 "); /* there, pressed, released */
    check_turns("b0m1m2B0", "1 1 1 ");   /* a drag */
    check_turns("m1s0s0k^b0", "1 1 1 1 ");
    check_turns("k^m1b0B0K^", "1 1 1 1 1 ");
}

/* Where the mouse has come to, and how far the wheel went. */
TEST(merged) {
    struct events events = events_of("mambs0s0s0");
    assert_int_equal(events.count, 2);
    assert_true(events.items[0].x == 'b');
    assert_true(events.items[1].y == 3);
    events_free(&events);
}

/* However many come in a slow frame, none is lost, and no turn takes more than it has room for. */
TEST(many) {
    struct events events = {0};
    for (int i = 0; i < 1000; i++)
        events_add(&events, &(struct event){.kind = EVENT_TEXT, .code = i});
    int next = 0;
    for (int count; (count = events_of_turn(&events)) > 0; events_drop(&events, count)) {
        assert_true(count <= EVENTS_OF_TURN);
        for (int i = 0; i < count; i++)
            assert_int_equal(events.items[i].code, next++);
    }
    assert_int_equal(next, 1000);
    events_free(&events);
}

RUN_TESTS(NULL, NULL)
