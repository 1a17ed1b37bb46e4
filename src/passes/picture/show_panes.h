/* Panes before the surfaces of the picture: what they let pass to the camera, times what a medium does, and their own light
 * with the medium's. Edges of panes are not antialiased; only the nearest eight are seen. */
#ifndef PASSES_SHOW_PANES_H
#define PASSES_SHOW_PANES_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "scene/gpu/caster_pool.h"

struct contribution;
struct environment;
struct frame;
struct gbuffer;

struct show_panes_desc {
    int width, height;
    bool scatters, slides, sky, irradiance; /* what there is */
    struct caster_pool *casters;
};

struct show_panes_pass {
    struct show_panes_desc desc;
    GLuint program;
    GLuint framebuffer;           /* of the two */
    struct texture own;           /* RGBA16F, radiance times irradiance_scale */
    struct texture transmittance; /* RGBA16F */
    struct buffer params;
    const struct caster_bvh *tree;
};

bool show_panes_pass_init(struct show_panes_pass *pass, const struct show_panes_desc *desc);
void show_panes_pass_free(struct show_panes_pass *pass);

/* Error: out of GPU memory; all is as it was. */
bool show_panes_pass_resize(struct show_panes_pass *pass, int width, int height);

/* For a frame with panes whose contribution of the technique, and of a medium, is that. Timer "panes". */
void show_panes_pass_render(const struct show_panes_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct contribution *behind,
                            const struct environment *sky);

#endif
