// Draws the scene into a G-buffer: the camera's, or the lights' (the reflective shadow map).
#ifdef LIGHT_VIEW
#include "lib/light_target.glsl"

out vec3 surface_to_other; // the light

void set_place(vec3 position) {
    view v = light_view_at(target_view()).view;
    gl_Position = v.world_to_clip * vec4(position, 1.0);
    surface_to_other = v.orthographic ? -v.forward : v.origin - position;
}
#else
#include "passes/picture/camera_range.glsl"

out vec3 surface_to_other; // the camera

void set_place(vec3 position) {
    surface_to_other = camera.orthographic ? -camera.forward : camera.origin - position;
    gl_Position = camera.world_to_clip * vec4(position, 1.0);
    cut_by_range(gl_Position);
}
#endif

#ifdef HAS_MAPPINGS
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
#else
void set_mapped_uv(vec2 uv) {
}
#endif

layout(location = ATTRIBUTE_POSITION) in vec3 position;
layout(location = ATTRIBUTE_NORMAL) in vec3 normal;
layout(location = ATTRIBUTE_UV) in vec2 uv;
layout(location = ATTRIBUTE_COLOR) in vec4 color;

out vec3 surface_normal, surface_position;
out vec2 surface_uv;
out vec4 surface_color;

void main() {
    set_place(position);
    set_mapped_uv(uv);
    surface_normal = normal;
    surface_position = position;
    surface_uv = uv;
    surface_color = color;
}
