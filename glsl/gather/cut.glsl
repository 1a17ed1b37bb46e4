// The lights of a pixel are those of its block's cut: each from the place of the VPL that stands for its node in the
// pixel's set, with the flux of all.
#include "lib/vpl_texels.glsl"
#include "lib/vpl_tree_nodes.glsl"

layout(binding = UNIT_CUTS) uniform usampler2DArray cuts; // a layer with their counts, then nodes
layout(binding = UNIT_TREE_PICKS) uniform usampler2DArray tree_picks;

ivec2 cut_block;

// Returns how many there are.
int cut_open(ivec2 pixel, int block) {
    cut_block = pixel / block;
    return int(texelFetch(cuts, ivec3(cut_block, 0), 0).r);
}

vpl cut_light(int i, int set) {
    int node = int(texelFetch(cuts, ivec3(cut_block, i + 1), 0).r);
    vpl light = vpl_at(int(texelFetch(tree_picks, tree_texel(node, set), 0).r));
    light.flux = tree_row(node, TREE_FLUX).rgb;
    return light;
}
