/* Adds the direct light of a sky's lights, each with its map [Dong 2011 §5.3.2]: exact where nothing hides
 * them, and looked up once per block of pixels, as VALs are (block_visibility.h). What is below a pixel's
 * horizon is left out before. */
#ifndef PASSES_SKY_LIGHT_H
#define PASSES_SKY_LIGHT_H

#include "lights/sky.h"
#include "passes/frame.h"

struct sky_light_desc {
    int width, height; /* of the picture */
    struct sky_map_layout maps;
    int block;      /* pixels a side of a block that shares its visibility */
    int ways;       /* to points of a light that a lookup follows */
    float bias;     /* texels: what is no higher above a receiver's plane hides nothing */
    float disagree; /* of light, for few lights: where blocks do by more, a pixel looks itself up */
    bool gloss;     /* the G-buffer has it */
};

struct sky_light_pass {
    struct sky_light_desc desc;
    GLuint share_program, block_program, light_program;
    struct texture shares;   /* RGBA32F, a layer four lights; visibility/sky_shares.frag */
    struct texture blocks;   /* RGBA8, the same */
    struct texture light;    /* RGBA32F, irradiance over pi, W/(sr m2) */
    struct texture specular; /* where desc.gloss: radiance towards the eye, RGBA32F */
    GLuint share_framebuffer, block_framebuffer, light_framebuffer;
    struct buffer params;
};

bool sky_light_pass_init(struct sky_light_pass *pass, const struct sky_light_desc *desc);
void sky_light_pass_free(struct sky_light_pass *pass);

/* Error: out of GPU memory; all is as it was. */
bool sky_light_pass_resize(struct sky_light_pass *pass, int width, int height);

struct sky_light_inputs {
    const struct buffer *lights;    /* a struct sky_block */
    const struct texture *maps;     /* passes/visibility/sky_map.h's */
    const struct texture *direct;   /* of all other lights, as pass->light */
    const struct texture *specular; /* likewise */
};

/* What no camera can change, for lights in a struct sky_block. Timer "sky shares". */
void sky_light_pass_render_lights(const struct sky_light_pass *pass, const struct frame *frame,
                                  const struct buffer *lights);

/* Fills pass->light and pass->specular. Timers "sky blocks" and "sky light". */
void sky_light_pass_render(const struct sky_light_pass *pass, const struct frame *frame,
                           const struct gbuffer *gbuffer, const struct sky_light_inputs *inputs);

#endif
