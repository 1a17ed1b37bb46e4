// Each instance of a draw goes to the layer of its view.
#extension GL_ARB_shader_viewport_layer_array : require
#include "lib/light.glsl"

layout(location = LOCATION_FIRST_VIEW) uniform int first_view; // of the draw

int target_view() {
    int k = first_view + gl_InstanceID;
    gl_Layer = light_view_at(k).layer;
    return k;
}
