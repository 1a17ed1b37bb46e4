/* Fourier bases of the depth maps with MIP maps: what makes a filtered shadow test a lookup
 * [Dong 2011 §5.2, §5.3.1; Dong 2009 §6]. */
#ifndef PASSES_BASIS_H
#define PASSES_BASIS_H

#include "passes/maps.h"

struct frame;

struct basis_desc {
    int size, count;
    int terms;         /* K, 1 to 16 */
    bool ranges_alone; /* no bases: passes/visibility/sums.h adds them up */
};

struct basis_pass {
    GLuint range_program, program; /* without the second ranges alone */
    GLuint first_framebuffer;      /* all five targets */
    GLuint more_framebuffer; /* further groups of terms: without z, which has a layer a map only */
    struct basis_maps maps;
    struct buffer params[4]; /* one a group */
};

/* The series of a step at 0 with so many terms, 1/2 + 2 sum_k sin(c_k t) / c_k [Dong 2011 §5.2]: the place before it
 * where it is 0 for the last time, and the least that it is behind its peak. What lies between the two is a straight line,
 * or nearly. */
struct series_step {
    double zero, full;
};
struct series_step series_step_of(int terms);

bool basis_pass_init(struct basis_pass *pass, const struct basis_desc *desc);
void basis_pass_free(struct basis_pass *pass);

/* From depth to pass->maps. Timers "range", "basis", "mips". */
void basis_pass_render(const struct basis_pass *pass, const struct frame *frame,
                       const struct texture *depth);

#endif
