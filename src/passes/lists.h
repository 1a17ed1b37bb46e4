/* Lists of adaptive pixels and edge samples: one for each kind (PIXEL_LEVEL_... or
 * LIST_EDGE_SAMPLES) and each place of the n x n pattern. */
#ifndef PASSES_LISTS_H
#define PASSES_LISTS_H

#include "gl/buffer.h"
#include "gl/pass.h"
#include "gl/texture.h"

struct pixel_lists {
    /* R32UI, x | y << 16, in tiles of twice the picture's area. Lists fill their tile row by row.
     * Edge pixels begin at the start, edge samples at the second half. Detail pixels run backwards
     * from the end of the first half. */
    struct texture pixels;
    /* R32UI: list texel of each pixel (lib/tiles.glsl). 0: in no list. */
    struct texture texels;
    struct texture edge_sample_texels; /* R32UI: list texel of each pixel's edge sample */
    struct buffer counts;              /* entries of each list, uint */
    int interleave, tile_width, tile_height;
};

/* Changes a picture's size to that of its list tiles. It rounds up to the pattern and doubles the
 * shorter side, because textures have a limit. */
void pixel_lists_size(int size[2], int interleave);

/* pixel_lists_add binds the textures of passes/gather/receiver.glsl for `receivers`, RECEIVERS_....
 * RECEIVERS_ALL needs none. pixel_lists_draw draws the list of one place and kind, after
 * LOCATION_SLOT is set. */
void pixel_lists_add(struct pass_state *state, const struct pixel_lists *lists, int receivers,
                     const struct texture *edge_samples);
void pixel_lists_draw(const struct pixel_lists *lists, int list);

#endif
