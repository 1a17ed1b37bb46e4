/* Finds plain pixels: one plane is all that blur and lists see around them, out to where the blur reaches, and around
 * each pixel there.
 *
 * Blocks of pixels are compared (passes/picture/planes.h). What lies on no plane or bends by more than a degree is not
 * plain, whatever the blur takes for alike.
 */
#ifndef PASSES_PLAIN_H
#define PASSES_PLAIN_H

#include "gl/buffer.h"
#include "gl/texture.h"

struct frame;

struct plain_desc {
    int width, height;
    int radius;             /* out to so many pixels along x and y */
    float distance, cosine; /* as in struct blur_desc */
};

struct plain_pass {
    struct plain_desc desc;
    GLuint around_program, erode_program, program;
    struct texture
        blocks[2]; /* 1 where it and those around it lie on one plane; where all of these are so */
    struct texture pixels; /* depth: 0 where plain, else 1 */
    GLuint block_framebuffers[2], framebuffer;
    struct buffer params;
};

bool plain_pass_init(struct plain_pass *pass, const struct plain_desc *desc);
void plain_pass_free(struct plain_pass *pass);

/* Fills pass->pixels. Timer "plain". */
void plain_pass_render(const struct plain_pass *pass, const struct frame *frame);

#endif
