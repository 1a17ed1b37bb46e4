// Where the textures of a material lie that do not all lie as its first one does. HAS_MAPPINGS: some material has such.
#include "shared/material.h"

layout(std140, binding = BLOCK_MATERIAL) uniform material_uniforms {
    material_block material;
};

layout(location = ATTRIBUTE_UV_1) in vec2 uv_1;
layout(location = ATTRIBUTE_UV_2) in vec2 uv_2;
layout(location = ATTRIBUTE_UV_3) in vec2 uv_3;

out vec2 metal_roughness_uv;
out vec2 emission_uv;
out vec2 normal_uv;

vec2 uv_by(int mapping, vec2 uv) {
    return mapping == 0 ? uv : mapping == 1 ? uv_1 : mapping == 2 ? uv_2 : uv_3;
}

void set_mapped_uv(vec2 uv) {
    metal_roughness_uv = uv_by(material.metal_roughness_mapping, uv);
    emission_uv = uv_by(material.emission_mapping, uv);
    normal_uv = uv_by(material.normal_mapping, uv);
}
