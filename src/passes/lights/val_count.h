/* How many VALs the light needs, and where they begin: on the GPU, of the VPLs of this frame alone.
 *
 * VPLs lie on surfaces, so that the mean distance to their VAL, by the clustering's criterion, falls as the root
 * of the number of VALs. A probe of few clusters tells it for one number, and by that the number for the distance asked
 * for. The VPLs that VALs begin at are Halton's first ones, the same whatever their number: one VAL more or less
 * leaves the others where they are.
 */
#ifndef PASSES_VAL_COUNT_H
#define PASSES_VAL_COUNT_H

#include "passes/frame.h"
#include "shared/cluster.h"

struct val_count_desc {
    int most;                             /* VALs */
    float distortion;                     /* mean distance of a VPL to its VAL that is asked for */
    float weight_position, weight_normal; /* as struct cluster_desc's, of lengths */
};

struct val_count_pass {
    struct val_count_desc desc;
    GLuint measure_program, seed_program;
    struct texture probe_seeds, distances,
        seeds; /* R32F; RGBA32F, a pixel; R32F: as struct cluster_desc's */
    GLuint distance_framebuffer, seed_framebuffer;
    struct buffer params;
};

bool val_count_pass_init(struct val_count_pass *pass, const struct val_count_desc *desc);
void val_count_pass_free(struct val_count_pass *pass);

/* Fills pass->seeds, by the centres of VAL_PROBES clusters of the VPLs that began at pass->probe_seeds. Timer
 * "val count". */
void val_count_pass_render(const struct val_count_pass *pass, const struct frame *frame,
                           const struct vpl_buffer *vpls, const struct val_targets *probes);

#endif
