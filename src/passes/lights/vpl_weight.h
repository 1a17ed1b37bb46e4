/* How much VPLs count in the means of clusters: by what they would give to the picture where nothing
 * is between, which is importance [Prutkin 2012 §4; Ritschel et al. 2011]. Most VPLs of a lamp next door, of a sky, or of further
 * bounces give nothing to what the camera sees; where all count alike most VALs are theirs. What is between is not asked:
 * rays told no more (docs/notes/clustering.md). It depends on the camera. Cost: VPLs x 64 pixels.
 */
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
