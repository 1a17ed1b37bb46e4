// The cuts of a block of pixels, a coarse and a finer one: nodes that stand for every VPL once, of which the one with the
// greatest bound is split while there is room, and until none is off by more than the tolerance at any of the block's
// points.
#include "lib/gbuffer.glsl"
#include "lib/vpl_texels.glsl"
#include "lib/vpl_tree.glsl"
#include "passes/gather/cut_bound.glsl"
#include "shared/gather.h"

PASS_BLOCK(vpl_cut_params, 32)

layout(local_size_x = CUT_GROUP, local_size_y = CUT_GROUP) in;
layout(r32ui, binding = IMAGE_CUTS) writeonly uniform uimage2DArray cuts;
layout(binding = UNIT_TREE_REPRESENTATIVES) uniform usampler2DArray tree_representatives;

int nodes[CUT_NODES_MAX];
float bounds[CUT_NODES_MAX], estimates[CUT_NODES_MAX];

// The box of the block's points and the cone of their normals; the mean of them. False where it sees nothing.
bool block_extent(ivec2 block, out tree_extent extent, out tree_extent middle) {
    ivec2 first = block * params.block, end = min(first + params.block, gbuffer_size());
    vec3 place = vec3(0.0), normal = vec3(0.0);
    float count = 0.0;
    extent = tree_extent(vec3(1e30), vec3(-1e30), vec3(0.0, 0.0, 1.0), 1.0);
    for (int y = first.y; y < end.y; y++)
        for (int x = first.x; x < end.x; x++) {
            surface s = gbuffer_surface(ivec2(x, y));
            if (!s.present)
                continue;
            extent.low = min(extent.low, s.position);
            extent.high = max(extent.high, s.position);
            place += s.position;
            normal += s.normal;
            count += 1.0;
        }
    if (count == 0.0)
        return false;
    extent.axis = dot(normal, normal) > 1e-6 ? normalize(normal) : extent.axis;
    for (int y = first.y; y < end.y; y++)
        for (int x = first.x; x < end.x; x++) {
            surface s = gbuffer_surface(ivec2(x, y));
            if (s.present)
                extent.cosine = min(extent.cosine, dot(extent.axis, s.normal));
        }
    extent.cosine = max(extent.cosine - CUT_ROUNDING, -1.0);
    middle = tree_extent(place / count, place / count, extent.axis, 1.0);
    return true;
}

// What a node gives in the block's middle if nothing hides it.
float estimate(tree_extent middle, int node, float power) {
    vpl light = vpl_at(int(texelFetch(tree_representatives, tree_texel(node, 0), 0).r));
    tree_node point = tree_node(tree_extent(light.position, light.position, light.normal, 1.0),
                                light.reach * light.reach * light.area, light.area, light.flux, power);
    return power * cut_bound(middle, point, params.clamp_at);
}

// Puts a node at a place of the cut; returns what it gives.
float place_node(int at, int node, tree_node n, tree_extent extent, tree_extent middle) {
    nodes[at] = node;
    bounds[at] = node < params.leaves ? n.power * cut_bound(extent, n, params.clamp_at) : 0.0;
    estimates[at] = estimate(middle, node, n.power);
    return estimates[at];
}

int greatest(int count) {
    int found = 0;
    for (int i = 1; i < count; i++)
        if (bounds[i] > bounds[found])
            found = i;
    return found;
}

struct cut_state {
    int count;
    float sum; // of what the nodes give
};

// Splits nodes until there are so many, or none needs to be.
void refine(inout cut_state cut, int most, tree_extent extent, tree_extent middle) {
    while (cut.count < most) {
        int at = greatest(cut.count), node = nodes[at];
        if (bounds[at] <= params.tolerance * cut.sum)
            return;
        tree_node left = tree_node_at(2 * node), right = tree_node_at(2 * node + 1);
        cut.sum -= estimates[at];
        cut.sum += place_node(at, 2 * node, left, extent, middle);
        if (right.power > 0.0)
            cut.sum += place_node(cut.count++, 2 * node + 1, right, extent, middle);
    }
}

void store(ivec2 block, int layer, int count) {
    imageStore(cuts, ivec3(block, layer), uvec4(count));
    for (int i = 0; i < count; i++)
        imageStore(cuts, ivec3(block, layer + i + 1), uvec4(nodes[i]));
}

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(block, params.blocks)))
        return;
    tree_extent extent, middle;
    tree_node root = tree_node_at(1);
    cut_state cut = cut_state(0, 0.0);
    if (block_extent(block, extent, middle) && root.power > 0.0)
        cut = cut_state(1, place_node(0, 1, root, extent, middle));
    if (cut.count > 0)
        refine(cut, params.nodes, extent, middle);
    store(block, 0, cut.count);
    if (cut.count > 0)
        refine(cut, params.more_nodes, extent, middle);
    store(block, params.nodes + 1, cut.count);
}
