#include "shared/cluster.h"

flat in vec3 point_position, point_normal, point_flux;

layout(location = TARGET_VAL_POSITION) out vec4 sum_position; // w: count
layout(location = TARGET_VAL_NORMAL) out vec4 sum_normal; // w: weight
layout(location = TARGET_VAL_FLUX) out vec4 sum_flux;

void main() {
#if METRIC == CLUSTER_METRIC_SQUARES
    float weight = dot(point_flux, vec3(1.0));
#else
    float weight = 1.0;
#endif
    sum_position = vec4(point_position * weight, 1.0);
    sum_normal = vec4(point_normal * weight, weight);
    sum_flux = vec4(point_flux, 0.0);
}
