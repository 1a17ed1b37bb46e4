/* Direct light with a hard shadow map [Dong 2009 §6].
 *
 * The lookup compares the four nearest texels and weights the results, so that the shadow's edge is
 * a texel wide and not stepped.
 */
#ifndef PASSES_DIRECT_H
#define PASSES_DIRECT_H

#include "passes/frame.h"

struct direct_desc {
    int width, height;
    float bias; /* receiver offset along its normal, in shadow texels */
};

struct direct_pass {
    struct direct_desc desc;
    GLuint program;
    struct texture
        direct; /* R32F: irradiance over intensity (W/m2 per W/sr), times light.direct_scale */
    GLuint framebuffer;
    struct buffer params;
};

bool direct_pass_init(struct direct_pass *pass, const struct direct_desc *desc);
void direct_pass_free(struct direct_pass *pass);

/* From the depth that each light view sees, a layer each. Timer "direct". */
void direct_pass_render(const struct direct_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct texture *shadow_map);

#endif
