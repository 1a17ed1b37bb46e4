#ifndef SHARED_MATERIAL_H
#define SHARED_MATERIAL_H

#include "shared/types.h"

struct material_block {
    vec4 base_color;    /* linear */
    float alpha_cutoff; /* below it is a hole; negative: opaque */
    float double_sided;
    float textured;
    float unused;
};

#endif
