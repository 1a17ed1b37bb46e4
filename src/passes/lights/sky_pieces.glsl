// Directions of a sky's light samples, and about where their light comes in.
#include "shared/sky.h"

layout(binding = UNIT_SKY_PIECES) uniform sampler2D sky_pieces; // a row a light, zeros where it is none of a sky

vec4 sky_piece_row(int index, int piece, int row) {
    return texelFetch(sky_pieces, ivec2(SKY_PIECE_ROWS * piece + row, index), 0);
}

bool has_sky_pieces(int index) {
    return sky_piece_row(index, 0, 0).w > 0.0;
}

// Candidates of the first round: every other one lies in the door.
vec4 sky_door(int index) {
    vec4 door = sky_piece_row(index, SKY_PIECES, 0);
    return door.z > 0.0 ? door : vec4(0.0, 0.0, 1.0, 1.0);
}

float sky_door_density(int index, vec2 place) {
    vec4 door = sky_door(index);
    vec2 within = (place - door.xy) / door.zw;
    return within == clamp(within, 0.0, 1.0) ? 0.5 + 0.5 / (door.z * door.w) : 0.5;
}
