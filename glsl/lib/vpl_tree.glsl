// A tree over VPLs, and its nodes.
#include "shared/vpl.h"

// A box of places and a cone of normals.
struct tree_extent {
    vec3 low, high, axis;
    float cosine; // of the cone's half angle; -1: all directions
};

struct tree_node {
    tree_extent extent;
    float near2, area;
    vec3 flux;
    float power;
};

ivec3 tree_texel(int node, int row) {
    return ivec3(node % TREE_COLUMNS, node / TREE_COLUMNS, row);
}

tree_node tree_node_of_rows(vec4 low, vec4 high, vec4 cone, vec4 flux) {
    return tree_node(tree_extent(low.xyz, high.xyz, cone.xyz, cone.w), low.w, high.w, flux.rgb, flux.w);
}

layout(binding = UNIT_TREE_NODES) uniform sampler2DArray tree_rows;

vec4 tree_row(int node, int row) {
    return texelFetch(tree_rows, tree_texel(node, row), 0);
}

tree_node tree_node_at(int node) {
    return tree_node_of_rows(tree_row(node, TREE_LOW), tree_row(node, TREE_HIGH), tree_row(node, TREE_CONE),
                             tree_row(node, TREE_FLUX));
}
