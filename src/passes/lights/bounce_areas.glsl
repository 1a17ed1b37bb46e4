// The area that VPL i stands for, of those around it that face alike: of random points P / A to an area the nearest of a
// share s lies within pi d^2 = A / (s P) on the mean.
#include "shared/bounce.h"

layout(binding = UNIT_PATH_AREAS) uniform sampler2D path_areas; // a row's sum of such d^2

float path_area(int i) {
    const float PI = 3.14159265359;
    float sum = 0.0;
    for (int row = 0; row < BOUNCE_ROWS; row++)
        sum += texelFetch(path_areas, ivec2(i, row), 0).r;
    float share = float(min(params.later, BOUNCE_PARTNERS)) / float(params.later * BOUNCE_RUNS);
    return PI * share * sum / float(BOUNCE_RUNS);
}
