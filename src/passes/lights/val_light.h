/* Shows the VALs at each pixel: the VAL that lights it most, and the visible fraction of all VALs'
 * light. Each VAL counts as one disk of its extent at its centre. */
#ifndef PASSES_VAL_LIGHT_H
#define PASSES_VAL_LIGHT_H

#include "passes/visibility/visibility.h"

struct frame;
struct gbuffer;

struct val_light_pass {
    struct visibility_desc desc;
    GLuint program;
    struct buffer lookup_params;
};

bool val_light_pass_init(struct val_light_pass *pass, const struct visibility_desc *desc);
void val_light_pass_free(struct val_light_pass *pass);

/* Writes the strongest VAL's colour, and the fraction as alpha, into a target of the G-buffer's
 * size. */
void val_light_pass_render(const struct val_light_pass *pass, const struct frame *frame,
                           const struct gbuffer *gbuffer, const struct visibility_inputs *inputs,
                           const struct texture *val_fluxes, GLuint framebuffer);

#endif
