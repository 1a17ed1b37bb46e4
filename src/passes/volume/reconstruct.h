/* Irradiance of the camera's surfaces by a volume's coefficients [Mavridis and Papaioannou 2011 §3.4]. Eight voxels
 * around a place 1.5 voxels above the surface, which the paper has as six and half a voxel; without those that are
 * occupied or behind the surface. */
#ifndef PASSES_RECONSTRUCT_H
#define PASSES_RECONSTRUCT_H

#include "gl/pass.h"
#include "passes/targets.h"

struct frame;
struct volume;

struct reconstruct_pass {
    GLuint program;
    /* Of volumes of visibility the open share of the hemisphere, in [0, 1], times irradiance_scale of the parameters.
     * Alpha is 0 where no voxel knows. */
    struct irradiance irradiance;
};

/* For volumes like that one. Error: shader, or out of GPU memory. */
bool reconstruct_pass_init(struct reconstruct_pass *pass, const struct volume *volume, int width,
                           int height);
void reconstruct_pass_free(struct reconstruct_pass *pass);

/* Fills pass->irradiance. Timer "reconstruct". */
void reconstruct_pass_render(const struct reconstruct_pass *pass, const struct frame *frame,
                             const struct gbuffer *gbuffer, const struct volume *volume,
                             const struct buffer *params);

#endif
