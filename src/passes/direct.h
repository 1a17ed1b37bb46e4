/* Direct light with a hard shadow map [Dong 2009 §6].
 *
 * The map is the light's depth, D32F reversed, one layer a light view. The lookup compares the four
 * nearest texels and weights the results, so that the shadow's edge is a texel wide and not
 * stepped.
 */
#ifndef PASSES_DIRECT_H
#define PASSES_DIRECT_H

#include "passes/frame.h"

struct direct_desc {
    int width, height;
    int shadow_size; /* texels a side; of a cube's faces half as many */
    int light_views;
    float bias; /* receiver offset along its normal, in shadow texels */
};

struct direct_pass {
    struct direct_desc desc;
    GLuint opaque_program, masked_program, direct_program;
    struct texture shadow_map;
    struct texture
        direct; /* R32F: irradiance over intensity (W/m2 per W/sr), times light.direct_scale */
    GLuint shadow_framebuffer, direct_framebuffer;
    struct buffer params;
    int shadow_size;
};

bool direct_pass_init(struct direct_pass *pass, const struct direct_desc *desc);
void direct_pass_free(struct direct_pass *pass);

/* Depth from the light, for any number of cameras. Timer "shadow map". */
void direct_pass_render_shadow_map(const struct direct_pass *pass, const struct frame *frame);

/* What the G-buffer gets of the light. Timer "direct". */
void direct_pass_render(const struct direct_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer);

#endif
