/* Renders panes before the surfaces of the picture: their transmittance, times the medium's, and
 * their own light, plus the medium's.
 *
 * Edges of panes are not antialiased, and only the nearest eight are visible. The nearest diffuse
 * pane gets a G-buffer of its own, which direct method and technique light. Panes behind it share
 * its indirect light. */
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
    bool scatters, slides, sky, irradiance; /* available inputs */
    bool reflects;                          /* some panes reflect diffusely */
    bool specular;                          /* G-buffers have a specular target */
    struct caster_pool *casters;
};

struct show_panes_pass {
    struct show_panes_desc desc;
    GLuint program, surfaces_program; /* surfaces_program only with desc.reflects */
    GLuint framebuffer;               /* targets: own, transmittance */
    struct texture own;               /* RGBA16F, radiance times irradiance_scale */
    struct texture transmittance;     /* RGBA16F */
    struct gbuffer surfaces;
    struct buffer params;
    const struct caster_bvh *tree;
};

bool show_panes_pass_init(struct show_panes_pass *pass, const struct show_panes_desc *desc);
void show_panes_pass_free(struct show_panes_pass *pass);

/* Error: out of GPU memory; the pass stays unchanged. */
bool show_panes_pass_resize(struct show_panes_pass *pass, int width, int height);

/* Fills pass->surfaces with panes in front of the G-buffer's surfaces. Timer "pane surfaces". */
void show_panes_pass_render_surfaces(const struct show_panes_pass *pass, const struct frame *frame,
                                     const struct gbuffer *gbuffer);

/* Fills pass->own and pass->transmittance. `contribution` has the medium behind, and the irradiance
 * of pass->surfaces; `direct` its direct light. Timer "panes". */
void show_panes_pass_render(const struct show_panes_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct contribution *contribution,
                            const struct texture *direct, const struct environment *sky);

#endif
