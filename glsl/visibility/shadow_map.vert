// Depth of the opaque casters from the light; instance i draws the light's i-th view.
#extension GL_ARB_shader_viewport_layer_array : require
#include "lib/light.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;

void main() {
    gl_Position = light.views[gl_InstanceID].world_to_clip * vec4(position, 1.0);
    gl_Layer = gl_InstanceID;
}
