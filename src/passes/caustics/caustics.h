/* Caustics: light that smooth surfaces throw onto others and into a medium (chapter 8 of [Dong 2011]).
 *
 * For each light: rays of equal solid angles through the smooth surfaces, by the scene's BVH; patches between
 * neighbouring rays, drawn where the camera sees the surface that they end on; and rays as lines in the medium.
 * [Dong 2011] traces through depth maps and takes surface caustics from [Wyman 2008]. The cost of rays is that of
 * desc.size squared, times chains and lights; of lines also that of the pixels they cover.
 *
 * The light does not start VPLs. What glass and mirrors show is in glass.h. */
#ifndef PASSES_CAUSTICS_H
#define PASSES_CAUSTICS_H

#include "gl/texture.h"
#include "passes/smooth_surfaces.h"
#include "scene/gpu/caster_pool.h"

struct frame;
struct gbuffer;

struct caustics_desc {
    int width, height;
    int size;   /* rays a side of a light's view */
    int chains; /* where there is glass */
    bool surface, points, volume;
    bool published;     /* lines in the medium are as [Dong 2011] has them, with the next two */
    float step, kernel; /* of a pixel's ray, metres; of the Gaussian's reach over the step */
    bool medium;        /* frames have one; `volume` is nothing without */
    const struct scene *scene;
    const struct geometry *geometry;
    struct caster_pool *casters;
};

struct caustics_pass {
    struct caustics_desc desc;
    int chains; /* 1 where all is mirrors */
    const struct caster_bvh *tree;
    struct smooth_surfaces surfaces;
    GLuint ray_program, cell_program, splat_list_program, patch_program, splat_program,
        line_program, between_program;
    struct texture leaves, ends, fluxes, patches[2], splats; /* RGBA32F, a texel a ray */
    struct texture between[2]; /* of a segment between two smooth surfaces; where there are lines */
    GLuint ray_framebuffer, cell_framebuffer, splat_framebuffer;
    struct texture surface,
        volume; /* RGBA32F: radiance of a white surface, and radiance; A of surface is 0 */
    GLuint surface_framebuffer, volume_framebuffer;
    struct buffer params;
};

/* Error: out of GPU memory; shaders; caster_bvh_update's. */
bool caustics_pass_init(struct caustics_pass *pass, const struct caustics_desc *desc);
void caustics_pass_free(struct caustics_pass *pass);

/* Error: out of GPU memory; all is as it was. */
bool caustics_pass_resize(struct caustics_pass *pass, int width, int height);

/* Fills surface and volume, for the lights of the frame. Timers "light rays", "caustics", "light lines". */
void caustics_pass_render(struct caustics_pass *pass, const struct frame *frame,
                          const struct gbuffer *gbuffer);

#endif
