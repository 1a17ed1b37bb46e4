/* Weights VPLs in the means of clusters by their unoccluded contribution to the picture, their
 * importance [Prutkin 2012 §4; Ritschel et al. 2011].
 *
 * Most VPLs of a lamp next door, an environment or later bounces light nothing visible. With equal
 * weights they would take most VALs. Visibility is not tested, because rays do not improve the
 * result (docs/notes/clustering.md). Weights depend on the camera. Cost: VPLs x 64 pixels. */
#ifndef PASSES_VPL_WEIGHT_H
#define PASSES_VPL_WEIGHT_H

#include "passes/vpls.h"

struct frame;
struct gbuffer;

struct vpl_weight_pass {
    GLuint program, sum_program;
    struct vpl_weights weights;
    GLuint value_framebuffer, sum_framebuffer;
};

bool vpl_weight_pass_init(struct vpl_weight_pass *pass, int vpl_count);
void vpl_weight_pass_free(struct vpl_weight_pass *pass);

/* Fills pass->weights. Timer "importance". */
void vpl_weight_pass_render(const struct vpl_weight_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct vpl_buffer *vpls);

#endif
