/* Finds each voxel's distance to the nearest occupied voxel, to select the voxels that surfaces
 * read and to let rays skip empty space. */
#ifndef PASSES_DISTANCE_H
#define PASSES_DISTANCE_H

#include "gl/pass.h"

struct frame;
struct volume;

struct distance_pass {
    GLuint programs[3]; /* one an axis */
    GLuint neighbour_program;
};

/* Makes the pass for volumes like `volume`. Error: shader. */
bool distance_pass_init(struct distance_pass *pass, const struct volume *volume);
void distance_pass_free(struct distance_pass *pass);

/* Fills volume->distances. Timer "distances". */
void distance_pass_render(const struct distance_pass *pass, const struct frame *frame,
                          const struct volume *volume, const struct buffer *params);

#endif
