/* Renders glass and mirrors: rays from their pixels through smooth surfaces, by the scene's BVH.
 *
 * A ray divides at the first glass, as light rays do (caustics.h); random numbers choose at later
 * surfaces. A ray that ends at a visible point takes the light of the frame there, interpolated
 * bilinearly. Elsewhere shadow rays test all light samples, and cosine-distributed rays estimate
 * one indirect bounce, with noise. In a medium each segment gets airlight by a few steps.
 *
 * Missing outside the picture: caustics, textures (triangles have their mean colour), highlights of
 * rough metal turned to the smooth surface, and further bounces. Cost: pixels of glass x chains x
 * surfaces of a chain. */
#ifndef PASSES_GLASS_H
#define PASSES_GLASS_H

#include "passes/smooth_surfaces.h"
#include "scene/gpu/caster_bvh.h"
#include "scene/material.h"

struct environment;
struct frame;
struct gbuffer;

struct glass_desc {
    int width, height;
    int chains;
    enum materials materials;
    bool medium, sky; /* frames have a medium; an environment */
    const struct scene *scene;
    const struct geometry *geometry;
};

struct glass_pass {
    struct glass_desc desc;
    GLuint program;
    struct texture screen; /* RGBA32F, LAYER_SENT of passes/picture/composite.h */
    GLuint screen_framebuffer;
    struct buffer triangles, params;
    unsigned painted; /* value of geometry->painted for `triangles` */
    float (*glow)[3]; /* emission of each material when `triangles` were written */
};

/* Error: out of GPU memory; shaders. */
bool glass_pass_init(struct glass_pass *pass, const struct glass_desc *desc);
void glass_pass_free(struct glass_pass *pass);

/* Error: out of GPU memory; the pass stays unchanged. */
bool glass_pass_resize(struct glass_pass *pass, int width, int height);

struct glass_inputs {
    const struct smooth_surfaces *surfaces;
    const struct caster_bvh *tree;
    const struct environment *sky; /* required with desc.sky */
    /* RGBA32F target; pixels of smooth surfaces get radiance, and 1 + its indirect fraction in
     * A. */
    GLuint framebuffer;
};

/* Renders glass into inputs->framebuffer. Call it after filling `screen`. Timer "glass". */
void glass_pass_render(struct glass_pass *pass, const struct frame *frame,
                       const struct gbuffer *gbuffer, const struct glass_inputs *inputs);

#endif
