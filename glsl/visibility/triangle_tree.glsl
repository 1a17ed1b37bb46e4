// Whether a triangle of the scene lies between two points: boxes are entered in one order, and each says where to go on
// past it (scene/mesh/threaded_tree.h).
#include "shared/bindings.h"
#include "shared/triangle_tree.h"

layout(binding = UNIT_TRIANGLE_TREE) uniform usamplerBuffer triangle_tree;

struct tree_ray {
    vec3 origin, direction;
    float end;                  // of the direction's length
    vec3 box_origin, box_slope; // in steps of boxes; 1 / the direction
};

bool enters(tree_ray ray, uvec3 sides) {
    vec3 a = (vec3(sides & 0xffffu) - ray.box_origin) * ray.box_slope;
    vec3 b = (vec3(sides >> 16) - ray.box_origin) * ray.box_slope;
    vec3 first = min(a, b), last = max(a, b);
    return max(max(first.x, first.y), max(first.z, 0.0)) <= min(min(last.x, last.y), min(last.z, ray.end));
}

// Whether the part of the triangle there is opaque [Gruen et al. 2020].
bool is_opaque(vec2 at, uvec2 bits) {
    vec2 scaled = at * float(OPACITY_SIDE), cell = min(floor(scaled), float(OPACITY_SIDE - 1)), part = scaled - cell;
    int along = int(cell.x), row = int(cell.y), turned = part.x + part.y > 1.0 ? 1 : 0;
    int number = row * (2 * OPACITY_SIDE - row) + 2 * along + turned;
    return ((number < 32 ? bits.x : bits.y) >> (number & 31) & 1u) != 0u;
}

// [Möller and Trumbore 1997].
bool meets(tree_ray ray, int texel) {
    uvec4 first = texelFetch(triangle_tree, texel), second = texelFetch(triangle_tree, texel + 1);
    vec3 corner = uintBitsToFloat(first.xyz), edge = uintBitsToFloat(second.xyz);
    vec3 other_edge = uintBitsToFloat(texelFetch(triangle_tree, texel + 2).xyz);
    vec3 across = cross(ray.direction, other_edge), from = ray.origin - corner, other = cross(from, edge);
    float inverse = 1.0 / dot(edge, across);
    float u = dot(from, across) * inverse, v = dot(ray.direction, other) * inverse;
    float at = dot(other_edge, other) * inverse;
    return min(u, v) >= 0.0 && u + v <= 1.0 && at > 0.0 && at < ray.end && is_opaque(vec2(u, v), uvec2(first.w, second.w));
}

// Between a point of a surface and one of another surface; never where they are one.
bool is_blocked(vec3 from, vec3 normal, vec3 to) {
    uvec4 header = texelFetch(triangle_tree, 0), other_header = texelFetch(triangle_tree, 1);
    vec3 steps = uintBitsToFloat(other_header.xyz);
    float clearance = uintBitsToFloat(other_header.w);
    tree_ray ray;
    ray.origin = from + clearance * normal;
    ray.direction = to - ray.origin;
    float way = distance(from, to);
    ray.end = 1.0 - clearance / way;
    vec3 along = ray.direction * steps;
    ray.box_origin = (ray.origin - uintBitsToFloat(header.xyz)) * steps;
    ray.box_slope = 1.0 / mix(along, vec3(1e-20), lessThan(abs(along), vec3(1e-20)));
    int box = THREADED_HEADER, end = way > clearance ? int(header.w) : 0;
    bool blocked = false;
    while (box < end) {
        // On to a leaf: a software rasteriser tests triangles for all pixels as soon as one of them has some.
        uint leaf = 0u;
        while (box < end && leaf == 0u) {
            uvec4 node = texelFetch(triangle_tree, box);
            bool is_leaf = node.w >= THREADED_LEAF, entered = enters(ray, node.xyz);
            leaf = is_leaf && entered ? node.w : 0u;
            box = is_leaf || entered ? box + 1 : int(node.w);
        }
        int count = int(leaf >> THREADED_COUNT_SHIFT & THREADED_COUNT_MOST);
        int texel = int(leaf & ((1u << THREADED_COUNT_SHIFT) - 1u));
        for (int i = 0; i < count && !blocked; i++)
            blocked = meets(ray, texel + i * THREADED_TRIANGLE);
        box = blocked ? end : box;
    }
    return blocked;
}
