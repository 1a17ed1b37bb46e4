/* The mean of several passes of one picture: sums of its layers in 32-bit floats, each pass with its
 * weight.
 *
 * What a surface receives is weighted by its albedo, depth and normal by the share of the pixel that is
 * covered, as within one picture (src/passes/picture/layer.glsl): so albedo (direct + indirect) = radiance
 * holds of the mean too, and means of means are means.
 */
#ifndef PASSES_MEAN_H
#define PASSES_MEAN_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "shared/composite.h"

struct background;
struct frame;

struct mean_desc {
    int width, height;
    bool specular, medium, caustics, volume_caustics; /* with their layers */
};

struct mean_pass {
    struct mean_desc desc;
    GLuint display_program, layer_program;
    int layers;                  /* one more than the last that there is */
    struct texture sums[LAYERS]; /* RGBA32F, at LAYER_... */
    GLuint framebuffers
        [LAYERS]; /* for passes/picture/composite.h to add to; 0: the layer is not there */
    struct buffer params;
};

/* Error: shaders; memory. */
bool mean_pass_init(struct mean_pass *pass, const struct mean_desc *desc);
void mean_pass_free(struct mean_pass *pass);

void mean_pass_clear(const struct mean_pass *pass);

/* Of sums whose weights add up to `weight`: a layer for a display, with exposure (EV), tone map and
 * background; and as linear floats. Timer "composite". */
void mean_pass_render_display(const struct mean_pass *pass, const struct frame *frame,
                              double weight, int layer, float exposure, bool filmic,
                              const struct background *background, GLuint framebuffer);
void mean_pass_render_layer(const struct mean_pass *pass, const struct frame *frame, double weight,
                            int layer, GLuint framebuffer);

#endif
