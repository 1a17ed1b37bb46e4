// VPLs by flux alone: paths begin at all of them in turn. The VPL of a path, and how many VPLs' light it carries.
#include "shared/bounce.h"

int path_start(int path, float choice, out float vpls_per_path) {
    vpls_per_path = float(params.vpls) / float(BOUNCE_ROWS * params.later);
    return min(int((float(path) + choice) * vpls_per_path), params.vpls - 1);
}
