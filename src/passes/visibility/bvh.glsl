// Whether a triangle of the scene lies between two points: boxes are entered in one order, and each says where to go on
// past it (scene/mesh/stackless_bvh.h).
#include "shared/bindings.h"
#include "shared/bvh.h"

layout(binding = UNIT_BVH) uniform usamplerBuffer bvh;

const float BVH_FAR = 1e30;

struct bvh_ray {
    vec3 origin, direction;
    float end;                  // of the direction's length
    vec3 box_origin, box_slope; // in steps of boxes; 1 / the direction
};

vec3 bvh_vector(int texel) {
    return uintBitsToFloat(texelFetch(bvh, texel).xyz);
}

bool enters(bvh_ray ray, uvec3 sides) {
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

// [Möller and Trumbore 1997]. Where, in lengths of the direction; the ray's end: it does not.
float met_at(bvh_ray ray, int texel) {
    uvec4 first = texelFetch(bvh, texel), second = texelFetch(bvh, texel + 1);
    vec3 corner = uintBitsToFloat(first.xyz), edge = uintBitsToFloat(second.xyz);
    vec3 other_edge = uintBitsToFloat(texelFetch(bvh, texel + 2).xyz);
    vec3 across = cross(ray.direction, other_edge), from = ray.origin - corner, other = cross(from, edge);
    float inverse = 1.0 / dot(edge, across);
    float u = dot(from, across) * inverse, v = dot(ray.direction, other) * inverse;
    float at = dot(other_edge, other) * inverse;
    bool met = min(u, v) >= 0.0 && u + v <= 1.0 && at > 0.0 && at < ray.end;
    return met && is_opaque(vec2(u, v), uvec2(first.w, second.w)) ? at : ray.end;
}

float bvh_clearance() {
    return uintBitsToFloat(texelFetch(bvh, 1).w);
}

bvh_ray bvh_ray_along(vec3 origin, vec3 direction, float end) {
    vec3 low = bvh_vector(0), steps = bvh_vector(1), along = direction * steps;
    return bvh_ray(origin, direction, end, (origin - low) * steps,
                    1.0 / mix(along, vec3(1e-20), lessThan(abs(along), vec3(1e-20))));
}

// Texel after the last box.
int bvh_end() {
    return int(texelFetch(bvh, 0).w);
}

// On to a leaf that the ray enters, which is its box's number; 0: there is none before the end. A software rasteriser
// tests triangles for all pixels as soon as one of them has some.
uint bvh_leaf(bvh_ray ray, inout int box, int end) {
    uint leaf = 0u;
    while (box < end && leaf == 0u) {
        uvec4 node = texelFetch(bvh, box);
        bool is_leaf = node.w >= STACKLESS_LEAF, entered = enters(ray, node.xyz);
        leaf = is_leaf && entered ? node.w : 0u;
        box = is_leaf || entered ? box + 1 : int(node.w);
    }
    return leaf;
}

int leaf_count(uint leaf) {
    return int(leaf >> STACKLESS_COUNT_SHIFT & STACKLESS_COUNT_MOST);
}

int leaf_texel(uint leaf) {
    return int(leaf & ((1u << STACKLESS_COUNT_SHIFT) - 1u));
}

// Whether the ray meets any triangle; not where `asks` is false.
bool bvh_meets_any(bvh_ray ray, bool asks) {
    int box = STACKLESS_HEADER, end = asks ? bvh_end() : 0;
    bool blocked = false;
    while (box < end) {
        uint leaf = bvh_leaf(ray, box, end);
        int count = leaf_count(leaf), texel = leaf_texel(leaf);
        for (int i = 0; i < count && !blocked; i++)
            blocked = met_at(ray, texel + i * STACKLESS_TRIANGLE) < ray.end;
        box = blocked ? end : box;
    }
    return blocked;
}

// Between a point of a surface and one of another surface; never where they are one.
bool is_blocked(vec3 from, vec3 normal, vec3 to) {
    float clearance = bvh_clearance(), way = distance(from, to);
    vec3 origin = from + clearance * normal;
    return bvh_meets_any(bvh_ray_along(origin, to - origin, 1.0 - clearance / way), way > clearance);
}

// From a point of a surface to infinity.
bool is_blocked_towards(vec3 from, vec3 normal, vec3 direction, bool asks) {
    return bvh_meets_any(bvh_ray_along(from + bvh_clearance() * normal, direction, BVH_FAR), asks);
}

// What a ray meets first.
struct bvh_hit {
    float distance;
    int triangle;    // its number in the geometry; -1: there is none
    vec3 normal;     // unit, of the side that is met
    bool back;
};

// Along a unit direction; not where `asks` is false.
bvh_hit bvh_meet(vec3 origin, vec3 direction, bool asks) {
    bvh_ray ray = bvh_ray_along(origin, direction, BVH_FAR);
    int box = STACKLESS_HEADER, end = asks ? bvh_end() : 0, met = 0;
    while (box < end) {
        uint leaf = bvh_leaf(ray, box, end);
        int count = leaf_count(leaf), texel = leaf_texel(leaf);
        for (int i = 0; i < count; i++) {
            float at = met_at(ray, texel + i * STACKLESS_TRIANGLE);
            met = at < ray.end ? texel + i * STACKLESS_TRIANGLE : met;
            ray.end = at;
        }
    }
    vec3 normal = normalize(cross(bvh_vector(met + 1), bvh_vector(met + 2)));
    bool back = dot(normal, direction) > 0.0;
    return bvh_hit(ray.end, met > 0 ? int(texelFetch(bvh, met + 2).w) : -1, back ? -normal : normal, back);
}
