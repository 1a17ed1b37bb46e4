#include "passes/lists.h"

#include "shared/gather.h"

void pixel_lists_size(int size[2], int interleave) {
    int shorter = size[0] < size[1] ? 0 : 1;
    for (int axis = 0; axis < 2; axis++)
        size[axis] = (size[axis] + interleave - 1) / interleave * interleave;
    size[shorter] *= 2;
}

void pixel_lists_add(struct pass_state *state, const struct pixel_lists *lists, int receivers,
                     const struct texture *edge_samples) {
    if (receivers == RECEIVERS_OTHERS)
        pass_add_texture(state, UNIT_LIST_TEXELS, lists->texels.id);
    if (receivers != RECEIVERS_ADAPTIVE)
        return;
    pass_add_texture(state, UNIT_ADAPTIVE_PIXELS, lists->pixels.id);
    pass_add_texture(state, UNIT_EDGE_SAMPLES, edge_samples->id);
    pass_add_block(state, BLOCK_LIST_COUNTS, &lists->counts);
}

void pixel_lists_draw(const struct pixel_lists *lists, int list) {
    pass_set_ints(LOCATION_TILE, lists->tile_width, lists->tile_height, lists->interleave, list);
    pass_draw_part(list, 6);
}
