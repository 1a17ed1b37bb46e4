// What path i has left becomes VPL i.
#include "lights/bounce_paths.glsl"
#include "lib/vpl_output.glsl"

layout(binding = UNIT_PATH_AREAS) uniform sampler2D path_areas;

void main() {
    int i = gl_VertexID;
    float area = texelFetch(path_areas, ivec2(i, 0), 0).x;
    vpl_output(vpl(path_position(i), 0.0, path_normal(i), area, path_flux(i), path_power(i) > 0.0 ? 1.0 : 0.0));
}
