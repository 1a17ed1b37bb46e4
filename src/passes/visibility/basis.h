/* Renders Fourier bases of the depth maps with mip levels, which make a filtered shadow test one
 * lookup [Dong 2011 §5.2, §5.3.1; Dong 2009 §6]. */
#ifndef PASSES_BASIS_H
#define PASSES_BASIS_H

#include "passes/maps.h"

struct frame;

struct basis_desc {
    int size, count;
    int terms;         /* K, 1 to 16 */
    bool ranges_alone; /* renders only ranges, for passes/visibility/sums.h */
};

struct basis_pass {
    GLuint range_program, program; /* `program` is 0 with desc.ranges_alone */
    GLuint first_framebuffer;      /* all five targets */
    GLuint more_framebuffer; /* targets of further groups: without z, which has one layer a map */
    struct basis_maps maps;
    struct buffer params[4]; /* one a group */
};

/* The Fourier series of a step at 0, 1/2 + 2 sum_k sin(c_k t) / c_k [Dong 2011 §5.2]. `zero` is
 * its last root before the step, `full` its minimum after the peak; between it is almost linear. */
struct series_step {
    double zero, full;
};
struct series_step series_step_of(int terms);

bool basis_pass_init(struct basis_pass *pass, const struct basis_desc *desc);
void basis_pass_free(struct basis_pass *pass);

/* Renders pass->maps from `depth`. Timers "range", "basis", "mips". */
void basis_pass_render(const struct basis_pass *pass, const struct frame *frame,
                       const struct texture *depth);

#endif
