#ifndef SHARED_MATERIAL_H
#define SHARED_MATERIAL_H

#include "shared/types.h"

/* glTF's factors. Light is reflected as if all were diffuse, by the base colour alone. */
struct material_block {
    vec4 base_color; /* linear */
    vec3 emission;   /* linear, W/(sr m2) */
    float metalness;
    float roughness;
    float alpha_cutoff; /* below it is a hole; negative: opaque */
    BOOL double_sided;
    BOOL textured; /* has a base colour texture */
};
STD140_SIZE(material_block, 48)

#endif
