#ifndef SHARED_MATERIAL_H
#define SHARED_MATERIAL_H

#include "shared/types.h"

/* glTF's factors. Light is reflected as if all were diffuse, by the base colour alone. */
struct material_block {
    vec4 base_color;    /* linear */
    vec4 emission;      /* linear, W/(sr m2); w unused */
    float alpha_cutoff; /* below it is a hole; negative: opaque */
    float double_sided;
    float textured;     /* has a base colour texture */
    float metalness, roughness;
    float unused0, unused1, unused2;
};

#endif
