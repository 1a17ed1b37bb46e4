/* Depth from the light, for hard shadows of its direct light [Dong 2009 §6]: D32F reversed, one
 * layer a light view. It depends on no camera. */
#ifndef PASSES_SHADOW_MAP_H
#define PASSES_SHADOW_MAP_H

#include "passes/frame.h"

struct shadow_map_desc {
    int size; /* texels a side; of a cube's faces half as many */
    int light_views;
};

struct shadow_map_pass {
    GLuint opaque_program, masked_program;
    struct texture map;
    GLuint framebuffer;
};

bool shadow_map_pass_init(struct shadow_map_pass *pass, const struct shadow_map_desc *desc);
void shadow_map_pass_free(struct shadow_map_pass *pass);

/* Fills pass->map. Timer "shadow map". */
void shadow_map_pass_render(const struct shadow_map_pass *pass, const struct frame *frame);

#endif
