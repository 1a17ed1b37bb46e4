/* Draws points of surfaces, with the light that they reflect, into their voxels [Mavridis and Papaioannou 2011 §3.1]. A
 * voxel that a surface crosses stays empty with probability e^-k at most, where it has k points on average. */
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
    GLuint pixel_program; /* of reprojection; 0: none */
};

/* For volumes like that one; slides: lights may have some. Error: shader. */
bool inject_pass_init(struct inject_pass *pass, const struct volume *volume, bool reprojects,
                      bool slides);
void inject_pass_free(struct inject_pass *pass);

/* What points are lit through: maps of the frame's lights; NULL for volumes of visibility. */
void inject_pass_render(const struct inject_pass *pass, const struct frame *frame,
                        const struct volume *volume, const struct buffer *params,
                        const struct volume_points *points, const struct texture *shadow_maps);

/* Adds pixels of the camera's picture [Mavridis and Papaioannou 2011 §3.2]. Timer "reproject". */
void inject_pass_add_pixels(const struct inject_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct volume *volume,
                            const struct buffer *params, const struct texture *shadow_maps);

#endif
