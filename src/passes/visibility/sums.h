/* Builds summed-area tables of moments or Fourier bases of depth maps. Four fetches give the mean
 * over any box [Crow 1984; Dong 2011 §5.3.1, §7.4]. Integer sums are exact; floats lose the
 * precision that filters need [Lauritzen 2007]. */
#ifndef PASSES_SUMS_H
#define PASSES_SUMS_H

#include "passes/maps.h"

struct frame;

struct sums_desc {
    int size, count; /* of the maps */
    int moments;     /* 2 or 4; 0: Fourier bases */
    int terms;       /* K of the bases */
};

struct sums_pass {
    GLuint rows_program, columns_program;
    struct sum_maps maps;
};

bool sums_pass_init(struct sums_pass *pass, const struct sums_desc *desc);
void sums_pass_free(struct sums_pass *pass);

/* Fills pass->maps from depths in [0, 1]. `ranges` holds a struct series_range a map, for bases.
 * Timer "sums". */
void sums_pass_render(const struct sums_pass *pass, const struct frame *frame,
                      const struct texture *depth, const struct buffer *ranges);

#endif
