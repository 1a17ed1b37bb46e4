/* Light of skies: lights, pieces that VPLs take, and environment lighting. */
#ifndef SHARED_SKY_H
#define SHARED_SKY_H

#include "shared/types.h"

/* A sky as area lights, infinitely far away. */
#define ENVIRONMENT_LIGHTS_MAX 256

#define SKY_ROWS 9

struct sky_source {
    vec4 corners[4]; /* unit directions; their last number is 0 */
    vec3 radiance;   /* W/(sr m2) */
    float luminance; /* of it */
    vec3 vector;     /* irradiance over radiance, as a vector: where all of the light is above the horizon */
    float unused0;
    /* Points of the light are the parallelogram middle + x side_x + y side_y, x and y from -1 to 1. */
    vec3 middle; /* unit: towards the light */
    float unused1;
    vec3 side_x;
    float unused2;
    vec3 side_y;
    float unused3;
};
STD140_SIZE(sky_source, 16 * SKY_ROWS)

/* lib/sky.glsl reads it. */
struct sky_block {
    STRUCT(sky_source) sources[ENVIRONMENT_LIGHTS_MAX];
};
STD140_SIZE(sky_block, 16 * SKY_ROWS * ENVIRONMENT_LIGHTS_MAX)

/* Directions of a sky's light samples, one of which each VPL takes (lights/sky_pieces.h). */

/* Of each light sample: a power of two. */
#define SKY_PIECES 32
#define SKY_PIECE_SHIFT 27 /* from 32 bits to a piece's number */
#define SKY_PIECE_ROWS 4

/* Across its direction, the rectangle that holds the scene's bounding box. */
struct sky_piece {
    vec3 origin;   /* its middle */
    float area;    /* over the light sample's measure */
    vec3 right;    /* half of its sides; right x up = -direction */
    float shift_x; /* of places on it, so that the door of the group's light has one place */
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
    vec2 door,
        door_size; /* where most useful light comes in, of places from 0 to 1: a corner, and from there */
};
STD140_SIZE(sky_row, 16 * SKY_ROW_TEXELS)

/* passes/visibility/environment_lighting.h to its shaders. */
#define UNIT_SKY_SHARES (UNIT_OWN + 0)

/* Of the table of what lights give by a surface's normal, texels a side. */
#define SKY_SHARES_SIZE 65

struct environment_lighting_params {
    int count;         /* of lights */
    int block;         /* pixels a side of a block that shares its visibility */
    float disagree;    /* of all light: where blocks do by more, rays start at the pixel */
    int pass;          /* of several: each has other points of the lights */
};
STD140_SIZE(environment_lighting_params, 16)

/* Lights of one layer of an array, and layers of one draw. */
#define SKY_LAYER_LIGHTS 4
#define SKY_DRAW_LAYERS 8 /* as many lights as a mask has bits */

#endif
