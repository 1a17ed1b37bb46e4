// VPLs by importance: few of them carry most of the light of places that the camera does not see, from where later bounces
// reach it. More paths begin at those. The VPL of a path, and how many VPLs' light it carries.
#include "shared/bounce.h"

layout(binding = UNIT_PATH_STARTS) uniform sampler2D path_starts;

float path_start_end(int vpl_index) {
    return vpl_index < 0 ? 0.0 : texelFetch(path_starts, ivec2(vpl_index, 0), 0).r;
}

int path_start(int path, float choice, out float vpls_per_path) {
    float paths = float(BOUNCE_ROWS * params.later), number = (float(path) + choice) / paths;
    int first = 0, last = params.vpls - 1;
    while (first < last) {
        int middle = (first + last) / 2;
        bool later = path_start_end(middle) <= number;
        first = later ? middle + 1 : first;
        last = later ? last : middle;
    }
    vpls_per_path = 1.0 / max(paths * (path_start_end(first) - path_start_end(first - 1)), 1e-30);
    return first;
}
