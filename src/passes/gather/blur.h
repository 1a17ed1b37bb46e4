/* Geometry-aware blur of the irradiance [Dong 2009 §6; Laine et al. 2007].
 *
 * Neighbours count where |x - x'| < alpha and n . n' > beta. A first draw puts the interleaved
 * tiles back into picture order, with the place and normal of each pixel in the same texel: a tap
 * is then one fetch. The end taps have half weight: a window of 2 r + 1 taps then holds each place
 * of a pattern of 2 r pixels equally and is centred.
 */
#ifndef PASSES_BLUR_H
#define PASSES_BLUR_H

#include "passes/targets.h"

struct frame;
struct pixel_lists;

struct blur_desc {
    int width, height;
    int radius;                       /* taps to each side; 0 only puts the tiles in order */
    float distance;                   /* alpha, over the picture's height at the pixel's depth */
    float cosine;                     /* beta */
    float detail_cosine;              /* of PIXEL_LEVEL_DETAIL, if larger */
    bool adaptive;                    /* there are pixels of lists */
    float level_radius[PIXEL_LEVELS]; /* theirs, smaller; half an edge's where light is steep */
    float level_weight[PIXEL_LEVELS]; /* how many times as many lights as others they have */
    bool specular; /* what is smooth, of a G-buffer with its target, is of the first level */
    bool square;   /* over all taps of the square at once, as published; else along x, then y */
    /* Another blur of this size, not square or as square, whose taps it may overwrite; outlives it. NULL: own taps. */
    const struct blur_pass *lender;
};

struct blur_pass {
    struct blur_desc desc;
    GLuint pack_program;
    struct blur_axis {
        GLuint program;
        struct buffer params;
    } along_x, along_y; /* where square, along_y alone, of all rows */
    struct irradiance taps,
        half; /* RGBA32UI, src/passes/gather/blur_tap.glsl; half: not where square */
    struct irradiance blurred;
};

/* What is blurred: where lists is not NULL, their pixels have another estimate, in their tiles. */
struct blur_inputs {
    const struct irradiance *source;
    const struct pixel_lists *lists;
    const struct irradiance *adaptive;
};

bool blur_pass_init(struct blur_pass *pass, const struct blur_desc *desc);
void blur_pass_free(struct blur_pass *pass);

/* From the inputs to pass->blurred. Timer "blur". */
void blur_pass_render(const struct blur_pass *pass, const struct frame *frame,
                      const struct gbuffer *gbuffer, const struct blur_inputs *inputs);

#endif
