// What panes let pass of light that goes straight on: blended surfaces and glass, in a tree of their own
// (scene/mesh/pane_triangles.h), which scene/mesh/stackless_bvh.h lays out.
#include "shared/bindings.h"
#include "shared/bvh.h"
#include "shared/panes.h"

layout(binding = UNIT_PANES) uniform usamplerBuffer panes;

// A plate between parallel faces with all reflections within, or one face of a solid, where the index is negative:
// scene/material.c has the same.
float plate_passes(float coded, float cosine) {
    float index = abs(coded), within = sqrt(max(1.0 - (1.0 - cosine * cosine) / (index * index), 0.0));
    vec2 amplitude = vec2((cosine - index * within) / (cosine + index * within),
                          (index * cosine - within) / (index * cosine + within));
    vec2 reflected = amplitude * amplitude, passes = (1.0 - reflected) / (1.0 + reflected);
    float plate = 0.5 * (passes.x + passes.y);
    return coded < 0.0 ? sqrt(plate) : plate;
}

// [Möller and Trumbore 1997]
vec3 pane_passes(int texel, vec3 origin, vec3 direction, float end) {
    uvec4 first = texelFetch(panes, texel), second = texelFetch(panes, texel + 1), third = texelFetch(panes, texel + 2);
    vec3 edge = uintBitsToFloat(second.xyz), other_edge = uintBitsToFloat(third.xyz);
    vec3 across = cross(direction, other_edge), from = origin - uintBitsToFloat(first.xyz), other = cross(from, edge);
    float inverse = 1.0 / dot(edge, across);
    float u = dot(from, across) * inverse, v = dot(direction, other) * inverse;
    float at = dot(other_edge, other) * inverse;
    bool met = min(u, v) >= 0.0 && u + v <= 1.0 && at > 0.0 && at < end;
    uvec3 packed_color = third.www >> uvec3(0u, PANE_COLOR_BITS, 2 * PANE_COLOR_BITS) & uint(PANE_COLOR_MOST);
    float cosine = max(abs(dot(normalize(cross(edge, other_edge)), direction)), 1e-3);
    vec3 glass = vec3(packed_color) / float(PANE_COLOR_MOST) * plate_passes(uintBitsToFloat(second.w), cosine);
    return met ? uintBitsToFloat(first.w) + glass : vec3(1.0);
}

// Along a unit direction, so many metres.
vec3 panes_pass(vec3 origin, vec3 direction, float end) {
    uvec4 header = texelFetch(panes, 0);
    vec3 steps = uintBitsToFloat(texelFetch(panes, 1).xyz), along = direction * steps;
    vec3 place = (origin - uintBitsToFloat(header.xyz)) * steps;
    vec3 slope = 1.0 / mix(along, vec3(1e-20), lessThan(abs(along), vec3(1e-20))), passes = vec3(1.0);
    for (int box = STACKLESS_HEADER; box < int(header.w);) {
        uvec4 node = texelFetch(panes, box);
        vec3 a = (vec3(node.xyz & 0xffffu) - place) * slope, b = (vec3(node.xyz >> 16) - place) * slope;
        vec3 low = min(a, b), high = max(a, b);
        bool is_leaf = node.w >= STACKLESS_LEAF;
        bool enters = max(max(low.x, low.y), max(low.z, 0.0)) <= min(min(high.x, high.y), min(high.z, end));
        int count = is_leaf && enters ? int(node.w >> STACKLESS_COUNT_SHIFT & STACKLESS_COUNT_MOST) : 0;
        int texel = int(node.w & ((1u << STACKLESS_COUNT_SHIFT) - 1u));
        for (int i = 0; i < count; i++)
            passes *= pane_passes(texel + i * STACKLESS_TRIANGLE, origin, direction, end);
        box = is_leaf || enters ? box + 1 : int(node.w);
    }
    return passes;
}
