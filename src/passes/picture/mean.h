/* Averages several passes of one picture: weighted sums of its layers in 32-bit floats.
 *
 * Received light is weighted by albedo, depth and normal by the covered fraction of the pixel, as
 * within one picture (src/passes/picture/layer.glsl). So albedo (direct + indirect) = radiance also
 * holds for the mean, and means can be averaged again. */
#ifndef PASSES_MEAN_H
#define PASSES_MEAN_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "shared/composite.h"

struct background;
struct frame;

struct mean_desc {
    int width, height;
    bool specular, medium, caustics, volume_caustics; /* layers that exist */
};

struct mean_pass {
    struct mean_desc desc;
    GLuint display_program, layer_program;
    int layers;                  /* index of the last layer + 1 */
    struct texture sums[LAYERS]; /* RGBA32F, by LAYER_... */
    GLuint framebuffers[LAYERS]; /* targets for passes/picture/composite.h; 0: no such layer */
    struct buffer params;
};

/* Error: shaders, memory. */
bool mean_pass_init(struct mean_pass *pass, const struct mean_desc *desc);
void mean_pass_free(struct mean_pass *pass);

void mean_pass_clear(const struct mean_pass *pass);

/* Both divide the sums by `weight`, the sum of all passes' weights. The first applies exposure
 * (EV), tone map and background; the second writes linear floats. Timer "composite". */
void mean_pass_render_display(const struct mean_pass *pass, const struct frame *frame,
                              double weight, int layer, float exposure, bool filmic,
                              const struct background *background, GLuint framebuffer);
void mean_pass_render_layer(const struct mean_pass *pass, const struct frame *frame, double weight,
                            int layer, GLuint framebuffer);

#endif
