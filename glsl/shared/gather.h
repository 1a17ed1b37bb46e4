/* What the passes of passes/gather/ share with their shaders. */
#ifndef SHARED_GATHER_H
#define SHARED_GATHER_H

#include "shared/types.h"

/* An interleaving pattern [Segovia et al. 2006]: the pixels of one place in blocks of n x n are drawn
 * together, as a tile. */
struct interleaving {
    ivec2 tile; /* size, pixels */
    int n;      /* 1: a plain picture */
    int unused;
};
STD140_SIZE(interleaving, 16)

/* Lists of what gathers by itself, one a kind and place of the pattern, which has at most 8 x 8: pixels of each
 * level, and edge samples of pixels. */
#define PIXEL_LEVEL_EDGE 0   /* at an edge or a corner: two or three of four neighbours are like */
#define PIXEL_LEVEL_DETAIL 1 /* fewer are */
#define PIXEL_LEVELS 2
#define LIST_EDGE_SAMPLES 2 /* after the levels' */
#define LIST_KINDS 3
#define PIXEL_LISTS_MAX (64 * LIST_KINDS)

/* Of a draw of a tile, RECEIVERS: all pixels of its place in the pattern, those of a list, or all but those. */
#define RECEIVERS_ALL 0
#define RECEIVERS_ADAPTIVE 1
#define RECEIVERS_OTHERS 2

/* passes/gather/gather.h to its shader. */
#define UNIT_PATHS_KEPT (UNIT_OWN + 0)
#define UNIT_CUTS (UNIT_OWN + 1)

/* How cos cos / d^2 is bounded near a VPL, CLAMP. The disk form factor is that of a disk of the VPL's area. The near
 * field leaves what is near to passes/gather/near_field.h. Spheres spread the VPL's light over a ball [Hašan et al.
 * 2009]. No choices of a user: patches are of later bounces (passes/gather/patch.glsl); rectangles need no bound, and
 * those from RECTANGLE on are rectangles. */
#define GATHER_CLAMP_NONE 0
#define GATHER_CLAMP_VALUE 1
#define GATHER_CLAMP_DISK 2
#define GATHER_CLAMP_NEAR 3
#define GATHER_CLAMP_SPHERE 4
#define GATHER_CLAMP_PATCH 5
#define GATHER_CLAMP_RECTANGLE 6
#define GATHER_CLAMP_RECTANGLE_NEAR 7 /* without their near field */

/* What is gathered: irradiance, or what reflects as by a mirror, of VPLs as points, as balls, or as points as
 * far as rays do not find the same light better. */
#define SPECULAR_NONE 0
#define SPECULAR_POINT 1
#define SPECULAR_SPHERE 2
#define SPECULAR_RAYS 3

struct gather_params {
    STRUCT(interleaving) pattern;
    float scale;    /* of the stored irradiance */
    float clamp_at; /* 1/m2 */
    int block;      /* pixels a side of a block that shares its visibility */
    float turn;     /* of the numbers that say which VPL asks for others, from pass to pass */
    float sphere2;  /* squared radius of a VPL's ball, over the area that it stands for */
    int cut_block;  /* pixels a side of a block that shares a cut */
    int cut_layer;  /* the first of the cuts that are read */
    int specular_rays; /* of a pixel */
    int together;   /* VPLs side by side, of which two test the visibility of all */
    float unseen_rays; /* specular rays for each light, where the camera does not see what they meet */
    int unused0, unused1;
};
STD140_SIZE(gather_params, 64)

/* passes/gather/adaptive.h to its shader. */
struct adaptive_params {
    STRUCT(interleaving) pattern; /* of the lists */
    float distance; /* alpha of the blur, over the picture's height at the pixel's depth */
    float cosine;   /* beta */
    float apart;    /* likewise: neighbours farther off the pixel's plane are unlike */
    float fewest;   /* like neighbours of a smooth pixel */
    int radius;     /* of the neighbours that are asked, pixels along x and y */
    int block;      /* pixels a side of a block that shares its visibility */
    float sharp_cosine; /* where normals are farther apart, they are so for more than gentle relief */
    int unused;
};
STD140_SIZE(adaptive_params, 48)

/* passes/gather/near_field.h to its shaders. */
#define UNIT_NEAR_LIGHT (UNIT_OWN + 0) /* LIGHT_MAP_KINDS of them: shared/light.h */

/* What hides near light: nothing; what the light sees; all triangles. */
#define NEAR_UNOCCLUDED 0
#define NEAR_BY_VIEWS 1
#define NEAR_BY_RAYS 2
/* Of so many samples one, taken by its light, asks for all: on average each counts as if it had asked. */
#define NEAR_TOGETHER 16

struct near_field_params {
    STRUCT(interleaving) pattern;
    float power_scale;    /* of the stored power: that of the irradiance over the squared radius */
    float inverse_radius; /* of the scene, 1/m */
    float turn; /* of the numbers that say which sample asks for others, from pass to pass */
    float unused;
    vec2 next_turn; /* from sample to sample, cosine and sine (base/spiral.h) */
    vec2 unused2;
};
STD140_SIZE(near_field_params, 48)

#define NEAR_SAMPLES_MAX 1024

/* passes/gather/blur.h to its shaders. */
#define UNIT_BLUR_TAPS (UNIT_OWN + 0)
#define UNIT_ADAPTIVE_IRRADIANCE (UNIT_OWN + 1)

/* Levels of taps: pixels that no list has; those of lists' levels; and edges where light is steep. */
#define BLUR_LEVEL_NONE 0
#define BLUR_LEVEL_OF_LIST(level) (1 + (level))
#define BLUR_LEVEL_STEEP (1 + PIXEL_LEVELS)

struct blur_params {
    STRUCT(interleaving) pattern; /* of the picture that is read */
    ivec2 along;                  /* one pixel */
    int radius;                   /* taps to each side along */
    int rows;                     /* of such taps to each side across */
    float distance;               /* alpha, over the picture's height at the pixel's depth */
    float cosine;                 /* beta */
    float inverse_power; /* of all lights; times area and irradiance as it is stored: a share */
    float detail_cosine; /* beta of BLUR_LEVEL_OF_LIST(PIXEL_LEVEL_DETAIL) */
    vec4 radii;       /* of windows: of taps of each level */
    vec4 taken_radii; /* likewise, but of what a pixel that no list has takes of them */
    vec4 weights;     /* of their estimates: as many more lights have they */
};
STD140_SIZE(blur_params, 96)

/* passes/gather/specular_rays.h to its shader. */

/* From one ray's place in the lobe's square to the next one's. */
#define SPECULAR_STEP_X 0.7548776662
#define SPECULAR_STEP_Y 0.5698402910

struct specular_rays_params {
    STRUCT(interleaving) pattern;
    vec2 start;       /* of a pass's first ray, in [0, 1): others in each pass of many */
    float scale;      /* of the stored radiance */
    float farthest;   /* beyond all surfaces, metres */
    int rays;         /* of a pixel */
    float vpl_weight; /* of the VPLs that share a receiver with the rays: one stands for so many */
    float unused0, unused1;
};
STD140_SIZE(specular_rays_params, 48)

/* passes/gather/vpl_cut.h to its shader. */
#define CUT_GROUP 8      /* invocations a side */
#define CUT_NODES_MAX 64 /* of a block's cut */

struct vpl_cut_params {
    ivec2 blocks; /* of the picture */
    int block;    /* pixels a side */
    int leaves;   /* of the tree */
    int nodes;    /* of a cut, at most */
    int more_nodes; /* the same of a further one of each block */
    float tolerance;
    float clamp_at; /* as in gather_params */
};
STD140_SIZE(vpl_cut_params, 32)

/* The rectangle of an area light that stands for a cluster of VPLs (passes/lights/cluster_light.h). Transform
 * feedback writes it (passes/lights/cluster_light.vert); the gather reads it in a block. All else of the light is a
 * VPL's: position, normal, area, flux. */
#define UNIT_SUM_SQUARES (UNIT_OWN + 0)
#define UNIT_SUM_PRODUCTS (UNIT_OWN + 1)

#define LIGHT_RECTANGLE_ROWS 2

/* What a cluster's light is. A disk has the area of its VPLs, and no more of a shape. */
#define LIGHT_FORM_RECTANGLE 0
#define LIGHT_FORM_DISK 1

struct light_rectangle {
    vec3 right; /* half a side, metres; right x up is along the normal */
    float unused0;
    vec3 up;
    float unused1;
};
STD140_SIZE(light_rectangle, 16 * LIGHT_RECTANGLE_ROWS)

#define LIGHT_RECTANGLES_MAX 1024

#endif
