/* Reconstructs irradiance of camera surfaces from volume coefficients [Mavridis and Papaioannou
 * 2011 §3.4]. It interpolates the eight voxels around a point 1.5 voxels above the surface, except
 * voxels that are occupied or behind it. The paper takes six at half a voxel. */
#ifndef PASSES_RECONSTRUCT_H
#define PASSES_RECONSTRUCT_H

#include "gl/pass.h"
#include "passes/targets.h"

struct frame;
struct volume;

struct reconstruct_pass {
    GLuint program;
    /* Visibility volumes: unoccluded fraction of the hemisphere in [0, 1], times the parameters'
     * irradiance_scale. Alpha is 0 if no voxel has a value. */
    struct irradiance irradiance;
};

/* Makes the pass for volumes like `volume`. Error: shader, or out of GPU memory. */
bool reconstruct_pass_init(struct reconstruct_pass *pass, const struct volume *volume, int width,
                           int height);
void reconstruct_pass_free(struct reconstruct_pass *pass);

/* Fills pass->irradiance. Timer "reconstruct". */
void reconstruct_pass_render(const struct reconstruct_pass *pass, const struct frame *frame,
                             const struct gbuffer *gbuffer, const struct volume *volume,
                             const struct buffer *params);

#endif
