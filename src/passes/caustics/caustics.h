/* Renders caustics: light that smooth surfaces throw onto other surfaces and into a medium [Dong
 * 2011 §8].
 *
 * Rays of equal solid angle leave each light and follow smooth surfaces through the BVH. Patches
 * between neighbouring rays are drawn where the camera sees their last surface. In a medium the
 * rays are drawn as lines. [Dong 2011] traces depth maps instead and takes surface caustics from
 * [Wyman 2008]. Cost: size^2 x chains x lights rays, plus the pixels that the lines cover.
 *
 * Caustics do not start VPLs. glass.h renders the appearance of glass and mirrors. */
#ifndef PASSES_CAUSTICS_H
#define PASSES_CAUSTICS_H

#include "gl/texture.h"
#include "passes/smooth_surfaces.h"
#include "scene/gpu/caster_pool.h"

struct frame;
struct gbuffer;

struct caustics_desc {
    int width, height;
    int size;   /* rays along each side of a light's view */
    int chains; /* chains of a ray in scenes with glass */
    bool surface, points, volume;
    bool published;     /* draws lines in the medium as [Dong 2011] does, by `step` and `kernel` */
    float step, kernel; /* step along a pixel's ray, metres; reach of the Gaussian, in steps */
    bool medium;        /* frames have a medium; required by `volume` */
    const struct scene *scene;
    const struct geometry *geometry;
    struct caster_pool *casters;
};

struct caustics_pass {
    struct caustics_desc desc;
    int chains; /* desc.chains; 1 in scenes without glass */
    const struct caster_bvh *tree;
    struct smooth_surfaces surfaces;
    GLuint ray_program, cell_program, splat_list_program, patch_program, splat_program,
        line_program, between_program;
    struct texture leaves, ends, fluxes, patches[2], splats; /* RGBA32F, one texel a ray */
    struct texture between[2]; /* segments between two smooth surfaces; only with lines */
    GLuint ray_framebuffer, cell_framebuffer, splat_framebuffer;
    struct texture surface,
        volume; /* RGBA32F: radiance of a white surface; radiance. A of `surface` is 0. */
    GLuint surface_framebuffer, volume_framebuffer;
    struct buffer params;
};

/* Error: out of GPU memory, shaders, or that of caster_bvh_update. */
bool caustics_pass_init(struct caustics_pass *pass, const struct caustics_desc *desc);
void caustics_pass_free(struct caustics_pass *pass);

/* Error: out of GPU memory; the pass stays unchanged. */
bool caustics_pass_resize(struct caustics_pass *pass, int width, int height);

/* Fills `surface` and `volume` for the frame's lights. Timers "light rays", "caustics", "light
 * lines". */
void caustics_pass_render(struct caustics_pass *pass, const struct frame *frame,
                          const struct gbuffer *gbuffer);

#endif
