#ifndef SHARED_MATERIAL_H
#define SHARED_MATERIAL_H

#include "shared/types.h"

/* glTF's factors. Light is reflected as if all were diffuse, by the base colour alone. */
struct material_block {
    vec4 base_color; /* linear */
    vec3 emission;   /* of what shines: linear, W/(sr m2), times irradiance_scale */
    float metalness;
    float roughness;
    float alpha_cutoff; /* below it is a hole; negative: opaque */
    BOOL double_sided;
    BOOL textured; /* has a base colour texture */
    BOOL emission_textured;
    int unused0, unused1, unused2;
};
STD140_SIZE(material_block, 64)

#endif
