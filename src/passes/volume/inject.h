/* Draws surface points, with their reflected light, into voxels [Mavridis and Papaioannou 2011
 * §3.1]. A voxel with k points on average stays empty with probability e^-k at most. */
#ifndef PASSES_INJECT_H
#define PASSES_INJECT_H

#include "gl/pass.h"
#include "passes/volume_points.h"
#include "shared/light.h"

struct frame;
struct gbuffer;
struct volume;

struct inject_pass {
    GLuint program;
    GLuint pixel_program; /* draws camera pixels for reprojection; 0: none */
};

/* Makes the pass for volumes like `volume`. slides: lights may have slides. Error: shader. */
bool inject_pass_init(struct inject_pass *pass, const struct volume *volume, bool reprojects,
                      bool slides);
void inject_pass_free(struct inject_pass *pass);

/* Draws the points. `shadow_maps` are the maps of the frame's lights; NULL for visibility
 * volumes. */
void inject_pass_render(const struct inject_pass *pass, const struct frame *frame,
                        const struct volume *volume, const struct buffer *params,
                        const struct volume_points *points, const struct texture *shadow_maps);

/* Adds camera pixels [Mavridis and Papaioannou 2011 §3.2]. Timer "reproject". */
void inject_pass_add_pixels(const struct inject_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct volume *volume,
                            const struct buffer *params, const struct texture *shadow_maps);

#endif
