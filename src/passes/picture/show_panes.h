/* Panes before the surfaces of the picture: what they let pass to the camera, times what a medium does, and their own light
 * with the medium's. Edges of panes are not antialiased; only the nearest eight are seen. The nearest pane that reflects
 * diffusely is a surface of a G-buffer, which direct method and technique light as any other; panes behind that have its
 * indirect light. */
#ifndef PASSES_SHOW_PANES_H
#define PASSES_SHOW_PANES_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "passes/targets.h"
#include "scene/gpu/caster_pool.h"

struct contribution;
struct environment;
struct frame;

struct show_panes_desc {
    int width, height;
    bool scatters, slides, sky, irradiance; /* what there is */
    bool reflects;                          /* some panes reflect diffusely */
    bool specular;                          /* G-buffers have the target */
    struct caster_pool *casters;
};

struct show_panes_pass {
    struct show_panes_desc desc;
    GLuint program, surfaces_program; /* the second where some reflect */
    GLuint framebuffer;               /* of the next two */
    struct texture own;               /* RGBA16F, radiance times irradiance_scale */
    struct texture transmittance;     /* RGBA16F */
    struct gbuffer surfaces;
    struct buffer params;
    const struct caster_bvh *tree;
};

bool show_panes_pass_init(struct show_panes_pass *pass, const struct show_panes_desc *desc);
void show_panes_pass_free(struct show_panes_pass *pass);

/* Error: out of GPU memory; all is as it was. */
bool show_panes_pass_resize(struct show_panes_pass *pass, int width, int height);

/* Fills pass->surfaces, before what is in the G-buffer. Timer "pane surfaces". */
void show_panes_pass_render_surfaces(const struct show_panes_pass *pass, const struct frame *frame,
                                     const struct gbuffer *gbuffer);

/* Of the medium behind, and of the light of pass->surfaces: its irradiance, and direct light. Timer "panes". */
void show_panes_pass_render(const struct show_panes_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct contribution *contribution,
                            const struct texture *direct, const struct environment *sky);

#endif
