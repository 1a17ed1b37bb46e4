// Point i becomes a VPL: it reflects the irradiance that it has from its patch, flux = albedo E A.
#include "lib/vpl_input.glsl" // flux: the albedo
#include "lib/vpl_output.glsl"
#include "shared/bounce.h"

layout(binding = UNIT_IRRADIANCE) uniform sampler2D rows;

void main() {
    vpl v = vpl_input();
    vec3 irradiance = vec3(0.0);
    for (int row = 0; row < BOUNCE_ROWS; row++)
        irradiance += texelFetch(rows, ivec2(gl_VertexID, row), 0).rgb;
    v.flux *= irradiance * v.area;
    v.reach = dot(v.flux, vec3(1.0)) > 0.0 ? 1.0 : 0.0;
    vpl_output(v);
}
