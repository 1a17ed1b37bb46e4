// Instance i of a draw goes to layer i of one kind of maps.
#extension GL_ARB_shader_viewport_layer_array : require
#include "lib/light.glsl"

layout(location = LOCATION_FIRST_VIEW) uniform int first_view; // of that kind

int target_view() {
    gl_Layer = gl_InstanceID;
    return first_view + gl_InstanceID;
}
