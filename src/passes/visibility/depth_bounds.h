/* Builds a pyramid of nearest and farthest depths in squares of depth maps [Dong 2011 §7.3.3].
 * Four fetches bound the depths in any window. */
#ifndef PASSES_DEPTH_BOUNDS_H
#define PASSES_DEPTH_BOUNDS_H

#include "passes/maps.h"

struct frame;

enum { DEPTH_BOUNDS_LEVELS_MAX = 16 };

struct depth_bounds_pass {
    GLuint first_program, more_program;
    struct depth_bounds maps;
    struct buffer params[DEPTH_BOUNDS_LEVELS_MAX];
};

/* Makes the pass for `count` maps of size x size texels, size >= 2. */
bool depth_bounds_pass_init(struct depth_bounds_pass *pass, int size, int count);
void depth_bounds_pass_free(struct depth_bounds_pass *pass);

/* Fills pass->maps from `depth`. Timer "depth bounds". */
void depth_bounds_pass_render(const struct depth_bounds_pass *pass, const struct frame *frame,
                              const struct texture *depth);

#endif
