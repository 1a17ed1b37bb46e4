// Draws the scene into a G-buffer: the camera's, or the lights' (the reflective shadow map).
#ifdef LIGHT_VIEW
#include "lib/light_target.glsl"
#else
#include "picture/camera_range.glsl"
#endif

layout(location = ATTRIBUTE_POSITION) in vec3 position;
layout(location = ATTRIBUTE_NORMAL) in vec3 normal;
layout(location = ATTRIBUTE_UV) in vec2 uv;
layout(location = ATTRIBUTE_COLOR) in vec4 color;

out vec3 surface_normal;
out vec2 surface_uv;
out vec4 surface_color;
#if defined(HAS_GLOSS) || defined(FACETS)
out vec3 surface_position;
#endif
#ifdef HAS_MAPPINGS
#include "picture/mapped_uv.glsl"
#endif
#ifdef FACETS
out vec3 surface_to_light;
#endif

void main() {
#ifdef LIGHT_VIEW
    view v = light_view_at(target_view()).view;
    gl_Position = v.world_to_clip * vec4(position, 1.0);
#else
    gl_Position = camera.world_to_clip * vec4(position, 1.0);
    cut_by_range(gl_Position);
#endif
    surface_normal = normal;
    surface_uv = uv;
#ifdef HAS_MAPPINGS
    set_mapped_uv(uv);
#endif
    surface_color = color;
#if defined(HAS_GLOSS) || defined(FACETS)
    surface_position = position;
#endif
#ifdef FACETS
    surface_to_light = v.orthographic ? -v.forward : v.origin - position;
#endif
}
