// Vertex i becomes the paraboloid view from VPL first + i: a light without extent. What is nearer than the
// next VPL may be left out, but no more. A VPL lies on a facet whose normal is not its own: on a round surface
// it needs twice the near clip of a VAL to be clear of the facets around.
#include "passes/visibility/map_view_output.glsl"
#include "lib/direction.glsl"
#include "lib/vpl_input.glsl"
#include "lib/vpl_sums.glsl"
#include "shared/maps.h"

PASS_BLOCK(vpl_views_params, 32)

void main() {
    vpl v = vpl_input();
    float z_far = farthest_corner(v.position, params.bounds_min, params.bounds_max);
    float near = min(2.0 * params.near_clip * vpl_spread(), sqrt(v.area));
    map_view_output(map_view(v.position, z_far, v.normal, 0.0,
                             perpendicular(v.normal), near));
}
