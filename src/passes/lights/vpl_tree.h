/* Builds a perfect binary tree over each frame's VPLs [Walter et al. 2005; Lin and Yuksel 2020].
 *
 * VPLs are sorted along a Z-order curve of positions and normals. Then each level gets the bounds
 * of its nodes and a representative VPL. A node has the power of all its VPLs. Each set of pixels
 * has its own representatives, chosen by flux, so the mean over neighbouring pixels is that of many
 * VPLs. Cost: N log^2 N to sort, and sets x N. */
#ifndef PASSES_VPL_TREE_H
#define PASSES_VPL_TREE_H

#include "passes/vpls.h"

struct frame;

struct vpl_tree_desc {
    int vpl_count, sets;
};

struct vpl_tree_pass {
    struct vpl_tree_desc desc;
    GLuint keys_program, sort_program, leaves_program, nodes_program, representatives_program;
    GLuint representatives_framebuffer;
    struct buffer keys, params;
    struct vpl_tree tree;
};

bool vpl_tree_pass_init(struct vpl_tree_pass *pass, const struct vpl_tree_desc *desc);
void vpl_tree_pass_free(struct vpl_tree_pass *pass);

/* Builds pass->tree, which also refers to the VPLs. Timer "tree". */
void vpl_tree_pass_render(struct vpl_tree_pass *pass, const struct frame *frame,
                          const struct vpl_buffer *vpls);

#endif
