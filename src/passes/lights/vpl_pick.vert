// Vertex i becomes a VPL: one of a run of candidates that lie side by side, chosen by flux, with the flux of all of them. Runs
// follow a curve over the surfaces, so VPLs lie evenly there, from whatever lights they come.
#include "lib/random.glsl"
#include "lib/vpl_output.glsl"
#include "lib/vpl_texels.glsl"
#include "lib/weighted_pick.glsl"

layout(binding = UNIT_VPL_KEYS) uniform usamplerBuffer keys; // passes/vpl_sort.h

layout(location = LOCATION_TREE_STEP) uniform ivec4 step; // candidates of a run; VPLs; runs between two VPLs; index of the pass

void main() {
    int run = int(uint(gl_VertexID) * uint(step.z) % uint(step.y));
    float sum = 0.0, taken = 0.0, random = random_of(uvec3(gl_VertexID, step.w, 0)).x;
    vpl chosen = vpl_even(vec3(0.0), vec3(0.0, 1.0, 0.0), 0.0, vec3(0.0), 0.0);
    for (int k = 0; k < step.x; k++) {
        vpl candidate = vpl_at(int(texelFetch(keys, run * step.x + k).z));
        float weight = dot(candidate.flux, vec3(1.0));
        sum += weight;
        if (weighted_pick(weight, sum, random)) {
            chosen = candidate;
            taken = weight;
        }
    }
    chosen.flux *= sum / max(taken * float(step.x), 1e-30);
    vpl_output(chosen);
}
