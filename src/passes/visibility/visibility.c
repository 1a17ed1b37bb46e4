#include "passes/visibility/visibility.h"

#include "base/memory.h"
#include "passes/maps.h"
#include "shared/maps.h"

#include <math.h>

char *visibility_defines(const struct visibility_desc *desc) {
    int terms = desc->basis_terms > 0 ? desc->basis_terms : 1;
    bool jacobian = desc->lookup != VISIBILITY_LOOKUP_CSSM;
    /* Other programs serve any number of maps. */
    int count = desc->lookup == VISIBILITY_LOOKUP_CSSM ? desc->map_count : 0;
    return mem_printf("FILTER %d;MAP_COUNT %d;BASIS_TERMS %d;BASIS_GROUPS %d;JACOBIAN %d;"
                      "FILTER_TAPS %d;SEARCH_TAPS %d",
                      desc->lookup, count, terms, (terms + 3) / 4, jacobian, desc->taps,
                      (desc->taps + 1) / 2);
}

static void add_maps(struct pass_state *state, const struct visibility_desc *desc,
                     const struct visibility_inputs *inputs) {
    if (desc->lookup == VISIBILITY_LOOKUP_NONE)
        return;
    if (inputs->views)
        pass_add_block(state, BLOCK_MAPS, &inputs->views->buffer);
    if (desc->lookup == VISIBILITY_LOOKUP_TRACED) {
        pass_add_texture(state, UNIT_BVH, inputs->tree->buffer.texels);
        return;
    }
    if (desc->lookup != VISIBILITY_LOOKUP_CSSM) {
        pass_add_texture(state, UNIT_MAP_DEPTH, inputs->depth->depth.id);
        if (desc->lookup == VISIBILITY_LOOKUP_PLANE)
            pass_add_texture(state, UNIT_MAP_NORMAL, inputs->depth->normal.id);
        return;
    }
    pass_add_block(state, BLOCK_SERIES_RANGES, &inputs->bases->ranges);
    pass_add_texture(state, UNIT_BASIS_COS, inputs->bases->cos.id);
    pass_add_texture(state, UNIT_BASIS_SIN, inputs->bases->sin.id);
    pass_add_texture(state, UNIT_BASIS_Z_COS, inputs->bases->z_cos.id);
    pass_add_texture(state, UNIT_BASIS_Z_SIN, inputs->bases->z_sin.id);
    pass_add_texture(state, UNIT_BASIS_Z, inputs->bases->z.id);
}

void visibility_add(struct pass_state *state, const struct visibility_desc *desc,
                    const struct buffer *params, const struct visibility_inputs *inputs) {
    struct lookup_params values = {
        .bias = desc->bias,
        .map_size = (float)desc->map_size,
        .map_bias = desc->map_bias,
        .shift = desc->shift / (2 * fmaxf((float)desc->basis_terms, 1)),
        .gain = desc->gain,
        .map_count = desc->map_count,
    };
    buffer_write(params, 0, sizeof values, &values);
    pass_add_block(state, BLOCK_LOOKUP, params);
    add_maps(state, desc, inputs);
}
