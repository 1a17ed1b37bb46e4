// Pixel i of the rows, as a VPL without flux: its surface is what the row's map is seen from. Where the pixel sees
// nothing, the normal is 0, and no light arrives.
#include "lib/gbuffer.glsl"
#include "lib/vpl_output.glsl"

layout(location = ATTRIBUTE_ROW_PLACE) in vec2 place; // of the picture, from 0 to 1

void main() {
    surface s = gbuffer_surface(min(ivec2(place * vec2(gbuffer_size())), gbuffer_size() - 1));
    vec3 normal = s.present ? s.normal : vec3(0.0);
    // Any area: what is too near for a map is then told by the spread of the VPLs alone.
    vpl_output(vpl_even(s.present ? s.position : vec3(0.0), normal, 1e30, vec3(0.0), 0.0));
}
