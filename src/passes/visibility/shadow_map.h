/* Renders depth from the lights, for hard shadows of direct light [Dong 2009 §6]: D32F, reversed,
 * one layer a view. It is independent of the camera. */
#ifndef PASSES_SHADOW_MAP_H
#define PASSES_SHADOW_MAP_H

#include "gl/texture.h"
#include "lights/view.h"
#include "shared/light.h"

struct frame;

struct shadow_map_desc {
    int size; /* side of a view's map, texels */
    struct light_layout lights;
};

struct shadow_map_pass {
    GLuint opaque_program, masked_program;
    struct texture maps[LIGHT_MAP_KINDS];
    GLuint framebuffers[LIGHT_MAP_KINDS];
};

bool shadow_map_pass_init(struct shadow_map_pass *pass, const struct shadow_map_desc *desc);
void shadow_map_pass_free(struct shadow_map_pass *pass);

/* Fills pass->maps. Timer "shadow map". */
void shadow_map_pass_render(const struct shadow_map_pass *pass, const struct frame *frame);

#endif
