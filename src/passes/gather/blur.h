/* Geometry-aware blur of the irradiance [Dong 2009 §6; Laine et al. 2007].
 *
 * A neighbour counts if |x - x'| < alpha and n . n' > beta. A first draw reorders the interleaved
 * tiles and packs position and normal of each pixel into one texel, so a tap is one fetch. End taps
 * have half weight: a window of 2 r + 1 taps is centred and holds each place of a pattern of 2 r
 * pixels equally. Cost: pixels x taps along x, then along y. */
#ifndef PASSES_BLUR_H
#define PASSES_BLUR_H

#include "passes/targets.h"

struct frame;
struct pixel_lists;

struct blur_desc {
    int width, height;
    int radius;          /* taps on each side; 0: reorders the tiles without blur */
    float distance;      /* alpha, over the picture's height at the pixel's depth */
    float cosine;        /* beta */
    float detail_cosine; /* beta of PIXEL_LEVEL_DETAIL, if larger */
    bool adaptive;       /* inputs have lists */
    /* Radius of each level, smaller than `radius`; half of the edge's where irradiance is steep. */
    float level_radius[PIXEL_LEVELS];
    /* Weight of each level: lights of its pixels over lights of a planar pixel. */
    float level_weight[PIXEL_LEVELS];
    bool specular; /* pixels of smooth surfaces take the first level; needs the specular target */
    bool square;   /* blurs the whole square at once, as published; else along x, then y */
    /* Another blur of this size and kind (square or not) whose taps this one overwrites; it lives
     * as long. init forgets its address. NULL: own taps. */
    const struct blur_pass *lender;
};

struct blur_pass {
    struct blur_desc desc;
    GLuint pack_program;
    struct blur_axis {
        GLuint program;
        struct buffer params;
    } along_x, along_y; /* with desc.square: along_y alone, for all rows */
    /* RGBA32UI, passes/gather/blur_tap.glsl; `half` only without desc.square. */
    struct irradiance taps, half;
    bool borrows; /* both are another blur's */
    struct irradiance blurred;
};

/* Input of the blur. With `lists`, their pixels take their own estimate from `adaptive`. */
struct blur_inputs {
    const struct irradiance *source;
    const struct pixel_lists *lists;
    const struct irradiance *adaptive;
};

/* Describes the blur of specular reflection, radiance towards the camera, which keeps textures and
 * images of narrow lobes sharp. */
struct blur_desc blur_desc_specular(int width, int height, int radius, float distance);

bool blur_pass_init(struct blur_pass *pass, const struct blur_desc *desc);
void blur_pass_free(struct blur_pass *pass);

/* Blurs inputs->source into pass->blurred. Timer "blur". */
void blur_pass_render(const struct blur_pass *pass, const struct frame *frame,
                      const struct gbuffer *gbuffer, const struct blur_inputs *inputs);

/* Blurs the first pass of a picture alone and returns the result. Later ones stay as they are:
 * their mean is unbiased. */
const struct irradiance *blur_pass_first(const struct blur_pass *pass, const struct frame *frame,
                                         const struct gbuffer *gbuffer,
                                         const struct irradiance *source);

#endif
