/* Maps of depth from VALs and lights: views, lookups, and what passes/visibility/ makes of them. */
#ifndef SHARED_MAPS_H
#define SHARED_MAPS_H

#include "shared/types.h"

/* The paraboloid view from a VAL (or a VPL): what its shadow map sees [Dong 2009 §4.2]. Transform
 * feedback writes it (passes/visibility/map_view_output.glsl). */
#define MAP_VIEW_ROWS 3

struct map_view {
    vec3 center; /* metres */
    float z_far; /* the distance at which map depth is 1, metres */
    vec3 axis;   /* unit */
    float extent; /* of the light, metres; 0 for a point */
    vec3 tangent; /* unit, perpendicular to the axis */
    float near;   /* metres */
};
STD140_SIZE(map_view, 16 * MAP_VIEW_ROWS)

/* For near: all casters are nearer, and nobody asks. */
#define MAP_VIEW_EMPTY 1e30

/* Views per uniform block: 48 KiB. */
#define MAP_VIEWS_MAX 1024

/* How a point looks itself up in a map of depth: a projection, which says where the map has it, and a
 * filter, which says which part of the light reaches it (passes/visibility/lookup.glsl). */
#define PROJECTION_PARABOLOID 0   /* struct map_view */
#define PROJECTION_PERSPECTIVE 1  /* struct view */
#define PROJECTION_ORTHOGRAPHIC 2 /* struct view */
#define PROJECTION_LIGHT_MAP 3    /* struct light_map of passes/visibility/light_map.glsl */
#define FILTER_NONE 0        /* all is lit */
#define FILTER_HARD 1        /* one texel */
#define FILTER_CSSM 2        /* convolution soft shadow maps */
#define FILTER_PCSS 3        /* percentage-closer soft shadows */
#define FILTER_PCF 4         /* the four nearest texels, weighted */
#define FILTER_RAY 5         /* the texels along the ray to a VPL */
#define FILTER_VSSM 6        /* variance soft shadow maps */
#define FILTER_MSM 7         /* moment shadow maps */
#define FILTER_CSSM_WINDOW 8 /* convolution soft shadow maps of lights' own maps */
#define FILTER_PLANE 9       /* one texel, and the plane of the caster there */
#define FILTER_TRACED 10     /* a ray to a VPL through the scene's triangles */

struct lookup_params {
    float bias;     /* of the point along its normal, texels of the map */
    float map_size; /* texels */
    float map_bias; /* of the point where it is compared with a texel, of its distance */
    float shift;    /* FILTER_CSSM: of the receiver, in the argument of the series */
    float gain;     /* of the blocked part, about a half; FILTER_CSSM_WINDOW: from nothing */
    float contact; /* windowed filters: what is nearer than this, of its distance, is compared */
    int map_count; /* VALs' maps */
    int unused0;
};
STD140_SIZE(lookup_params, 32)

/* passes/visibility/vpl_views.h to its shader. */
struct vpl_views_params {
    vec3 bounds_min; /* metres */
    float near_clip; /* over the spread of VPLs */
    vec3 bounds_max;
    float unused;
};
STD140_SIZE(vpl_views_params, 32)

/* passes/visibility/paraboloid.h to its shaders. */
struct paraboloid_params {
    float texel;     /* over half of the map */
    float long_edge; /* shorter ones stay straight, metres */
    float set_back;  /* of casters, metres: simplified ones may have come forward */
    float unused;
};
STD140_SIZE(paraboloid_params, 16)

/* passes/visibility/basis.h to its shader. */
struct basis_params {
    int first_term; /* 4 g for group g */
    int unused0, unused1, unused2;
};
STD140_SIZE(basis_params, 16)

/* The depths that a map's casters take, to which its Fourier series is fitted (passes/visibility/series.glsl). A
 * compute shader writes them (passes/visibility/series_range.comp). */
struct series_range { /* map depths */
    float nearest, farthest;
    float knee;  /* beyond the nearest: there a step takes four times as many metres */
    float scale; /* of the argument: no depth */
};
STD140_SIZE(series_range, 16)

/* 16 KiB, what GL promises to a uniform block. */
#define SERIES_RANGES_MAX MAP_VIEWS_MAX

/* Summed area tables of moments of depth or of its Fourier bases, in fixed point: sums that wrap around are right as
 * long as the box that is asked for has less than 2^32 itself. */

/* Depths of [0, 1] and their powers have 18 bits: boxes of up to 128 x 128 texels are told. */
#define SUM_ONE 262143.0 /* 2^18 - 1 */
#define SUM_BOX_MAX 128

/* Bases, of [-1, 1], have 12 bits: boxes of up to 1024 x 1024 texels, for what is compared with them is a step in K terms.
 * Tables of all maps follow each other: cos of each group of four terms, sin, a cos, a sin, and a. */
#define SUM_BASIS_ONE 4095.0

/* Invocations of a group; each adds up a row or a column. */
#define SUM_LINES 64

/* Pyramids of nearest and farthest depths: passes/visibility/depth_bounds.h to its shader, and where both find a
 * level. All levels lie side by side: rasterisers that run four pixels at once take a MIP level for all of them. */
#define BOUNDS_GROUP 8 /* invocations a side */

struct depth_bounds_params {
    int level;
    int base; /* squares a side of level 0: the half of the map */
    int map_size;
    int unused;
};
STD140_SIZE(depth_bounds_params, 16)

/* Squares a side of a level, and its place in the texture: level 0, and the others in a column beside it. */
SHARED_FUNCTION int bounds_side(int base, int level) {
    return base >> level;
}

SHARED_FUNCTION int bounds_x(int base, int level) {
    return level > 0 ? base : 0;
}

SHARED_FUNCTION int bounds_y(int base, int level) {
    return level > 0 ? base - (base >> (level - 1)) : 0;
}

/* passes/visibility/block_visibility.h to its shader. */
struct block_visibility_params {
    int block; /* pixels a side */
    int unused0, unused1, unused2;
};
STD140_SIZE(block_visibility_params, 16)

#endif
