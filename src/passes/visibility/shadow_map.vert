// Depth of the opaque casters from the lights.
#include "lib/light_target.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;

void main() {
    gl_Position = light_view_at(target_view()).view.world_to_clip * vec4(position, 1.0);
}
