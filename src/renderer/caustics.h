/* True if the renderer shows caustics: enabled by the settings, and the scene has smooth
 * surfaces. */
#ifndef RENDERER_CAUSTICS_H
#define RENDERER_CAUSTICS_H

#include "renderer/renderer.h"
#include "scene/caustics.h"

bool renderer_has_caustics(const struct renderer_desc *desc);

/* Updates the renderer's copy of its geometry in which glass blocks light, if caustics are on. Call
 * it after each pose. */
void renderer_view_geometry(struct renderer *renderer);

/* Returns this copy, or else the geometry: the triangles that all passes draw. */
const struct geometry *renderer_geometry(const struct renderer *renderer);

/* Returns HAS_... of passes/picture/composite.h. medium: frames have a medium. */
unsigned renderer_caustic_kinds(const struct renderer_desc *desc, bool medium);

/* Passes, in a file that a build may leave out. renderer_init_caustics fills renderer->caustics.
 * Error: that of caustics_pass_init or glass_pass_init. */
bool renderer_init_caustics(struct renderer *renderer, bool medium);
void renderer_free_caustics(struct renderer *renderer);

/* Error: out of GPU memory; both passes stay unchanged. */
bool renderer_resize_caustics(struct renderer *renderer, int width, int height);

/* Renders caustics, then glass and mirrors. Call it after the technique and the airlight. */
void renderer_render_caustics(struct renderer *renderer, const struct frame *frame);

#endif
