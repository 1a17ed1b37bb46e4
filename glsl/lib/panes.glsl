// What panes let pass of light that goes straight on: blended surfaces and glass, in a tree of their own
// (scene/mesh/pane_triangles.h), which scene/mesh/stackless_bvh.h lays out.
#include "shared/bindings.h"
#include "shared/bvh.h"

layout(binding = UNIT_PANES) uniform usamplerBuffer panes;

struct pane {
    vec3 color, normal; // unit, of the front
    float base, glass;  // shares of light that go past it, and that enter it
    float index;        // negative: one face of a solid
    bool both;          // its back reflects as its front does
};

pane pane_at(int texel) {
    uvec4 first = texelFetch(panes, texel), second = texelFetch(panes, texel + 1), third = texelFetch(panes, texel + 2);
    uvec3 color = third.www >> uvec3(0u, PANE_COLOR_BITS, 2 * PANE_COLOR_BITS) & uint(PANE_COLOR_MOST);
    vec2 shares = unpackUnorm2x16(first.w);
    return pane(vec3(color) / float(PANE_COLOR_MOST),
                normalize(cross(uintBitsToFloat(second.xyz), uintBitsToFloat(third.xyz))), shares.x, shares.y,
                uintBitsToFloat(second.w), (third.w & uint(PANE_BOTH)) != 0u);
}

// A plate between parallel faces with all reflections within, or one face of a solid: scene/material.c has the same.
float plate_passes(pane p, vec3 direction) {
    float cosine = max(abs(dot(p.normal, direction)), 1e-3), index = abs(p.index);
    float within = sqrt(max(1.0 - (1.0 - cosine * cosine) / (index * index), 0.0));
    vec2 amplitude = vec2((cosine - index * within) / (cosine + index * within),
                          (index * cosine - within) / (index * cosine + within));
    vec2 reflected = amplitude * amplitude, passes = (1.0 - reflected) / (1.0 + reflected);
    float plate = 0.5 * (passes.x + passes.y);
    return p.index < 0.0 ? sqrt(plate) : plate;
}

// What goes on of light along a unit direction, and what the pane reflects of it diffusely: of what its face lets in.
vec3 pane_passes(pane p, vec3 direction) {
    return p.base + p.glass * p.color * plate_passes(p, direction);
}

vec3 pane_albedo(pane p, vec3 direction) {
    if (!p.both && dot(p.normal, direction) >= 0.0)
        return vec3(0.0);
    return p.color * (max(1.0 - p.base - p.glass, 0.0) * (p.glass > 0.0 ? plate_passes(p, direction) : 1.0));
}

// Parts of a triangle's sides, or of a distance, that rounding makes: an edge belongs to both its triangles.
const float PANE_EDGE = 1e-5;

// [Möller and Trumbore 1997]. Where, along the direction; negative: it does not.
float pane_met_at(int texel, vec3 origin, vec3 direction, out bool on_edge) {
    vec3 edge = uintBitsToFloat(texelFetch(panes, texel + 1).xyz);
    vec3 other_edge = uintBitsToFloat(texelFetch(panes, texel + 2).xyz);
    vec3 across = cross(direction, other_edge), from = origin - uintBitsToFloat(texelFetch(panes, texel).xyz);
    vec3 other = cross(from, edge);
    float inverse = 1.0 / dot(edge, across);
    float u = dot(from, across) * inverse, v = dot(direction, other) * inverse;
    float inside = min(min(u, v), 1.0 - u - v);
    on_edge = inside < PANE_EDGE;
    return inside >= -PANE_EDGE ? dot(other_edge, other) * inverse : -1.0;
}

// What lies along a ray: what all panes let pass, and the nearest one.
struct panes_met {
    vec3 passes;
    float nearest; // the ray's end: there is none
    int texel;
};

// Along a unit direction, between two distances in metres.
panes_met panes_meet(vec3 origin, vec3 direction, float start, float end) {
    uvec4 header = texelFetch(panes, 0);
    vec3 steps = uintBitsToFloat(texelFetch(panes, 1).xyz), along = direction * steps;
    vec3 place = (origin - uintBitsToFloat(header.xyz)) * steps;
    float edge_at = -1.0; // what was met last on an edge
    vec3 slope = 1.0 / mix(along, vec3(1e-20), lessThan(abs(along), vec3(1e-20)));
    panes_met met = panes_met(vec3(1.0), end, 0);
    for (int box = STACKLESS_HEADER; box < int(header.w);) {
        uvec4 node = texelFetch(panes, box);
        vec3 a = (vec3(node.xyz & 0xffffu) - place) * slope, b = (vec3(node.xyz >> 16) - place) * slope;
        vec3 low = min(a, b), high = max(a, b);
        bool is_leaf = node.w >= STACKLESS_LEAF;
        bool enters = max(max(low.x, low.y), max(low.z, 0.0)) <= min(min(high.x, high.y), min(high.z, end));
        int count = is_leaf && enters ? int(node.w >> STACKLESS_COUNT_SHIFT & STACKLESS_COUNT_MOST) : 0;
        int texel = int(node.w & ((1u << STACKLESS_COUNT_SHIFT) - 1u));
        for (int i = 0; i < count; i++, texel += STACKLESS_TRIANGLE) {
            bool on_edge;
            float at = pane_met_at(texel, origin, direction, on_edge);
            bool again = on_edge && abs(at - edge_at) < PANE_EDGE * at;
            if (at > start && at < end && !again) {
                edge_at = on_edge ? at : edge_at;
                met.passes *= pane_passes(pane_at(texel), direction);
                met.texel = at < met.nearest ? texel : met.texel;
                met.nearest = min(at, met.nearest);
            }
        }
        box = is_leaf || enters ? box + 1 : int(node.w);
    }
    return met;
}

vec3 panes_pass(vec3 origin, vec3 direction, float end) {
    return panes_meet(origin, direction, 0.0, end).passes;
}

// By chance ends light at a pane before that distance, which it then is: as often as the pane reflects diffusely what it does
// not let pass. The share of the light, over the chance of this end; the pane's normal.
bool panes_stop(vec3 origin, vec3 direction, float chance, inout float end, out vec3 share, out vec3 normal) {
    share = vec3(1.0);
    normal = vec3(0.0);
    panes_met met = panes_meet(origin, direction, 0.0, end);
    while (met.nearest < end) {
        pane p = pane_at(met.texel);
        vec3 keeps = pane_albedo(p, direction), passes = pane_passes(p, direction);
        float most = max_of(keeps), stops = most > 0.0 ? most / (most + max_of(passes)) : 0.0;
        bool at_pane = chance < stops;
        share *= at_pane ? keeps / stops : passes / (1.0 - stops);
        if (at_pane) {
            end = met.nearest;
            normal = dot(p.normal, direction) < 0.0 ? p.normal : -p.normal;
            return true;
        }
        chance = (chance - stops) / (1.0 - stops);
        met = panes_meet(origin, direction, met.nearest * (1.0 + PANE_EDGE), end);
    }
    return false;
}

bool panes_none() {
    return int(texelFetch(panes, 0).w) <= STACKLESS_HEADER;
}

float panes_clearance() {
    return uintBitsToFloat(texelFetch(panes, 1).w);
}
