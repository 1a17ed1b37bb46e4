/* What a renderer has for caustics: nothing, where the settings or the scene have none. */
#ifndef RENDERER_CAUSTICS_H
#define RENDERER_CAUSTICS_H

#include "renderer/renderer.h"
#include "scene/caustics.h"

bool renderer_has_caustics(const struct renderer_desc *desc);

/* Gives the renderer its own view of its geometry where caustics are on, in which glass blocks light; after each
 * pose. */
void renderer_view_geometry(struct renderer *renderer);

/* That view, or else the one geometry: what all passes draw. */
const struct geometry *renderer_geometry(const struct renderer *renderer);

/* HAS_... of passes/picture/composite.h; medium: the frames have one. */
unsigned renderer_caustic_kinds(const struct renderer_desc *desc, bool medium);

/* The passes, in a file that a build may be without. init fills renderer->caustics. Error: GPU memory, shader. */
bool renderer_init_caustics(struct renderer *renderer, bool medium);
void renderer_free_caustics(struct renderer *renderer);

/* Error: out of GPU memory; all is as it was. */
bool renderer_resize_caustics(struct renderer *renderer, int width, int height);

/* After the technique and the airlight: what smooth surfaces throw onto others, and what they show. */
void renderer_render_caustics(struct renderer *renderer, const struct frame *frame);

#endif
