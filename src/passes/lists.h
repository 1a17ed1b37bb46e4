/* Some pixels of a picture and edge samples of some, as a list for each level (PIXEL_LEVEL_...) or of points
 * (LIST_EDGE_SAMPLES) and place of the n x n pattern. */
#ifndef PASSES_LISTS_H
#define PASSES_LISTS_H

#include "gl/buffer.h"
#include "gl/pass.h"
#include "gl/texture.h"

struct pixel_lists {
    struct texture
        pixels; /* R32UI, x | y << 16, in tiles, twice as large as a picture's; a list fills its tile
                              row by row: of one level from its begin, of the other from the end of its first
                              half, of points from there on */
    struct texture texels;             /* R32UI, of each pixel of the picture its texel in the lists
                              (passes/gather/list_texel.glsl); 0 where no list has it */
    struct texture edge_sample_texels; /* likewise of its edge sample */
    struct buffer counts;              /* of the lists: uint */
    int interleave, tile_width, tile_height;
};

/* From a picture's size to that of the tiles of its lists, all of them: along its shorter side twice as large, as
 * textures have a limit. */
void pixel_lists_size(int size[2], int interleave);

/* What a pass over such RECEIVERS_ binds, for passes/gather/receiver.glsl; lists are not read for all. And the draw
 * of one place's list of a kind, after LOCATION_SLOT is set. */
void pixel_lists_add(struct pass_state *state, const struct pixel_lists *lists, int receivers);
void pixel_lists_draw(const struct pixel_lists *lists, int list);

#endif
