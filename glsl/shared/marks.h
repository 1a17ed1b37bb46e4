/* inspect/marks.h to its shaders. */
#ifndef SHARED_MARKS_H
#define SHARED_MARKS_H

#include "shared/types.h"

struct mark_params {
    vec2 picture;        /* size, pixels */
    float size;          /* of a point or width of a line, pixels */
    float flux_scale;    /* of a usual VPL, 1/W */
    float normal_length; /* metres */
    BOOL by_cluster;     /* colour: by the VAL, not by the flux */
    int chosen;          /* VAL that stands out; -1 = none, and then all are as bright */
    BOOL only_chosen;    /* no other is drawn */
};
PASS_BLOCK(mark_params, 32)

#endif
