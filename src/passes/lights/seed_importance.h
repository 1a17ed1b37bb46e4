/* Chooses initial cluster centres by the VPLs' contribution to the picture: bidirectional
 * importance [Prutkin 2012 §4; Ritschel et al. 2011].
 *
 * VPLs add their importance to cells of the unit square of their points, which by flux is their
 * light's domain. The cells warp Halton points. Seeds depend on the camera. Cost: VPLs x 256
 * pixels. */
#ifndef PASSES_SEED_IMPORTANCE_H
#define PASSES_SEED_IMPORTANCE_H

#include "gl/buffer.h"
#include "gl/texture.h"

struct frame;
struct gbuffer;
struct vpl_buffer;

struct seed_importance_desc {
    int count;         /* of clusters */
    float clamp_value; /* bound of the geometry term, times the squared scene radius */
};

struct seed_importance_pass {
    struct seed_importance_desc desc;
    GLuint value_program, number_program, seed_program;
    struct texture values, numbers; /* R32F, one texel a cell */
    GLuint value_framebuffer, number_framebuffer;
    struct texture seeds; /* count x 1, R32F: VPL numbers, or -1 */
    GLuint seed_framebuffer;
    struct buffer params;
};

bool seed_importance_pass_init(struct seed_importance_pass *pass,
                               const struct seed_importance_desc *desc);
void seed_importance_pass_free(struct seed_importance_pass *pass);

/* Fills pass->seeds. `points` is a vertex array with ATTRIBUTE_VPL_POINT (passes/lights/vpl.h).
 * Timer "importance". */
void seed_importance_pass_render(const struct seed_importance_pass *pass, const struct frame *frame,
                                 const struct gbuffer *gbuffer, const struct vpl_buffer *vpls,
                                 GLuint points);

#endif
