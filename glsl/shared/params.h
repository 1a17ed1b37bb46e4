/* The parameters of each pass: one block a pass, at BLOCK_PASS. */
#ifndef SHARED_PARAMS_H
#define SHARED_PARAMS_H

#include "shared/types.h"

struct direct_params {
    float bias; /* metres along the normal per metre of a shadow texel */
    float shadow_size; /* texels */
    float unused0, unused1;
};

struct cluster_params {
    float weight_position; /* w_x over the scene's radius, 1/m */
    float weight_normal;   /* w_alpha over pi, 1/rad */
    float val_count, vpl_count;
    vec4 bounds_min, bounds_max; /* metres */
    float depth_range; /* map depth of the farthest point of the scene */
    float near_clip;   /* metres */
    float reseed;      /* > 0: empty clusters begin again */
    float unused;
};

struct map_params {
    vec4 bounds_min, bounds_max; /* metres */
    float depth_range;
    float near_clip; /* metres */
    float first;     /* VPL of the first map */
    float clip_z;    /* metres above the map's plane */
};

struct basis_params {
    float first_term; /* 4 g for group g */
    float layer_count;
    float unused0, unused1;
};

/* How a point looks itself up in the maps; at BLOCK_VISIBILITY. */
struct visibility_params {
    float bias;     /* of the point along its normal, texels of the map */
    float map_size; /* texels */
    float map_bias; /* of a hard lookup, of the distance */
    float shift;    /* of the receiver depth, map depth */
    float gain;     /* of the blocked fraction about one half */
    float sharpen_a, sharpen_b;
    float unused;
};

struct gather_params {
    float interleave;
    float scale; /* of the stored irradiance */
    float tile_width, tile_height;
    float clamp_at; /* 1/m2 */
    float reach;    /* of the near field, in spacings of VPLs */
    float block;    /* pixels a side of a block that shares its visibility */
    float block_apart; /* metres: farther from a block's plane, a pixel looks itself up */
};

struct block_params {
    float block; /* pixels a side */
    float unused0, unused1, unused2;
};

struct near_field_params {
    float interleave;
    float tile_width, tile_height;
    float vpl_share;      /* solid angle of one VPL, sr; area of a directional light's, m2 */
    float reach;          /* of the near field, in spacings of VPLs */
    float power_scale;    /* of the stored power: that of the irradiance over the squared radius */
    float inverse_radius; /* of the scene, 1/m */
    float unused;
};

#define NEAR_SAMPLES_MAX 1024

struct blur_params {
    float interleave; /* of the picture that is read: 1 = plain */
    float tile_width, tile_height;
    float radius;     /* taps to each side */
    vec4 direction;   /* x y: one pixel */
    float distance2;  /* alpha^2, m2 */
    float cosine;     /* beta */
    float radius_y;   /* rows to each side; 0 = along the direction alone */
    float unused;
};

#define SAMPLES_MAX 16
#define SAMPLES_PER_LAYER 4

struct antialias_params {
    vec4 places[SAMPLES_MAX]; /* xy: of the sample from the pixel's centre, pixels */
    vec4 shifts[SAMPLES_MAX / SAMPLES_PER_LAYER]; /* xy: of each layer, in clip space */
};

struct composite_params {
    vec4 light;       /* radiance per stored direct value, RGB; w: samples of a pixel */
    float indirect;   /* radiance per stored irradiance */
    float exposure;   /* factor */
    float tone_map;   /* 0 clamp, 1 filmic */
    float layer;      /* what to write, LAYER_... */
};

struct screen_params {
    float x, y, width, height; /* of the picture in the window, pixels */
    float split;               /* where the right picture begins, over the width */
    float unused0, unused1, unused2;
};

struct inspect_params {
    float kind;          /* what is shown, INSPECT_... */
    float columns, rows; /* layers shown at once, as a sheet */
    float first_layer;
    float layer_count;
    float cell_width, cell_height; /* of the sheet, pixels; 0: one layer, pixel by pixel */
    float gap;                     /* dark between cells, pixels */
    float exposure;                /* factor on irradiance */
    float unused0, unused1, unused2;
    vec4 center;    /* of the scene; w: radius, metres */
};

#define INSPECT_NORMAL 0
#define INSPECT_ALBEDO 1
#define INSPECT_DEPTH 2
#define INSPECT_MAP_DEPTH 3
#define INSPECT_BASIS 4
#define INSPECT_SIGNED_BASIS 5
#define INSPECT_IRRADIANCE 6
#define INSPECT_DIMMED 7
#define INSPECT_VISIBILITY 8

struct probe_params {
    vec4 position, normal; /* of a surface */
};

struct mark_params {
    float width, height; /* of the picture, pixels */
    float size;          /* of a point or width of a line, pixels */
    float by_cluster;    /* colour: 1 by the VAL, 0 by the flux */
    float flux_scale;    /* of a usual VPL, 1/W */
    float normal_length; /* metres */
    float chosen;        /* VAL that stands out; -1 = none, and then all are as bright */
    float only_chosen;   /* 1: no other is drawn */
};

#define LAYER_BEAUTY 0
#define LAYER_DIRECT 1
#define LAYER_INDIRECT 2
#define LAYER_ALBEDO 3
#define LAYER_NORMAL 4
#define LAYER_DEPTH 5

#endif
