/* Makes area lights of VPL clusters [Prutkin 2012 §5], from the clusters' sums on the GPU.
 *
 * A second scatter of the VPLs sums second moments. Light j then replaces all VPLs of cluster j.
 * It has their mean position and normal and the sum of their fluxes. Its shape is the rectangle
 * with their moments, or a disk of that area. The paper leaves the computation of "spatial extent"
 * open. */
#ifndef PASSES_CLUSTER_LIGHT_H
#define PASSES_CLUSTER_LIGHT_H

#include "passes/vpls.h"

struct frame;

struct cluster_light_desc {
    int count; /* J */
    int form;  /* LIGHT_FORM_... (shared/gather.h) */
};

struct cluster_light_pass {
    struct cluster_light_desc desc;
    GLuint moment_program, light_program, rectangle_program;
    struct texture squares, products; /* J x 1, RGBA32F */
    GLuint framebuffer;
    struct vpl_buffer lights;
    struct buffer rectangles; /* struct light_rectangle, for BLOCK_LIGHT_RECTANGLES */
};

bool cluster_light_pass_init(struct cluster_light_pass *pass,
                             const struct cluster_light_desc *desc);
void cluster_light_pass_free(struct cluster_light_pass *pass);

/* Makes lights of VPLs with C(i) and their clusters' `means`. Timer "lights of clusters". */
void cluster_light_pass_render(const struct cluster_light_pass *pass, const struct frame *frame,
                               const struct vpl_buffer *vpls, const struct val_targets *means);

#endif
