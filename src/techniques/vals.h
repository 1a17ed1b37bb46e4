/* Virtual area lights, for all techniques to which they say what light arrives [Dong 2009 §5]: clusters of
 * VPLs, maps of what is seen from each, and which part of a VAL's light arrives at blocks of pixels. */
#ifndef TECHNIQUES_VALS_H
#define TECHNIQUES_VALS_H

#include "passes/lights/cluster.h"
#include "passes/lights/vpl_weight.h"
#include "passes/visibility/basis.h"
#include "passes/visibility/block_visibility.h"
#include "passes/visibility/paraboloid.h"
#include "techniques/many_lights.h"

/* Whether rays test visibility in place of maps; clustered alone reads it. */
enum { TRACE_OFF, TRACE_AUTO, TRACE_ON };

struct vals_settings {
    int trace; /* TRACE_... */
    int vals;  /* M */
    int bounce_vals;
    int iterations;
    int start;                            /* enum cluster_start */
    float weight_position, weight_normal; /* w_x, w_alpha */
    int visibility;                       /* enum visibility_kind */
    int visibility_block;                 /* pixels a side; 0 = each pixel looks itself up */
};

/* Called as the technique that they were made for: "clustered". */
extern const struct settings_part vals_part;

/* Those of some VPLs. */
struct val_set {
    struct vpl_weight_pass weight; /* where VPLs count by importance */
    struct cluster_pass cluster;   /* has the VPLs with their VALs' numbers */
    struct paraboloid_pass paraboloid;
    struct basis_pass basis;
    int block; /* pixels a side, of any picture; 0: each pixel looks itself up */
    struct block_visibility_pass blocks; /* where it is not 0 */
    bool convolve;
    struct visibility_desc visibility; /* of a VAL as a whole */
};

struct vals {
    bool by_importance;          /* what the camera sees changes them */
    struct val_set first, later; /* of the first bounce; of later ones, where there are any */
    struct val_output output;    /* of the first */
};

/* Whether clustered tests visibility by rays, which need no VALs. */
bool vals_by_rays(const struct settings *settings, const struct scene *scene,
                  const struct geometry *geometry);

/* How a pixel asks for a VPL's visibility by maps. */
enum visibility_lookup vals_lookup(const struct settings *settings);

/* Like a technique's; what a failed init leaves is to be freed. follow: the settings may have them made for what the camera
 * sees (vals->by_importance). */
bool vals_init(struct vals *vals, const struct technique_desc *desc, bool follow);
void vals_free(struct vals *vals);

/* As technique->resize, of the lights too. */
bool vals_resize(struct vals *vals, struct many_lights *lights, int width, int height);

/* Of all bounces, which are made with it: after many_lights_render_vpls. Where they are by importance in each view, for what it
 * sees; else once for all views, and without a G-buffer. */
void vals_render(struct vals *vals, struct many_lights *lights, const struct frame *frame,
                 const struct gbuffer *gbuffer);

/* Draws visibility by blocks, where it is shared, and returns what a gather reads: VPLs with their VALs' numbers, maps,
 * blocks. */
struct gather_inputs vals_render_blocks(const struct val_set *set, const struct frame *frame,
                                        const struct gbuffer *gbuffer);

/* As technique->outputs. */
void vals_outputs(const struct vals *vals, struct output_list *outputs);

#endif
