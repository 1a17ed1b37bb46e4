// One triangle over the whole viewport. LAYERS: in each layer, so that instance i draws into layer first_layer + i.
#ifdef LAYERS
#extension GL_ARB_shader_viewport_layer_array : require
#include "shared/bindings.h"

layout(location = LOCATION_FIRST_LAYER) uniform int first_layer;

flat out int instance;
#endif

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    gl_Position = vec4(corner, 0.0, 1.0);
#ifdef LAYERS
    gl_Layer = first_layer + gl_InstanceID;
    instance = gl_InstanceID;
#endif
}
