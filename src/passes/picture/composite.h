/* The picture, as struct contribution has it, with exposure, tone map and sRGB for a display, or
 * any layer as linear floats for a file. */
#ifndef PASSES_COMPOSITE_H
#define PASSES_COMPOSITE_H

#include "passes/targets.h"

struct frame;

enum tone_map { TONE_MAP_CLAMP, TONE_MAP_FILMIC };

/* What a technique contributes: bits. */
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
    unsigned contributes; /* HAS_..., as composite_kinds tells */
    bool has_sky;         /* the scene has an environment */
    bool has_emission;    /* the G-buffer has */
    bool has_specular;    /* likewise */
};

struct composite_pass {
    struct composite_desc desc;
    GLuint centers_program, display_program, layer_program;
    struct texture display; /* RGBA8, sRGB-encoded */
    struct texture edges;   /* D16; 0: samples see what the centre does not */
    GLuint framebuffer;
    struct buffer params;
};

/* What the picture is made of, beside the frame's sample assignment and edge samples. */
struct composite_inputs {
    const struct gbuffer *gbuffer;
    const struct texture *direct;          /* direct/direct.h */
    const struct texture *direct_specular; /* where has_specular */
    struct contribution contribution;
    const struct environment *sky; /* where it is seen; NULL: nothing is, behind all surfaces */
    struct background background;  /* of the display */
    int samples;
    float exposure; /* EV */
    enum tone_map tone_map;
    int layer; /* LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
};

/* Which of a technique's contributions there are. */
unsigned composite_kinds(const struct contribution *contribution);

bool composite_pass_init(struct composite_pass *pass, const struct composite_desc *desc);
void composite_pass_free(struct composite_pass *pass);

/* Fills pass->display. Timer "composite". */
void composite_pass_render(const struct composite_pass *pass, const struct frame *frame,
                           const struct composite_inputs *inputs);

/* Writes one layer, LAYER_..., into an RGBA32F target of the picture's size; A = the share of
 * the pixel where a surface is. */
void composite_pass_render_layer(const struct composite_pass *pass, const struct frame *frame,
                                 const struct composite_inputs *inputs, int layer,
                                 GLuint framebuffer);

/* Adds it, weighted as passes/picture/mean.h has it, to a sum over passes. */
void composite_pass_add_layer(const struct composite_pass *pass, const struct frame *frame,
                              const struct composite_inputs *inputs, int layer, float weight,
                              GLuint framebuffer);

#endif
