/* Environment light: area lights, directions of VPLs, and environment lighting. */
#ifndef SHARED_SKY_H
#define SHARED_SKY_H

#include "shared/types.h"

/* An environment as area lights at infinite distance. */
#define ENVIRONMENT_LIGHTS_MAX 256

#define SKY_ROWS 9

struct sky_source {
    vec4 corners[4]; /* unit directions; their w is 0 */
    vec3 radiance;   /* W/(sr m2) */
    float luminance; /* luminance of the radiance */
    /* Irradiance over radiance, as a vector; valid with the whole light above the horizon. */
    vec3 vector;
    float unused0;
    /* Points of the light: middle + x side_x + y side_y, x and y in [-1, 1]. */
    vec3 middle; /* unit: towards the light */
    float unused1;
    vec3 side_x;
    float unused2;
    vec3 side_y;
    float unused3;
};
STD140_SIZE(sky_source, 16 * SKY_ROWS)

/* Block of lib/sky.glsl. */
struct sky_block {
    STRUCT(sky_source) sources[ENVIRONMENT_LIGHTS_MAX];
};
STD140_SIZE(sky_block, 16 * SKY_ROWS * ENVIRONMENT_LIGHTS_MAX)

/* Directions of an environment's light samples, one for each VPL (renderer/sky_pieces.h). */

/* Directions of each light sample: a power of two. */
#define SKY_PIECES 32
#define SKY_PIECE_SHIFT 27 /* shift from 32 bits to a direction's index */
#define SKY_PIECE_ROWS 4

/* The rectangle across a direction that contains the scene's bounding box. */
struct sky_piece {
    vec3 origin;   /* its centre */
    float area;    /* over the light sample's measure */
    vec3 right;    /* half sides; right x up = -direction */
    float shift_x; /* shift of coordinates, so that the group's opening has one position */
    vec3 up;
    float shift_y;
    vec3 intensity; /* W/m2 */
    float unused;
};
STD140_SIZE(sky_piece, 16 * SKY_PIECE_ROWS)

/* A row of the texture. */
#define SKY_ROW_TEXELS (SKY_PIECES * SKY_PIECE_ROWS + 1)
struct sky_row {
    STRUCT(sky_piece) pieces[SKY_PIECES];
    /* Opening with most useful light, in coordinates from 0 to 1: a corner, and its size. */
    vec2 door, door_size;
};
STD140_SIZE(sky_row, 16 * SKY_ROW_TEXELS)

/* Parameters of passes/visibility/environment_lighting.h. */
#define UNIT_SKY_SHARES (UNIT_OWN + 0)
#define UNIT_LOBE_SKY (UNIT_OWN + 1) /* the panorama */
#define UNIT_SKY_REFLECTED (UNIT_OWN + 2)

/* Side of the table of lights' irradiance by surface normal, texels. */
#define SKY_SHARES_SIZE 65

struct environment_lighting_params {
    int count;      /* of lights */
    int block;      /* side of a visibility block, pixels */
    float disagree; /* disagreement of blocks from which a pixel starts rays, over all its light */
    int pass;       /* index of the pass; each has other points of the lights */
    float sky_strength;
    float sky_turn; /* radians */
    float scale;    /* of stored specular radiance: irradiance_scale */
    float unused0;
};
STD140_SIZE(environment_lighting_params, 32)

/* Lights of a layer of an array; layers of a draw. */
#define SKY_LAYER_LIGHTS 4
#define SKY_DRAW_LAYERS 8 /* as many lights as a mask has bits */

#endif
