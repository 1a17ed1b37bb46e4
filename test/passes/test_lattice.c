/* Numbers by which one of many is taken (glsl/lib/random.glsl): the same bits on every driver,
 * whatever it rounds. */
#include "render_support.h"

enum { SIDE = 64, APART = 127 }; /* pixels of a picture of 8K, one in APART along each side */

/* Each is the fraction of x steps along x and y along y: against integers, and against the
 * multiples that these stand for. */
TEST(numbers) {
    static float numbers[SIDE * SIDE];
    double wrong = 0, furthest = 0;
    need_file("glsl/lib/random.glsl");
    ask_shader(&FILLED(
        questions, .shader = "lattice.comp",
        .defines = form("SIDE %d;APART %d;RECEIVERS 0;RECEIVERS_ADAPTIVE 1", SIDE, APART),
        .answers = numbers, .answer_bytes = sizeof numbers, .groups = {SIDE / 8, SIDE / 8}));
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        uint32_t x = i % SIDE * APART, y = i / SIDE * APART;
        uint32_t turns = x * 3242174889u + y * 2447445414u;
        double multiple = x * .7548776662466927 + y * .5698402909980532;
        double number = (double)numbers[i], off = fabs(number - (multiple - floor(multiple)));
        wrong = fmax(wrong, fabs(number - (turns >> 8) / 16777216.));
        furthest = fmax(furthest, fmin(off, 1 - off));
    }
    check_at_most("off the integers' number", wrong, 0);
    check_at_most("off the fraction of the multiple", furthest, 3e-6);
}

RUN_TESTS(open_group_context, close_group_context)
