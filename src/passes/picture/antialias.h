/* Which surfaces the pixel's samples see: antialiasing of what was shaded once a pixel [Chajdas et
 * al. 2011, Subpixel Reconstruction Antialiasing].
 *
 * Depth and normals are drawn with several samples a pixel: in as few layers as the driver's most samples allow, of four
 * at least, which every driver has, each shifted by its own part of a pixel. Each sample is given to the one of the 3 x 3 pixels
 * around it whose surface, taken as a plane, it lies on best; that pixel's shading and albedo are
 * then the sample's, and a picture is the mean over samples (src/passes/picture/layer.glsl).
 */
#ifndef PASSES_ANTIALIAS_H
#define PASSES_ANTIALIAS_H

#include "gl/buffer.h"
#include "gl/pixel_mask.h"
#include "gl/texture.h"

struct frame;
struct gbuffer;

struct antialias_desc {
    int width, height;
    int samples; /* at least so many, at most 16; 1 = centres alone, nothing drawn */
};

/* How samples are drawn: the triangles of the scene once for each layer. */
struct sample_layers {
    int layers, samples_of_layer;
};

/* The fewest layers of 4, 8 or 16 samples each that have as many samples, where a driver has at most `most` in one. */
struct sample_layers sample_layers(int samples, int most);

struct antialias_pass {
    struct antialias_desc desc;
    GLuint solid_program, masked_program, edge_program, assignment_program;
    struct sample_layers layers;
    int samples;                    /* drawn: whole layers, or the one centre */
    struct texture depths, normals; /* D32F; RGBA8, 0.5 + 0.5 n: a layer of samples after another */
    struct pixel_mask edges;        /* pixels with one */
    struct texture
        assignment; /* RG32UI, passes/picture/sample_assignment.glsl; 0 = itself; 1 x 1 if samples is 1 */
    struct texture edge_samples; /* RGBA32UI, lib/edge_sample.glsl; likewise */
    GLuint sample_framebuffer, assignment_framebuffer;
    struct buffer params;
};

/* Error: shaders; memory. */
bool antialias_pass_init(struct antialias_pass *pass, const struct antialias_desc *desc);
void antialias_pass_free(struct antialias_pass *pass);

/* Fills pass->assignment. Timer "antialias". */
void antialias_pass_render(const struct antialias_pass *pass, const struct frame *frame,
                           const struct gbuffer *gbuffer);

#endif
