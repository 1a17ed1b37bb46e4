// By how much lookups are to be corrected, so that in sum as much light arrives as rays say: part of what they let through
// is taken off, or part of what they stop let through. By less where that sum may be chance: of what is found, the part
// stays that chance does not explain [James and Stein 1961].
#include "shared/bindings.h"
#include "shared/calibration.h"

layout(binding = UNIT_CALIBRATION_SUMS) uniform sampler2DArray sums;
layout(binding = UNIT_CALIBRATION_SQUARES) uniform sampler2DArray squares;

flat in int instance;

layout(location = TARGET_RESULT) out vec2 gains;

// Of what a cell has little of, all of the picture says more.
const float MEAN_COUNTS = 1.0;
// Variances that chance explains. With one, maps that are right already lose more than others gain.
const float CHANCE = 2.0;

float gain_of(float all, float found, float due, float square) {
    float more = due - found, part = more > 0.0 ? all - found : found;
    float sure = max(1.0 - CHANCE * square / max(more * more, 1e-30), 0.0);
    return clamp(sure * more / max(part, 1e-30), -1.0, 1.0);
}

void main() {
    const int CELLS = CALIBRATION_SIDE * CALIBRATION_SIDE;
    vec4 all = vec4(0.0);
    vec2 all_squares = vec2(0.0);
    for (int i = 0; i < CELLS; i++) {
        ivec3 cell = ivec3(i % CALIBRATION_SIDE, i / CALIBRATION_SIDE, instance);
        all += texelFetch(sums, cell, 0);
        all_squares += texelFetch(squares, cell, 0).rg;
    }
    const float PART = MEAN_COUNTS / float(CELLS);
    ivec3 own = ivec3(gl_FragCoord.xy, instance);
    vec4 light = texelFetch(sums, own, 0) + PART * all;
    vec2 square = texelFetch(squares, own, 0).rg + PART * PART * all_squares;
    gains = vec2(gain_of(light.r, light.g, light.a, square.r), gain_of(light.r, light.b, light.a, square.g));
}
