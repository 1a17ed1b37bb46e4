/* Orthographic depth maps from the lights of a sky: instanced draws of all casters, kind by kind, into all layers of a
 * depth array; D16, linear. They depend on no camera. */
#ifndef PASSES_SKY_MAP_H
#define PASSES_SKY_MAP_H

#include "lights/sky.h"
#include "scene/gpu/caster_pool.h"

struct frame;

struct sky_map_desc {
    struct caster_pool *casters; /* must outlive the pass */
    struct caster_desc caster;   /* which of them the maps show */
    struct sky_map_layout layout;
};

struct sky_map_pass {
    struct sky_map_desc desc;
    const struct caster_gpu *caster;
    GLuint opaque_program, masked_program, framebuffer;
    struct texture maps;
};

bool sky_map_pass_init(struct sky_map_pass *pass, const struct sky_map_desc *desc);
void sky_map_pass_free(struct sky_map_pass *pass);

/* Draws all maps, of the lights in that struct sky_block. Timer "sky maps". */
void sky_map_pass_render(const struct sky_map_pass *pass, const struct frame *frame,
                         const struct buffer *lights);

#endif
