/* Adds environment lighting to other direct light: area lights [Dong 2011 §5.3.2] with shadow
 * rays.
 *
 * Unoccluded light is exact. Rays start once per block of pixels (block_visibility.h) and at pixels
 * whose blocks disagree. The part of a light below a pixel's horizon does not count.
 *
 * Specular surfaces sample the environment by rays of their lobe [Heitz 2018]; the caller blurs the
 * result. Suns and bright lights (sky_sampled_lights.glsl) add their specular light with the
 * visibility of the fit. Cost: 4 rays a pixel, 16 below a roughness of .25. */
#ifndef PASSES_ENVIRONMENT_LIGHTING_H
#define PASSES_ENVIRONMENT_LIGHTING_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "passes/targets.h"
#include "scene/gpu/caster_pool.h"

struct frame;
struct gbuffer;

struct environment_lighting_desc {
    int width, height;           /* of the picture */
    struct caster_pool *casters; /* must outlive the pass */
    int lights;                  /* number of lights */
    int suns, bright;            /* number of suns and of bright lights, the first ones */
    int block;                   /* side of a visibility block, pixels */
    int shadow_rays;             /* rays to each light; suns have more */
    /* Disagreement of blocks from which a pixel starts its own rays, over its light; smaller with
     * many lights. */
    float disagree;
    bool specular; /* the G-buffer has a specular target */
    bool medium;   /* frames have a medium */
};

struct environment_lighting_pass {
    struct environment_lighting_desc desc;
    const struct caster_bvh *bvh;
    GLuint share_program, block_program, lobe_program, light_program;
    /* RGBA32F, four lights a layer, and a layer with all (sky_shares.frag). */
    struct texture shares;
    GLuint share_framebuffer;
    GLuint block_framebuffer, light_framebuffer;
    struct texture blocks;   /* RGBA8, the same layers */
    struct texture light;    /* RGBA32F, irradiance over pi, W/(sr m2) */
    struct texture specular; /* RGBA32F, radiance towards the camera, with desc.specular */
    struct irradiance lobes; /* radiance that rays of lobes find; with desc.specular */
    struct buffer params;
};

/* Error: driver, memory, or more triangles than OpenGL allows. */
bool environment_lighting_pass_init(struct environment_lighting_pass *pass,
                                    const struct environment_lighting_desc *desc);
void environment_lighting_pass_free(struct environment_lighting_pass *pass);

/* Error: out of GPU memory; the pass stays unchanged. */
bool environment_lighting_pass_resize(struct environment_lighting_pass *pass, int width,
                                      int height);

struct environment_lighting_inputs {
    const struct buffer *lights;     /* a struct sky_block */
    const struct texture *direct;    /* direct light of all other lights, as pass->light */
    const struct texture *specular;  /* specular light of all other lights, as pass->specular */
    const struct texture *reflected; /* pass->lobes, blurred; with desc.specular */
};

/* Renders the camera-independent data of the lights in a struct sky_block. Timer "sky shares". */
void environment_lighting_pass_render_lights(const struct environment_lighting_pass *pass,
                                             const struct frame *frame,
                                             const struct buffer *lights);

/* With desc.specular: fills pass->lobes, radiance times irradiance_scale. Timer "sky in lobes". */
void environment_lighting_pass_render_lobes(const struct environment_lighting_pass *pass,
                                            const struct frame *frame,
                                            const struct gbuffer *gbuffer,
                                            const struct buffer *lights);

/* Fills pass->light and pass->specular. Timers "sky blocks" and "environment lighting". */
void environment_lighting_pass_render(const struct environment_lighting_pass *pass,
                                      const struct frame *frame, const struct gbuffer *gbuffer,
                                      const struct environment_lighting_inputs *inputs);

#endif
