/* Virtual point lights by transform feedback [Dong 2009 §4, §6].
 *
 * Point i reads the reflective shadow map at Halton point i, mapped to the light's own domain: the
 * cone of a spot, the sphere of a point light (uniform in solid angle, each sample stands for Omega
 * / N), the rectangle of a directional light. The papers map a square over the cone and waste 21 %.
 * Reflected flux Phi_i = albedo_i I(w_i) Omega / N, W. A sample that meets nothing has flux 0.
 * The 16 VPLs of an interleave slot are contiguous: aligned runs of the sequence are stratified.
 */
#ifndef PASSES_VPL_H
#define PASSES_VPL_H

#include "passes/frame.h"

struct vpl_desc {
    int count;
    int seed; /* 0 = Halton's points as they are; else shifted on the torus */
};

struct vpl_pass {
    struct vpl_desc desc;
    GLuint program, vertices;
    struct buffer halton, params;
};

bool vpl_pass_init(struct vpl_pass *pass, const struct vpl_desc *desc);
void vpl_pass_free(struct vpl_pass *pass);

/* Fills vpls (C(i) = 0). Timer "vpls". */
void vpl_pass_render(const struct vpl_pass *pass, const struct frame *frame,
                     const struct gbuffer *rsm, const struct vpl_buffer *vpls);

#endif
