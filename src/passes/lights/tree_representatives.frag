// For each node and set of pixels the VPL that stands for all: chosen by flux, evenly over the sets.
#include "passes/lights/tree_keys.glsl"
#include "lib/vpl_tree.glsl"

flat in int instance;

layout(location = TARGET_RESULT) out uint representative;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int node = texel.y * TREE_COLUMNS + texel.x;
    // Radical inverses, shifted from node to node by a lattice.
    float number = fract(float(bitfieldReverse(uint(instance))) / 4294967296.0 + float(node) * 0.6180339887);
    representative = 0u;
    if (node < 1 || node >= 2 * params.leaves)
        return;
    while (node < params.leaves) {
        float first = tree_row(2 * node, TREE_FLUX).w, all = tree_row(node, TREE_FLUX).w;
        float share = all > 0.0 ? first / all : 1.0;
        bool left = number < share;
        number = clamp(left ? number / share : (number - share) / (1.0 - share), 0.0, 0.9999999);
        node = 2 * node + (left ? 0 : 1);
    }
    representative = tree_keys[node - params.leaves].z;
}
