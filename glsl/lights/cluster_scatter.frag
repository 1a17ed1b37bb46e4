#include "shared/cluster.h"

flat in vec3 point_position, point_normal, point_flux;
flat in float point_weight;

layout(location = TARGET_VAL_POSITION) out vec4 sum_position; // w: count
layout(location = TARGET_VAL_NORMAL) out vec4 sum_normal; // w: weight
layout(location = TARGET_VAL_FLUX) out vec4 sum_flux;

void main() {
    sum_position = vec4(point_position * point_weight, 1.0);
    sum_normal = vec4(point_normal * point_weight, point_weight);
    sum_flux = vec4(point_flux, 0.0);
}
