/* Virtual area lights, for techniques that test visibility by them [Dong 2009 §5]. They are
 * clusters of VPLs, each with a depth map, and with its visible fraction at blocks of pixels. */
#ifndef TECHNIQUES_VALS_H
#define TECHNIQUES_VALS_H

#include "passes/lights/cluster.h"
#include "passes/lights/vpl_weight.h"
#include "passes/visibility/basis.h"
#include "passes/visibility/block_visibility.h"
#include "passes/visibility/paraboloid.h"
#include "techniques/many_lights.h"

/* Rays in place of maps. Only clustered reads it. */
enum { TRACE_OFF, TRACE_AUTO, TRACE_ON };

struct vals_settings {
    int trace; /* TRACE_... */
    int vals;  /* M */
    int bounce_vals;
    int iterations;
    int start;                            /* enum cluster_start */
    float weight_position, weight_normal; /* w_x, w_alpha */
    int visibility;                       /* enum visibility_kind */
    int visibility_block;                 /* side of a block, pixels; 0: each pixel tests its own */
};

/* Settings of VALs, under the name of their first technique: "clustered". */
extern const struct settings_part vals_part;

/* VALs of one set of VPLs. */
struct val_set {
    struct vpl_weight_pass weight; /* with VPLs weighted by importance */
    struct cluster_pass cluster;   /* VPLs with C(i) */
    struct paraboloid_pass paraboloid;
    struct basis_pass basis;
    int block; /* side of a visibility block, pixels; 0: each pixel tests its own */
    struct block_visibility_pass blocks; /* if `block` is not 0 */
    bool convolve;
    struct visibility_desc visibility; /* lookup of a whole VAL */
};

struct vals {
    bool by_importance;          /* VALs depend on the camera */
    struct val_set first, later; /* VALs of the first bounce; of later ones, if any */
    struct val_output output;    /* output of the first bounce */
};

/* True if clustered tests visibility by rays, which need no VALs. */
bool vals_by_rays(const struct settings *settings, const struct scene *scene,
                  const struct geometry *geometry);

/* Returns the lookup of a VPL's visibility in maps. */
enum visibility_lookup vals_lookup(const struct settings *settings);

/* Makes the VALs, as technique->init; the caller calls vals_free after an error. follow: VALs may
 * depend on the camera if the settings allow it (vals->by_importance). */
bool vals_init(struct vals *vals, const struct technique_desc *desc, bool follow);
void vals_free(struct vals *vals);

/* Resizes the VALs and the lights, as technique->resize. */
bool vals_resize(struct vals *vals, struct many_lights *lights, int width, int height);

/* Renders the VALs of all bounces. Call it after many_lights_render_vpls: for each view with its
 * G-buffer if vals->by_importance, else once without a G-buffer. */
void vals_render(struct vals *vals, struct many_lights *lights, const struct frame *frame,
                 const struct gbuffer *gbuffer);

/* Renders block visibility if enabled. Returns the inputs of a gather: VPLs with C(i), maps,
 * blocks. */
struct gather_inputs vals_render_blocks(const struct val_set *set, const struct frame *frame,
                                        const struct gbuffer *gbuffer);

/* Implements technique->outputs. */
void vals_outputs(const struct vals *vals, struct output_list *outputs);

#endif
