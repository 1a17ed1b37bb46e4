/* How passes look up the maps: what the gather and the block visibility have in common. */
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
    VISIBILITY_LOOKUP_RAY = FILTER_RAY,       /* to the VPL itself, through its VAL's map */
    VISIBILITY_LOOKUP_PLANE = FILTER_PLANE,   /* of maps with planes */
    VISIBILITY_LOOKUP_TRACED = FILTER_TRACED, /* of no map: through the scene's triangles */
};

struct visibility_desc {
    enum visibility_lookup lookup;
    int map_size, map_count, basis_terms;
    float bias;     /* receiver offset along its normal, in texels of the map */
    float map_bias; /* where distances are compared, of the distance */
    float shift;    /* of the receiver's depth, over 1 / (2 K) */
    float gain;     /* of the blocked fraction about one half */
    int taps;       /* of a PCSS lookup: the filter's; the search has half as many */
};

/* What a lookup reads. */
struct visibility_inputs {
    const struct map_views *views;
    const struct depth_maps *depth; /* all but ..._CSSM and ..._TRACED */
    const struct basis_maps *bases; /* ..._CSSM */
    const struct caster_bvh *tree;  /* ..._TRACED */
};

/* No shader asks for more by ..._TRACED in one draw. */
enum { RAYS_MAX = 32 };

/* Defines for a shader that includes passes/visibility/visibility.glsl; to be freed. */
char *visibility_defines(const struct visibility_desc *desc);

/* Uploads the parameters, and adds them and the maps to what the pass binds. */
void visibility_add(struct pass_state *state, const struct visibility_desc *desc,
                    const struct buffer *params, const struct visibility_inputs *inputs);

#endif
