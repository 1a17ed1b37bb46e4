// The lights of a pixel are those of its block's cut: each is the VPL that stands for its node in the pixel's set, with as
// much flux as all have, of its own colour. The mean over sets is then right for each colour.
#include "lib/divide.glsl"
#include "lib/vpl_texels.glsl"
#include "lib/vpl_tree_nodes.glsl"
#include "shared/gather.h"

layout(binding = UNIT_CUTS) uniform usampler2DArray cuts;
layout(binding = UNIT_TREE_REPRESENTATIVES) uniform usampler2DArray tree_representatives;

ivec3 cut_texel;

// A cut has a layer with its count, and then its nodes.
ivec2 lights_of(ivec2 pixel) {
    cut_texel = ivec3(divide(pixel, ivec2(params.cut_block)), params.cut_layer);
    return ivec2(0, int(texelFetch(cuts, cut_texel, 0).r));
}

vpl light_at(int i) {
    int node = int(texelFetch(cuts, cut_texel + ivec3(0, 0, i + 1), 0).r);
    vpl light = vpl_at(int(texelFetch(tree_representatives, tree_texel(node, slot.x), 0).r));
    light.flux *= tree_row(node, TREE_FLUX).w / max(dot(light.flux, vec3(1.0)), 1e-30);
    return light;
}
