// Each VPL adds how far it is from its probe, weighted by flux. Normals count more than where clusters are formed:
// across a flat surface one map sees almost what another sees, and beyond a fold it sees something else. But a few
// that have strayed onto another wall count little, or the number of VALs would jump as light comes there.
#include "lights/val_distance.glsl"
#include "lib/vpl_input.glsl"

flat out vec2 distance_and_weight;

void main() {
    vpl v = vpl_input();
    int k = nearest_val(v);
    float weight = dot(v.flux, vec3(1.0)), scale = position_weight();
    float apart = scale * distance(v.position, texelFetch(val_positions, ivec2(k, 0), 0).xyz);
    float turned = val_distance(scale, v, k) - apart;
    float folded = VAL_FOLDED_MOST * (1.0 - exp(-turned * VAL_FOLDS / VAL_FOLDED_MOST));
    distance_and_weight = vec2(weight * (apart + folded), weight);
    gl_Position = v.reach > 0.0 ? vec4(0.0, 0.0, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
