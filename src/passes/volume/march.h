/* Marches rays from the centre of each empty voxel near a surface. The light that they meet is
 * projected to spherical harmonics [Mavridis and Papaioannou 2011 §3.3].
 *
 * Directions are spherical Fibonacci points; the paper has stratified random ones. 27 neighbours
 * have different directions. Each voxel takes the mean over its neighbours, which lowers noise; the
 * paper does not average. Occupied voxels have no coefficients, because no surface reads them; the
 * paper's have some. */
#ifndef PASSES_MARCH_H
#define PASSES_MARCH_H

#include "gl/pass.h"

struct frame;
struct volume;

struct march_pass {
    GLuint program, smooth_program;
};

/* Light that leaves voxels: the volume's own sums, or those of a bounce. */
struct march_inputs {
    const struct texture *radiosity, *back, *turned_radiosity;
};

/* Makes the pass for volumes like `volume`. Error: shader. */
bool march_pass_init(struct march_pass *pass, const struct volume *volume);
void march_pass_free(struct march_pass *pass);

/* Fills the volume's coefficients. Timers "march", "smooth". */
void march_pass_render(const struct march_pass *pass, const struct frame *frame,
                       const struct volume *volume, const struct buffer *params,
                       const struct march_inputs *inputs);

#endif
