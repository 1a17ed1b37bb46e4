// One triangle over the map of each view from a light.
#include "lib/light_target.glsl"

flat out int view_index;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    gl_Position = vec4(corner, 0.0, 1.0);
    view_index = target_view();
}
