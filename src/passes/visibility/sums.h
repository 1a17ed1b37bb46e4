/* Summed area tables of the moments of maps of depth, or of their Fourier bases: the mean over any box by four fetches
 * [Crow 1984; Dong 2011 §5.3.1, §7.4]. Integers, which are exact where floats lose what filters need [Lauritzen 2007]. */
#ifndef PASSES_SUMS_H
#define PASSES_SUMS_H

#include "passes/maps.h"

struct frame;

struct sums_desc {
    int size, count; /* of the maps */
    int moments;     /* 2 or 4; 0: bases */
    int terms;       /* of these, K */
};

struct sums_pass {
    GLuint rows_program, columns_program;
    struct sum_maps maps;
};

bool sums_pass_init(struct sums_pass *pass, const struct sums_desc *desc);
void sums_pass_free(struct sums_pass *pass);

/* From depth, of values in [0, 1], to pass->maps. ranges: of bases, struct series_range, one a map. Timer "sums". */
void sums_pass_render(const struct sums_pass *pass, const struct frame *frame,
                      const struct texture *depth, const struct buffer *ranges);

#endif
