/* Finds how far each voxel is from the nearest occupied one: which voxels surfaces read, and over how many rays leap. */
#ifndef PASSES_DISTANCE_H
#define PASSES_DISTANCE_H

#include "gl/pass.h"

struct frame;
struct volume;

struct distance_pass {
    GLuint programs[3]; /* for each axis */
    GLuint neighbour_program;
};

/* For volumes like that one. Error: shader. */
bool distance_pass_init(struct distance_pass *pass, const struct volume *volume);
void distance_pass_free(struct distance_pass *pass);

/* Fills volume->distances. Timer "distances". */
void distance_pass_render(const struct distance_pass *pass, const struct frame *frame,
                          const struct volume *volume, const struct buffer *params);

#endif
