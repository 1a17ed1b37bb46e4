/* Cuts through a tree over VPLs, one for each block of pixels: as few nodes as stand for all VPLs with an error that a
 * bound keeps small at every point of the block [Walter et al. 2006; Lin and Yuksel 2020].
 *
 * The bound is that of the geometry term, between the box of the block's points with the cone of their normals and
 * those of the node. Visibility counts as 1. Cost: blocks x nodes^2.
 */
#ifndef PASSES_VPL_CUT_H
#define PASSES_VPL_CUT_H

#include "passes/vpls.h"

struct frame;
struct gbuffer;

struct vpl_cut_desc {
    int width, height; /* of the picture */
    int block;         /* pixels a side */
    int nodes;         /* at most; of pixels of lists CUT_NODES_MAX */
    float tolerance;   /* of a node's error, over the sum that is not shadowed */
    int clamp;         /* GATHER_CLAMP_...; balls count as disks */
    float clamp_value; /* as in struct gather_desc */
    bool later;        /* VPLs of later bounces come too */
    int later_clamp;   /* theirs */
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
