// Each VPL is a point that finds its nearest VAL and lands on that VAL's pixel, where additive blending
// sums up what belongs together [Dong 2009 §6].
#include "lights/val_distance.glsl"
#include "lib/vpl_input.glsl"
#if WEIGHTED
#include "lights/vpl_weight.glsl"
#endif

flat out vec3 point_position, point_normal, point_flux;
flat out float point_weight;

void main() {
    vpl v = vpl_input();
    point_position = v.position;
    point_normal = v.normal;
    point_flux = v.flux;
#if METRIC == CLUSTER_METRIC_SQUARES
    point_weight = dot(v.flux, vec3(1.0));
#elif WEIGHTED
    point_weight = vpl_weight(gl_VertexID, v);
#else
    point_weight = 1.0;
#endif
    gl_Position = v.reach > 0.0 ? val_pixel(nearest_val(v)) : vec4(0.0, 0.0, 2.0, 1.0);
}
