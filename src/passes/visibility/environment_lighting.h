/* Adds environment lighting to other direct light: area lights [Dong 2011 §5.3.2], whose visibility shadow rays test.
 *
 * Unoccluded light is exact. Rays start once per block of pixels, as lookups of VALs do (block_visibility.h), and at pixels
 * whose blocks disagree. The part of a light below a pixel's horizon does not count. */
#ifndef PASSES_ENVIRONMENT_LIGHTING_H
#define PASSES_ENVIRONMENT_LIGHTING_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "scene/gpu/caster_pool.h"

struct frame;
struct gbuffer;

struct environment_lighting_desc {
    int width, height;           /* of the picture */
    struct caster_pool *casters; /* must outlive the pass */
    int lights, suns;            /* the first lights are suns */
    int block;                   /* pixels a side of a block that shares its visibility */
    int shadow_rays;             /* to each light; more to suns */
    float disagree; /* of light, for few lights: where blocks do by more, rays start at the pixel */
    bool specular;  /* the G-buffer has it */
    bool medium;    /* frames have one */
};

struct environment_lighting_pass {
    struct environment_lighting_desc desc;
    const struct caster_bvh *bvh;
    GLuint share_program, block_program, light_program;
    struct texture shares; /* RGBA32F, a layer four lights, and one of all; sky_shares.frag */
    GLuint share_framebuffer;
    GLuint block_framebuffer, light_framebuffer;
    struct texture blocks;   /* RGBA8, the same */
    struct texture light;    /* RGBA32F, irradiance over pi, W/(sr m2) */
    struct texture specular; /* where desc.specular: radiance towards the eye, RGBA32F */
    struct buffer params;
};

/* Error: driver, memory, or more triangles than OpenGL has room for. */
bool environment_lighting_pass_init(struct environment_lighting_pass *pass,
                                    const struct environment_lighting_desc *desc);
void environment_lighting_pass_free(struct environment_lighting_pass *pass);

/* Error: out of GPU memory; all is as it was. */
bool environment_lighting_pass_resize(struct environment_lighting_pass *pass, int width,
                                      int height);

struct environment_lighting_inputs {
    const struct buffer *lights;    /* a struct sky_block */
    const struct texture *direct;   /* of all other lights, as pass->light */
    const struct texture *specular; /* likewise */
};

/* What no camera can change, for lights in a struct sky_block. Timer "sky shares". */
void environment_lighting_pass_render_lights(const struct environment_lighting_pass *pass,
                                             const struct frame *frame,
                                             const struct buffer *lights);

/* Fills pass->light and pass->specular. Timers "sky blocks" and "environment lighting". */
void environment_lighting_pass_render(const struct environment_lighting_pass *pass,
                                      const struct frame *frame, const struct gbuffer *gbuffer,
                                      const struct environment_lighting_inputs *inputs);

#endif
