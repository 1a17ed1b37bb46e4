/* passes/visibility/vpl_views.h to its shader. */
#ifndef SHARED_VPL_VIEWS_H
#define SHARED_VPL_VIEWS_H

#include "shared/types.h"

struct vpl_views_params {
    vec3 bounds_min; /* metres */
    float near_clip; /* over the spread of VPLs */
    vec3 bounds_max;
    float unused;
};
PASS_BLOCK(vpl_views_params, 32)

#endif
