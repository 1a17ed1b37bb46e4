/* Directions of a sky's light samples, one of which each VPL takes (lights/sky_pieces.h). */
#ifndef SHARED_SKY_PIECE_H
#define SHARED_SKY_PIECE_H

#include "shared/bindings.h"

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

#endif
