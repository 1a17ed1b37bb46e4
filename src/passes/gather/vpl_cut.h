/* Finds a cut through the VPL tree for each block of pixels [Walter et al. 2006; Lin and Yuksel
 * 2020]. Its few nodes replace all VPLs with a bounded error at every point of the block.
 *
 * The bound is that of the geometry term between the block and the node, each with a bounding box
 * and a normal cone. Visibility counts as 1. Cost: blocks x nodes^2. */
#ifndef PASSES_VPL_CUT_H
#define PASSES_VPL_CUT_H

#include "passes/vpls.h"

struct frame;
struct gbuffer;

struct vpl_cut_desc {
    int width, height; /* of the picture */
    int block;         /* side of a block, pixels */
    int nodes;         /* most nodes of a cut; list pixels have CUT_NODES_MAX */
    float tolerance;   /* error of a node, over the unshadowed sum */
    int clamp;         /* GATHER_CLAMP_...; balls count as disks */
    float clamp_value; /* as in struct gather_desc */
    bool later;        /* also cuts VPLs of later bounces */
    int later_clamp;   /* GATHER_CLAMP_... of later bounces */
};

struct vpl_cut_pass {
    struct vpl_cut_desc desc;
    GLuint program, later_program;
    struct vpl_cuts cuts;
    struct buffer params;
};

bool vpl_cut_pass_init(struct vpl_cut_pass *pass, const struct vpl_cut_desc *desc);
void vpl_cut_pass_free(struct vpl_cut_pass *pass);

/* Fills pass->cuts. Timer "cuts". */
void vpl_cut_pass_render(struct vpl_cut_pass *pass, const struct frame *frame,
                         const struct gbuffer *gbuffer, const struct vpl_tree *tree, bool later);

#endif
