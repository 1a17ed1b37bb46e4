/* Marches rays from the middle of each empty voxel near a surface, through the voxels, and keeps what they meet as
 * spherical harmonics [Mavridis and Papaioannou 2011 §3.3].
 *
 * Directions are spherical Fibonacci points, which the paper has as stratified random ones. 27 neighbours have different
 * ones, and each voxel takes the mean over its neighbours, which the paper does not: the noise of few rays becomes that
 * of many. Occupied voxels have no coefficients, which the paper's have: no surface reads them. */
#ifndef PASSES_MARCH_H
#define PASSES_MARCH_H

#include "gl/pass.h"

struct frame;
struct volume;

struct march_pass {
    GLuint program, smooth_program;
};

/* What leaves voxels: the volume's own sums, or those of a bounce. */
struct march_inputs {
    const struct texture *radiosity, *back, *turned_radiosity;
};

/* For volumes like that one. Error: shader. */
bool march_pass_init(struct march_pass *pass, const struct volume *volume);
void march_pass_free(struct march_pass *pass);

/* Fills the volume's coefficients. Timers "march", "smooth". */
void march_pass_render(const struct march_pass *pass, const struct frame *frame,
                       const struct volume *volume, const struct buffer *params,
                       const struct march_inputs *inputs);

#endif
