/* Adds the direct light of sampled lights to that of all others [Conty and Kulla 2018; Lin and
 * Yuksel 2020].
 *
 * Each pixel samples a few lights by the light tree and traces a ray to each. Lights that it takes
 * for sure are exact. For all others pixels of a 4 x 4 pattern take different samples, and the
 * caller's blur takes their mean. Pixels with few neighbours on their surface take more
 * samples. Cost: pixels x samples x (depth of the tree + a
 * ray). */
#ifndef PASSES_SAMPLED_DIRECT_H
#define PASSES_SAMPLED_DIRECT_H

#include "passes/targets.h"
#include "scene/gpu/caster_pool.h"

struct frame;

/* Radius of the blur: half the pattern, pixels. */
enum { SAMPLED_DIRECT_RADIUS = 2 };

struct sampled_direct_desc {
    int width, height;
    float distance, cosine;      /* alpha and beta of the blur, for neighbours */
    struct caster_pool *casters; /* must outlive the pass */
    bool specular;               /* the G-buffer has a specular target */
    bool medium;                 /* frames have a medium */
    bool slides;                 /* lights may have slides */
};

struct sampled_direct_pass {
    struct sampled_direct_desc desc;
    const struct caster_bvh *bvh;
    GLuint sample_program, add_program;
    struct buffer params;
    /* RGBA32F, of lights that a pixel takes exactly: radiance of a white surface, and towards the
     * camera with desc.specular. */
    struct texture exact, exact_specular;
    /* Of all other lights, before the blur, times irradiance_scale. */
    struct irradiance irradiance, radiance;
    GLuint sample_framebuffer;
    struct texture light;    /* RGBA32F, irradiance over pi of all lights, W/(sr m2) */
    struct texture specular; /* RGBA32F, radiance towards the camera, with desc.specular */
    GLuint framebuffer;
};

/* Error: driver, memory, or more triangles than OpenGL allows. */
bool sampled_direct_pass_init(struct sampled_direct_pass *pass,
                              const struct sampled_direct_desc *desc);
void sampled_direct_pass_free(struct sampled_direct_pass *pass);

/* Error: out of GPU memory; the pass stays unchanged. */
bool sampled_direct_pass_resize(struct sampled_direct_pass *pass, int width, int height);

/* Fills pass->exact, irradiance and radiance. Timer "sampled lights". */
void sampled_direct_pass_render(const struct sampled_direct_pass *pass, const struct frame *frame,
                                const struct gbuffer *gbuffer);

struct sampled_direct_inputs {
    const struct texture *direct, *specular; /* of all other lights, as pass->light and specular */
    const struct irradiance *irradiance, *radiance; /* blurred, or as rendered */
};

/* Fills pass->light and pass->specular with the sum. Timer "sampled lights". */
void sampled_direct_pass_add(const struct sampled_direct_pass *pass, const struct frame *frame,
                             const struct sampled_direct_inputs *inputs);

#endif
