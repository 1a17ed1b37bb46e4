// Shadows: a projection (visibility/projection_*.glsl) and a filter (visibility/filter_*.glsl), which are included behind
// this one.
//
// A projection says where a map has a point:
//     receiver                              a point as the map sees it
//     bool project(v, position, normal, r)  false where the view v does not look
//     float receiver_distance(r, texel)     where the receiver's plane is met through a texel
//     float receiver_slope(r)               how much farther the receiver's plane gets over an angle, of its distance
//     float extent_in_units(r, extent)      the light's extent, in units of r.unit
//     float map_depth(r, stored)            linear depth of a texel's value, in units of r.unit
//     float light_angle(r, extent, d)       the light's extent, seen from the receiver
//     float penumbra_angle(extent, d, z)    the penumbra of a blocker at z, seen from the light
//     float angle_width(r, angle)           such an angle in the map, over its width
// Windowed filters need these instead of angles:
//     vec4 window(r, extent, z)             what ways to the light pass of the map at a depth, low and high corner
//     float plane_depth(r, uv)              where the receiver's plane is met
// Distances are metres, or all in one other unit. A filter has one function:
//     float lit(int map, receiver r, float extent)
#include "shared/maps.h"

layout(std140, binding = BLOCK_LOOKUP) uniform lookup_uniforms {
    lookup_params lookup;
};
