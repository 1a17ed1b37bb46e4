// A tree over VPLs, to be read.
#include "lib/vpl_tree.glsl"

layout(binding = UNIT_TREE_NODES) uniform sampler2DArray tree_rows;

vec4 tree_row(int node, int row) {
    return texelFetch(tree_rows, tree_texel(node, row), 0);
}

tree_node tree_node_at(int node) {
    return tree_node_of_rows(tree_row(node, TREE_LOW), tree_row(node, TREE_HIGH), tree_row(node, TREE_CONE),
                             tree_row(node, TREE_FLUX));
}
