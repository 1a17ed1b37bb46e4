// What path i of row 0 has left becomes VPL i, with its share of the light of all.
#include "passes/lights/bounce_paths.glsl"
#include "lib/vpl_output.glsl"

layout(binding = UNIT_PATH_RESULTS) uniform sampler2D shared_fluxes; // of each row's paths

void main() {
    int i = gl_VertexID;
    vec3 flux = vec3(0.0);
    for (int row = 0; row < BOUNCE_ROWS; row++)
        flux += texelFetch(shared_fluxes, ivec2(i, row), 0).rgb;
    // A surface that reflects no red sends none, whatever those near it do.
    vec3 own = path_flux(ivec2(i, 0));
    flux = mix(vec3(0.0), flux, greaterThan(own, vec3(0.0)));
    vpl_output(vpl_even(path_position(i), path_normal(i), path_area(i), flux, path_power(i) > 0.0 ? 1.0 : 0.0));
}
