/* Parameters that passes/gather/ share with their shaders. */
#ifndef SHARED_GATHER_H
#define SHARED_GATHER_H

#include "shared/types.h"

/* An interleaving pattern [Segovia et al. 2006]. Pixels at one place of the n x n blocks are drawn
 * together, as a tile. */
struct interleaving {
    ivec2 tile; /* size, pixels */
    int n;      /* 1: picture order */
    int unused;
};
STD140_SIZE(interleaving, 16)

/* Kinds of lists: pixels of each level, and edge samples. Each kind has a list for each place of
 * the pattern, which has at most 8 x 8. */
#define PIXEL_LEVEL_EDGE 0   /* edge or corner: two or three of four neighbours are similar */
#define PIXEL_LEVEL_DETAIL 1 /* at most one neighbour is similar */
#define PIXEL_LEVELS 2
#define LIST_EDGE_SAMPLES 2 /* after the levels */
#define LIST_KINDS 3
#define PIXEL_LISTS_MAX (64 * LIST_KINDS)

/* RECEIVERS of a draw: all pixels of a place in the pattern, pixels of a list, or pixels of no
 * list. */
#define RECEIVERS_ALL 0
#define RECEIVERS_ADAPTIVE 1
#define RECEIVERS_OTHERS 2

/* Parameters of passes/gather/gather.h. */
#define UNIT_PATHS_KEPT (UNIT_OWN + 0)
#define UNIT_CUTS (UNIT_OWN + 1)

/* CLAMP: bound of cos cos / d^2 near a VPL. DISK: form factor of a disk of the VPL's area. NEAR:
 * near light is left to passes/gather/near_field.h. SPHERE: the VPL's light is spread over a ball
 * [Hašan et al. 2009]. The others are not settings. PATCH: VPLs of later bounces
 * (passes/gather/vpl_terms.glsl). RECTANGLE and above: rectangles, which need no bound. */
#define GATHER_CLAMP_NONE 0
#define GATHER_CLAMP_VALUE 1
#define GATHER_CLAMP_DISK 2
#define GATHER_CLAMP_NEAR 3
#define GATHER_CLAMP_SPHERE 4
#define GATHER_CLAMP_PATCH 5
#define GATHER_CLAMP_RECTANGLE 6
#define GATHER_CLAMP_RECTANGLE_NEAR 7 /* without their near field */

/* TESTED: who tests visibility. GROUP: two VPLs for their group. PIXEL: the pixel. BLOCK: the
 * nearest block on its surface. GIVEN_BLOCK: that block, from the list texel. BLOCKS: the four
 * blocks around it. */
#define TESTED_BY_GROUP 0
#define TESTED_BY_PIXEL 1
#define TESTED_BY_BLOCK 2
#define TESTED_BY_GIVEN_BLOCK 3
#define TESTED_BY_BLOCKS 4

/* Gathered quantity: irradiance, or specular radiance. VPLs count as points, as balls, or as points
 * weighted against rays that find the same light. */
#define SPECULAR_NONE 0
#define SPECULAR_POINT 1
#define SPECULAR_SPHERE 2
#define SPECULAR_RAYS 3

struct gather_params {
    STRUCT(interleaving) pattern;
    float scale;       /* of the stored irradiance */
    float clamp_at;    /* 1/m2 */
    int block;         /* side of a visibility block, pixels */
    float turn;        /* rotation of the numbers that choose the testing VPL, by pass */
    float sphere2;     /* squared radius of a VPL's ball, over its area */
    int cut_block;     /* side of a block that shares a cut, pixels */
    int cut_layer;     /* first layer of the cuts that are read */
    int specular_rays; /* of a pixel */
    int together;      /* VPLs side by side of which two test visibility for all */
    float unseen_rays; /* specular rays for each light, at hits that the camera does not see */
    int unused0, unused1;
};
STD140_SIZE(gather_params, 64)

/* Parameters of passes/gather/adaptive.h. */
struct adaptive_params {
    STRUCT(interleaving) pattern; /* of the lists */
    float distance; /* alpha of the blur, over the picture's height at the pixel's depth */
    float cosine;   /* beta */
    float apart;  /* greatest offset of a similar neighbour from the pixel's plane, as `distance` */
    float fewest; /* least similar neighbours of a planar pixel */
    int radius;   /* distance of the tested neighbours, pixels along x and y */
    int block;    /* side of a visibility block, pixels */
    float sharp_cosine; /* normals farther apart are more than gentle relief */
    int unused;
};
STD140_SIZE(adaptive_params, 48)

/* Parameters of passes/gather/near_field.h. */
#define UNIT_NEAR_LIGHT (UNIT_OWN + 0) /* LIGHT_MAP_KINDS of them (shared/light.h) */

/* Occluders of near light: none; those that the light sees; all triangles. */
#define NEAR_UNOCCLUDED 0
#define NEAR_BY_VIEWS 1
#define NEAR_BY_RAYS 2
/* Samples of which one, chosen by its light, tests visibility for all: unbiased. */
#define NEAR_TOGETHER 16

struct near_field_params {
    STRUCT(interleaving) pattern;
    float power_scale;    /* of the stored power: that of the irradiance over the squared radius */
    float inverse_radius; /* of the scene, 1/m */
    float turn;           /* rotation of the numbers that choose the testing sample, by pass */
    float unused;
    vec2 next_turn; /* rotation between samples, cosine and sine (base/spiral.h) */
    vec2 unused2;
};
STD140_SIZE(near_field_params, 48)

#define NEAR_SAMPLES_MAX 1024

/* Parameters of passes/gather/blur.h. */
#define UNIT_BLUR_TAPS (UNIT_OWN + 0)
#define UNIT_ADAPTIVE_IRRADIANCE (UNIT_OWN + 1)

/* Levels of taps: pixels of no list, pixels of each list level, and edges with steep irradiance. */
#define BLUR_LEVEL_NONE 0
#define BLUR_LEVEL_OF_LIST(level) (1 + (level))
#define BLUR_LEVEL_STEEP (1 + PIXEL_LEVELS)

struct blur_params {
    STRUCT(interleaving) pattern; /* of the input */
    ivec2 along;                  /* step of one pixel */
    int radius;                   /* taps on each side, along */
    int rows;                     /* rows of taps on each side, across */
    float distance;               /* alpha, over the picture's height at the pixel's depth */
    float cosine;                 /* beta */
    float inverse_power; /* 1 / power of all lights; times area and stored irradiance: a fraction */
    float detail_cosine; /* beta of BLUR_LEVEL_OF_LIST(PIXEL_LEVEL_DETAIL) */
    vec4 radii;          /* radius of the taps of each level */
    vec4 taken_radii;    /* radius of the taps that a pixel of no list takes from each level */
    vec4 weights;        /* weight of each level's estimate: its number of lights, relative */
};
STD140_SIZE(blur_params, 96)

/* Parameters of passes/gather/specular_rays.h. */

/* Step between rays in the lobe's unit square. */
#define SPECULAR_STEP_X 0.7548776662
#define SPECULAR_STEP_Y 0.5698402910

struct specular_rays_params {
    STRUCT(interleaving) pattern;
    vec2 start;       /* of the pass's first ray, in [0, 1) */
    float scale;      /* of the stored radiance */
    float farthest;   /* beyond all surfaces, metres */
    int rays;         /* of a pixel */
    float vpl_weight; /* VPLs that one VPL represents at a receiver with rays */
    float unused0, unused1;
};
STD140_SIZE(specular_rays_params, 48)

/* Parameters of passes/gather/vpl_cut.h. */
#define CUT_GROUP 8      /* invocations along each side */
#define CUT_NODES_MAX 64 /* of a block's cut */

struct vpl_cut_params {
    ivec2 blocks;   /* of the picture */
    int block;      /* side, pixels */
    int leaves;     /* of the tree */
    int nodes;      /* most nodes of a cut */
    int more_nodes; /* most nodes of the second cut of each block */
    float tolerance;
    float clamp_at; /* as in gather_params */
};
STD140_SIZE(vpl_cut_params, 32)

/* Rectangle of an area light that replaces a cluster of VPLs (passes/lights/cluster_light.h).
 * Transform feedback writes it (passes/lights/cluster_light.vert); the gather reads it in a block.
 * Position, normal, area and flux are those of a VPL. */
#define UNIT_SUM_SQUARES (UNIT_OWN + 0)
#define UNIT_SUM_PRODUCTS (UNIT_OWN + 1)

#define LIGHT_RECTANGLE_ROWS 2

/* Shape of a cluster's light. A disk has the area of its VPLs and no other shape data. */
#define LIGHT_FORM_RECTANGLE 0
#define LIGHT_FORM_DISK 1

struct light_rectangle {
    vec3 right; /* half side, metres; right x up is along the normal */
    float unused0;
    vec3 up;
    float unused1;
};
STD140_SIZE(light_rectangle, 16 * LIGHT_RECTANGLE_ROWS)

#define LIGHT_RECTANGLES_MAX 1024

#endif
