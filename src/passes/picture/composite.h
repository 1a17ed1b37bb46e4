/* Composites the contributions (struct contribution). A display gets exposure, tone map and sRGB; a
 * file gets any layer as linear floats. */
#ifndef PASSES_COMPOSITE_H
#define PASSES_COMPOSITE_H

#include "passes/targets.h"

struct frame;

enum tone_map { TONE_MAP_CLAMP, TONE_MAP_FILMIC };

/* Contributions of a technique, bits. */
enum {
    HAS_IRRADIANCE = 1,
    HAS_RADIANCE = 2,
    HAS_MEDIUM = 4,
    HAS_EDGE_SAMPLES = 8,
    HAS_CAUSTICS = 16,
    HAS_VOLUME_CAUSTICS = 32
};

struct environment;

struct composite_desc {
    int width, height;
    unsigned contributes; /* HAS_..., as composite_kinds returns */
    bool has_sky;         /* the scene has an environment */
    bool has_emission;    /* the G-buffer has emission */
    bool has_specular;    /* the G-buffer has a specular target */
};

struct composite_pass {
    struct composite_desc desc;
    GLuint centers_program, display_program, layer_program;
    struct texture display; /* RGBA8, sRGB-encoded */
    struct texture edges;   /* D16; 0: samples see other surfaces than the centre */
    GLuint framebuffer;
    struct buffer params;
};

/* Inputs of the composite besides the frame's sample assignment and edge samples. */
struct composite_inputs {
    const struct gbuffer *gbuffer;
    const struct texture *direct;          /* direct/direct.h */
    const struct texture *direct_specular; /* required with has_specular */
    struct contribution contribution;
    const struct environment *sky; /* environment behind the surfaces; NULL: none */
    struct background background;  /* for a display */
    int samples;
    float exposure; /* EV */
    enum tone_map tone_map;
    int layer; /* LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
};

/* Returns the HAS_... bits of the contribution. */
unsigned composite_kinds(const struct contribution *contribution);

bool composite_pass_init(struct composite_pass *pass, const struct composite_desc *desc);
void composite_pass_free(struct composite_pass *pass);

/* Fills pass->display. Timer "composite". */
void composite_pass_render(const struct composite_pass *pass, const struct frame *frame,
                           const struct composite_inputs *inputs);

/* Writes one layer, LAYER_..., into an RGBA32F target of the picture's size. Alpha is the fraction
 * of the pixel that surfaces cover. */
void composite_pass_render_layer(const struct composite_pass *pass, const struct frame *frame,
                                 const struct composite_inputs *inputs, int layer,
                                 GLuint framebuffer);

/* Adds the layer to a sum over passes, weighted as in passes/picture/mean.h. */
void composite_pass_add_layer(const struct composite_pass *pass, const struct frame *frame,
                              const struct composite_inputs *inputs, int layer, float weight,
                              GLuint framebuffer);

#endif
