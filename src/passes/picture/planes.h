/* Of each block of PLANE_BLOCK x PLANE_BLOCK pixels the plane that they lie on, and how far they are off it: found once,
 * for all that spares what lies on one. A pixel costs two fetches. */
#ifndef PASSES_PLANES_H
#define PASSES_PLANES_H

#include "passes/targets.h"

struct frame;

struct planes_pass {
    GLuint program, framebuffer;
    struct block_planes planes;
};

/* For pictures of that size. Error: shaders; memory. */
bool planes_pass_init(struct planes_pass *pass, int width, int height);
void planes_pass_free(struct planes_pass *pass);

/* Fills pass->planes. Timer "planes". */
void planes_pass_render(const struct planes_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer);

#endif
