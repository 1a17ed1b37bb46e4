/* Visibility lookups of the gather and the block visibility. */
#ifndef PASSES_VISIBILITY_H
#define PASSES_VISIBILITY_H

#include "gl/pass.h"
#include "scene/gpu/caster_bvh.h"
#include "shared/maps.h"

struct basis_maps;
struct depth_maps;
struct map_views;

enum visibility_lookup {
    VISIBILITY_LOOKUP_NONE = FILTER_NONE,
    VISIBILITY_LOOKUP_HARD = FILTER_HARD,
    VISIBILITY_LOOKUP_CSSM = FILTER_CSSM,
    VISIBILITY_LOOKUP_PCSS = FILTER_PCSS,
    VISIBILITY_LOOKUP_RAY = FILTER_RAY,     /* tests the segment to the VPL through its VAL's map */
    VISIBILITY_LOOKUP_PLANE = FILTER_PLANE, /* reads maps with planes */
    VISIBILITY_LOOKUP_TRACED = FILTER_TRACED, /* traces the scene's triangles, without maps */
};

struct visibility_desc {
    enum visibility_lookup lookup;
    int map_size, map_count, basis_terms;
    float bias;     /* receiver offset along its normal, in texels of the map */
    float map_bias; /* bias of distance comparisons, over the distance */
    float shift;    /* shift of the receiver's depth, over 1 / (2 K) */
    float gain;     /* gain of the blocked fraction about one half */
    int taps;       /* taps of a PCSS filter; its blocker search has half as many */
};

/* Inputs of a lookup. */
struct visibility_inputs {
    const struct map_views *views;
    const struct depth_maps *depth; /* required except for CSSM and TRACED */
    const struct basis_maps *bases; /* required for CSSM */
    const struct caster_bvh *tree;  /* required for TRACED */
};

/* Most rays of a pixel in one draw with VISIBILITY_LOOKUP_TRACED. */
enum { RAYS_MAX = 32 };

/* Returns defines for passes/visibility/visibility.glsl. The caller frees them. */
char *visibility_defines(const struct visibility_desc *desc);

/* Uploads the parameters into `params` and binds them with the maps. */
void visibility_add(struct pass_state *state, const struct visibility_desc *desc,
                    const struct buffer *params, const struct visibility_inputs *inputs);

#endif
