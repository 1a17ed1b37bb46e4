/* Depth maps of VALs and lights: views, lookups, and parameters of passes/visibility/. */
#ifndef SHARED_MAPS_H
#define SHARED_MAPS_H

#include "shared/types.h"

/* Paraboloid view of a VAL or VPL for its shadow map [Dong 2009 §4.2]. Transform feedback writes
 * it (passes/visibility/map_view_output.glsl). */
#define MAP_VIEW_ROWS 3

struct map_view {
    vec3 center;  /* metres */
    float z_far;  /* distance of map depth 1, metres */
    vec3 axis;    /* unit */
    float extent; /* extent of the light, metres; 0: point */
    vec3 tangent; /* unit, perpendicular to the axis */
    float near;   /* metres */
};
STD140_SIZE(map_view, 16 * MAP_VIEW_ROWS)

/* Value of `near` of an empty view: all casters are nearer, and no lookup happens. */
#define MAP_VIEW_EMPTY 1e30

/* Views in a uniform block: 48 KiB. */
#define MAP_VIEWS_MAX 1024

/* Lookup of a point in a depth map: PROJECTION gives its position in the map, FILTER the fraction
 * of light that reaches it (passes/visibility/lookup.glsl). */
#define PROJECTION_PARABOLOID 0   /* struct map_view */
#define PROJECTION_PERSPECTIVE 1  /* struct view */
#define PROJECTION_ORTHOGRAPHIC 2 /* struct view */
#define PROJECTION_LIGHT_MAP 3    /* struct light_map of passes/visibility/light_map.glsl */
#define FILTER_NONE 0             /* unoccluded */
#define FILTER_HARD 1             /* one texel */
#define FILTER_CSSM 2             /* convolution soft shadow maps */
#define FILTER_PCSS 3             /* percentage-closer soft shadows */
#define FILTER_PCF 4              /* the four nearest texels, weighted */
#define FILTER_RAY 5              /* texels along the ray to a VPL */
#define FILTER_VSSM 6             /* variance soft shadow maps */
#define FILTER_MSM 7              /* moment shadow maps */
#define FILTER_CSSM_WINDOW 8      /* convolution soft shadow maps in lights' own maps */
#define FILTER_PLANE 9            /* one texel, with the caster's plane */
#define FILTER_TRACED 10          /* ray to a VPL through the scene's triangles */

struct lookup_params {
    float bias;     /* offset of the point along its normal, texels of the map */
    float map_size; /* texels */
    float map_bias; /* bias of comparisons with texels, over the distance */
    float shift;    /* FILTER_CSSM: of the receiver, in the argument of the series */
    float gain;     /* of the blocked fraction about one half; FILTER_CSSM_WINDOW: about 0 */
    /* Windowed filters: casters closer than this are compared texel by texel, over the distance. */
    float contact;
    int map_count; /* number of VALs' maps */
    int unused0;
};
STD140_SIZE(lookup_params, 32)

/* Parameters of passes/visibility/vpl_views.h. */
struct vpl_views_params {
    vec3 bounds_min; /* metres */
    float near_clip; /* over the spread of VPLs */
    vec3 bounds_max;
    float unused;
};
STD140_SIZE(vpl_views_params, 32)

/* Parameters of passes/visibility/paraboloid.h. */
struct paraboloid_params {
    float texel;     /* size of a texel, over half of the map */
    float long_edge; /* shorter edges stay straight, metres */
    float set_back;  /* offset of casters, metres: simplified ones may have advanced */
    float unused;
};
STD140_SIZE(paraboloid_params, 16)

/* Parameters of passes/visibility/basis.h. */
struct basis_params {
    int first_term; /* 4 g for group g */
    int unused0, unused1, unused2;
};
STD140_SIZE(basis_params, 16)

/* Range of casters' depths in a map, to which its Fourier series is fitted
 * (passes/visibility/series.glsl). A compute shader writes it
 * (passes/visibility/series_range.comp). */
struct series_range { /* map depths */
    float nearest, farthest;
    float knee;  /* beyond the nearest, where a step becomes four times as long in metres */
    float scale; /* of the argument; not a depth */
};
STD140_SIZE(series_range, 16)

/* 16 KiB, which OpenGL guarantees for a uniform block. */
#define SERIES_RANGES_MAX MAP_VIEWS_MAX

/* Summed-area tables of moments of depth or of Fourier bases, in fixed point. Sums that overflow
 * are correct while the sum over the queried box is below 2^32. */

/* Depths in [0, 1] and their powers have 18 bits, for boxes of up to 128 x 128 texels. */
#define SUM_ONE 262143.0 /* 2^18 - 1 */
#define SUM_BOX_MAX 128

/* Bases in [-1, 1] have 12 bits, for boxes of up to 1024 x 1024 texels: they are compared with a
 * step of K terms. Tables of all maps follow each other: cos of each group of four terms, sin, a
 * cos, a sin, and a. */
#define SUM_BASIS_ONE 4095.0

/* Invocations of a group; each sums one row or column. */
#define SUM_LINES 64

/* Parameters of passes/visibility/depth_bounds.h, and positions of levels. All levels are side by
 * side in one texture, because rasterisers of four-pixel groups choose one mip level for the
 * group. */
#define BOUNDS_GROUP 8 /* invocations along each side */

struct depth_bounds_params {
    int level;
    int base; /* squares along a side of level 0: half of the map */
    int map_size;
    int unused;
};
STD140_SIZE(depth_bounds_params, 16)

/* Squares along a side of a level, and its position in the texture: level 0, then the others in a
 * column beside it. */
SHARED_FUNCTION int bounds_side(int base, int level) {
    return base >> level;
}

SHARED_FUNCTION int bounds_x(int base, int level) {
    return level > 0 ? base : 0;
}

SHARED_FUNCTION int bounds_y(int base, int level) {
    return level > 0 ? base - (base >> (level - 1)) : 0;
}

/* Parameters of passes/visibility/block_visibility.h. */
struct block_visibility_params {
    int block; /* side, pixels */
    int unused0, unused1, unused2;
};
STD140_SIZE(block_visibility_params, 16)

#endif
