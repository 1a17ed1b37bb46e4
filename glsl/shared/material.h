#ifndef SHARED_MATERIAL_H
#define SHARED_MATERIAL_H

#include "shared/types.h"

/* Factors of glTF's metallic-roughness model (scene/material.h). Scenes of plain materials read
 * the base colour, the emission and how the surface is drawn alone. */
struct material_block {
    vec4 base_color; /* linear */
    vec3 emission;   /* of what shines: linear, W/(sr m2), times irradiance_scale; of what is unlit
                        the scale alone, times the base colour */
    float metalness;
    float roughness;
    float alpha_cutoff; /* below it is a hole; negative: opaque */
    BOOL double_sided;
    BOOL textured; /* has a base colour texture */
    BOOL emission_textured;
    BOOL diffuse; /* by its base colour alone */
    BOOL unlit;
    BOOL metal_roughness_textured;
    vec3 specular_f0; /* of what is no metal */
    float specular_f90;
    BOOL normal_textured;
    float normal_scale;
    BOOL
        specular_glossiness; /* the metal-roughness texture has the specular colour in RGB, glossiness in A */
    int metal_roughness_mapping;
    int emission_mapping;
    int normal_mapping;
    int unused0, unused1;
};
STD140_SIZE(material_block, 112)

#endif
