/* A perfect binary tree over VPLs, built anew with each frame's: sorted along a Z-order curve of places and normals,
 * then level by level what holds all VPLs below a node, and the one that stands for them [Walter et al. 2005; Lin and
 * Yuksel 2020].
 *
 * Nodes light with the power of all their VPLs. Pixels come in sets, each with VPLs of its own to stand for nodes,
 * picked by flux: the mean over pixels side by side is that of many VPLs. Cost: N log^2 N to sort, and sets x N.
 */
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

/* Fills pass->tree, which reads the VPLs too. Timer "tree". */
void vpl_tree_pass_render(struct vpl_tree_pass *pass, const struct frame *frame,
                          const struct vpl_buffer *vpls);

#endif
