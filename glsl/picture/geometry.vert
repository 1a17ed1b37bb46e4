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
#include "picture/camera_range.glsl"

out vec3 surface_to_other; // the camera

void set_place(vec3 position) {
    surface_to_other = camera.orthographic ? -camera.forward : camera.origin - position;
    gl_Position = camera.world_to_clip * vec4(position, 1.0);
    cut_by_range(gl_Position);
}
#endif

#ifdef HAS_MAPPINGS
#include "picture/mapped_uv.glsl"
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
