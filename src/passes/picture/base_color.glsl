// The surface's own colour at a fragment, and how much of it is there.
#include "shared/material.h"

layout(std140, binding = BLOCK_MATERIAL) uniform material_uniforms {
    material_block material;
};
layout(binding = UNIT_BASE_COLOR) uniform sampler2D base_color_texture;

in vec2 surface_uv;
in vec4 surface_color;

vec4 base_color() {
    vec4 color = material.base_color * surface_color;
    return material.textured ? color * texture(base_color_texture, surface_uv) : color;
}
