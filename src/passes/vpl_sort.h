/* Sorts VPLs along a Z-order curve of positions and normals, so that neighbours in the order light
 * alike. VPLs without a hit come last. Cost: N log^2 N [Batcher 1968]. */
#ifndef PASSES_VPL_SORT_H
#define PASSES_VPL_SORT_H

#include "passes/vpls.h"

struct frame;

struct vpl_sort {
    GLuint keys_program, sort_program;
    struct buffer keys;   /* sorted; the third number is the VPL's; texel buffer, RGBA32UI */
    struct buffer params; /* struct vpl_tree_params */
    int count, leaves;    /* VPLs; keys, a power of two */
};

bool vpl_sort_init(struct vpl_sort *sort, int count);
void vpl_sort_free(struct vpl_sort *sort);

/* Fills sort->keys and sort->params. vpls: buffer texture of the VPLs. */
void vpl_sort_render(const struct vpl_sort *sort, const struct frame *frame, GLuint vpls);

/* Returns the state of a pass that reads the VPLs, the keys and the parameters. */
struct pass_state vpl_sort_state(const struct vpl_sort *sort, GLuint program, GLuint vpls);

/* Dispatches so many invocations in groups of TREE_GROUP. */
void vpl_sort_dispatch(int invocations);

#endif
