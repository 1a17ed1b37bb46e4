// A level of the tree: with LEAVES the VPLs by their keys, else what holds two nodes of the level below.
#include "passes/lights/tree_keys.glsl"
#include "lib/vpl_texels.glsl"
#include "lib/vpl_tree.glsl"

layout(local_size_x = TREE_GROUP) in;
layout(rgba32f, binding = IMAGE_TREE_NODES) uniform image2DArray tree_images;

// First node of the level, and how many there are.
layout(location = LOCATION_TREE_STEP) uniform ivec4 tree_step;

const float PI = 3.14159265;
// Cones are wider by so much than rounding makes them narrower.
const float ROUNDING = 1e-5;

void store(int node, tree_node n) {
    imageStore(tree_images, tree_texel(node, TREE_LOW), vec4(n.extent.low, n.near2));
    imageStore(tree_images, tree_texel(node, TREE_HIGH), vec4(n.extent.high, n.area));
    imageStore(tree_images, tree_texel(node, TREE_CONE), vec4(n.extent.axis, n.extent.cosine));
    imageStore(tree_images, tree_texel(node, TREE_FLUX), vec4(n.flux, n.power));
}

#ifdef LEAVES
tree_node make_node(int node) {
    uint i = tree_keys[node - tree_step.x].z;
    tree_node none = tree_node(tree_extent(vec3(1e30), vec3(-1e30), vec3(0.0, 0.0, 1.0), 1.0), 1e30, 1e30,
                               vec3(0.0), 0.0);
    if (i >= uint(params.vpl_count))
        return none;
    vpl light = vpl_at(int(i));
    if (light.reach <= 0.0)
        return none;
    return tree_node(tree_extent(light.position, light.position, light.normal, 1.0 - ROUNDING),
                     light.reach * light.reach * light.area, light.area, light.flux,
                     dot(light.flux, vec3(1.0)));
}
#else
tree_node load(int node) {
    return tree_node_of_rows(imageLoad(tree_images, tree_texel(node, TREE_LOW)),
                             imageLoad(tree_images, tree_texel(node, TREE_HIGH)),
                             imageLoad(tree_images, tree_texel(node, TREE_CONE)),
                             imageLoad(tree_images, tree_texel(node, TREE_FLUX)));
}

// The narrowest cone that holds both: its axis lies between theirs.
void merge_cones(inout tree_extent a, tree_extent b) {
    float apart = atan(length(cross(a.axis, b.axis)), dot(a.axis, b.axis));
    float half_a = acos(a.cosine), half_b = acos(b.cosine), half_angle = 0.5 * (apart + half_a + half_b);
    if (apart + half_b <= half_a)
        return;
    if (apart + half_a <= half_b) {
        a.axis = b.axis;
        a.cosine = b.cosine;
        return;
    }
    vec3 across = b.axis - a.axis * dot(a.axis, b.axis);
    if (half_angle >= PI || dot(across, across) < 1e-10) {
        a.cosine = half_angle >= PI || apart > 1.0 ? -1.0 : min(a.cosine, b.cosine) - ROUNDING;
        return;
    }
    float turn = half_angle - half_a;
    a.axis = normalize(a.axis * cos(turn) + normalize(across) * sin(turn));
    a.cosine = max(cos(half_angle) - ROUNDING, -1.0);
}

tree_node make_node(int node) {
    tree_node a = load(2 * node), b = load(2 * node + 1);
    if (b.power == 0.0)
        return a;
    if (a.power == 0.0)
        return b;
    a.extent.low = min(a.extent.low, b.extent.low);
    a.extent.high = max(a.extent.high, b.extent.high);
    merge_cones(a.extent, b.extent);
    a.near2 = min(a.near2, b.near2);
    a.area = min(a.area, b.area);
    a.flux += b.flux;
    a.power += b.power;
    return a;
}
#endif

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < tree_step.y)
        store(tree_step.x + i, make_node(tree_step.x + i));
}
