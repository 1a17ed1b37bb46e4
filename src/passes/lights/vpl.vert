// Vertex i becomes VPL i: a place of a light's domain, and what the light reflects there.
#include "passes/lights/vpl_reflected.glsl"
#include "lib/vpl_output.glsl"
#include "lib/vpl_shares.glsl"
#ifdef BY_IMPORTANCE
#include "passes/lights/vpl_by_importance.glsl"
#else
#include "passes/lights/vpl_density.glsl"

// By flux: points know their light (passes/lights/vpl.c).
float vpl_choose(vec3 point, out int index, out vec2 place) {
    index = int(point.z);
    place = point.xy;
    return 1.0;
}
#endif

layout(location = ATTRIBUTE_VPL_POINT) in vec3 halton_and_light;

void main() {
    int index;
    vec2 place;
    float density = vpl_choose(halton_and_light, index, place);
    vpl_share share = vpl_share_at(index);
    vpl v = vpl_reflected(index, gl_VertexID, share.measure, place);
    v.reach = dot(v.flux, vec3(1.0)) > 0.0 ? share.reach : 0.0;
    v.flux /= density;
    v.area = vpl_dense_area(v.area, density);
    vpl_output(v);
}
