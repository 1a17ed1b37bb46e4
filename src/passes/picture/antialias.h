/* Assigns the samples of a pixel to shaded pixels: antialiasing of a picture shaded once a pixel
 * [Chajdas et al. 2011, Subpixel Reconstruction Antialiasing].
 *
 * Depth and normals are drawn with several samples a pixel, in the fewest layers that the driver's
 * sample count allows (at least 4 a layer). Each layer has its own subpixel shift. A sample goes to
 * the pixel of the 3 x 3 around it whose surface, as a plane, fits best. It takes that pixel's
 * shading and albedo; a picture is the mean over samples (src/passes/picture/layer.glsl). */
#ifndef PASSES_ANTIALIAS_H
#define PASSES_ANTIALIAS_H

#include "gl/buffer.h"
#include "gl/pixel_mask.h"
#include "gl/texture.h"

struct frame;
struct gbuffer;

struct antialias_desc {
    int width, height;
    int samples;      /* least samples a pixel, at most 16; 1: centres alone, nothing is drawn */
    bool normal_maps; /* normals of the G-buffer may be bent off their triangles */
};

/* Layers of samples; each draws all triangles of the scene. */
struct sample_layers {
    int layers, samples_of_layer;
};

/* Returns the fewest layers of 4, 8 or 16 samples each that hold `samples`; the driver allows
 * `most` in one layer. */
struct sample_layers sample_layers(int samples, int most);

struct antialias_pass {
    struct antialias_desc desc;
    GLuint solid_program, masked_program, edge_program, assignment_program;
    struct sample_layers layers;
    int samples; /* samples drawn: whole layers, or 1 */
    /* D32F; RGBA8, 0.5 + 0.5 n: one layer of samples after another. */
    struct texture depths, normals;
    struct pixel_mask edges; /* pixels with an edge */
    /* RG32UI, lib/edge_sample.glsl. 0: the pixel itself. 1 x 1 if samples is 1. */
    struct texture assignment;
    struct texture edge_samples; /* RGBA32UI, lib/edge_sample.glsl; 1 x 1 if samples is 1 */
    GLuint sample_framebuffer, assignment_framebuffer;
    struct buffer params;
};

/* Error: shaders, memory. */
bool antialias_pass_init(struct antialias_pass *pass, const struct antialias_desc *desc);
void antialias_pass_free(struct antialias_pass *pass);

/* Writes where sample i lies, from the pixel's centre, pixels, y up. */
void antialias_pass_place(const struct antialias_pass *pass, int i, float place[2]);

/* Fills pass->assignment and pass->edge_samples. Timer "antialias". */
void antialias_pass_render(const struct antialias_pass *pass, const struct frame *frame,
                           const struct gbuffer *gbuffer);

#endif
