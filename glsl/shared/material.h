#ifndef SHARED_MATERIAL_H
#define SHARED_MATERIAL_H

#include "shared/types.h"

/* Factors of glTF's metallic-roughness model (scene/material.h). With plain materials only the base
 * colour, the emission, and members for drawing are read. */
struct material_block {
    vec4 base_color; /* linear */
    /* Emissive material: linear, W/(sr m2), times irradiance_scale. Unlit material: the scale
     * alone, as factor of the base colour. */
    vec3 emission;
    float metalness;
    float roughness;
    float alpha_cutoff; /* lower alpha is a hole; negative: opaque */
    BOOL double_sided;
    BOOL textured; /* with a base colour texture */
    BOOL emission_textured;
    BOOL diffuse; /* Lambertian with the base colour */
    BOOL unlit;
    BOOL metal_roughness_textured;
    vec3 specular_f0; /* of the dielectric part */
    float specular_f90;
    BOOL normal_textured;
    float normal_scale;
    BOOL specular_glossiness; /* the metal-roughness texture has specular colour and glossiness */
    int metal_roughness_mapping;
    int emission_mapping;
    int normal_mapping;
    int unused0, unused1;
};
STD140_SIZE(material_block, 112)

#endif
