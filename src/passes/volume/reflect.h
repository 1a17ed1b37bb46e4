/* Computes the radiosity of a volume's surfaces after a bounce: their direct light, plus reflected
 * light of the last march [Mavridis and Papaioannou 2011 §3.3]. */
#ifndef PASSES_REFLECT_H
#define PASSES_REFLECT_H

#include "gl/pass.h"
#include "gl/texture.h"

struct frame;
struct volume;

struct reflect_pass {
    GLuint program;
    struct texture radiosity, turned, back; /* as in struct volume */
    GLuint framebuffer;
};

/* Makes the pass for volumes like `volume`. Error: shader, or out of GPU memory. */
bool reflect_pass_init(struct reflect_pass *pass, const struct volume *volume);
void reflect_pass_free(struct reflect_pass *pass);

/* Fills pass->radiosity, turned and back from the volume's coefficients. Timer "reflect". */
void reflect_pass_render(const struct reflect_pass *pass, const struct frame *frame,
                         const struct volume *volume, const struct buffer *params);

#endif
