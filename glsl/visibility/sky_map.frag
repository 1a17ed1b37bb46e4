// Depth of casters with holes.
#include "shared/material.h"

layout(std140, binding = BLOCK_MATERIAL) uniform material_uniforms {
    material_block material;
};
layout(binding = UNIT_BASE_COLOR) uniform sampler2D base_color_texture;

in vec2 surface_uv;

void main() {
    float alpha = material.base_color.a;
    if (material.textured)
        alpha *= texture(base_color_texture, surface_uv).a;
    if (alpha < material.alpha_cutoff)
        discard;
}
