#include "base/spiral.h"

#include <math.h>

static double fraction(double x) {
    return x - floor(x);
}

/* Passes step by powers of the plastic number: any run of them is even. */
struct spiral_shift spiral_shift(int x, int y, int pass) {
    static const double turn_x = .156, turn_y = .25, turn_pass = .5698402909980532;
    static const double along_x = .135, along_pass = .7548776662466927;
    return (struct spiral_shift){
        .turn = (float)fraction(turn_x * x + turn_y * y + turn_pass * pass),
        .along = (float)fraction(.5 + along_x * x + along_pass * pass),
    };
}
