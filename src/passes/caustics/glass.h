/* What glass and mirrors show: rays from their pixels through smooth surfaces, by the scene's BVH.
 *
 * A ray divides at the first glass as light rays do (caustics.h); numbers pick at later surfaces. A place that the picture
 * shows has the light that the frame has found there, by bilinear interpolation. Elsewhere shadow rays find direct light of
 * all light samples, and rays by the cosine one bounce of indirect light, with the noise of few rays. In a medium segments
 * have airlight by few steps.
 *
 * Not seen: caustics of places outside the picture, textures there (triangles have their mean colour), highlights of
 * rough metal turned to the smooth surface, later bounces there. Cost: pixels of glass, times chains and their surfaces. */
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
    bool medium, sky; /* frames have one */
    const struct scene *scene;
    const struct geometry *geometry;
};

struct glass_pass {
    struct glass_desc desc;
    GLuint program;
    struct texture screen; /* RGBA32F, LAYER_SENT of passes/picture/composite.h */
    GLuint screen_framebuffer;
    struct buffer triangles, params;
    unsigned painted; /* of the geometry, that the triangles are of */
    float (*glow)[3]; /* of materials, likewise */
};

/* Error: out of GPU memory; shaders. */
bool glass_pass_init(struct glass_pass *pass, const struct glass_desc *desc);
void glass_pass_free(struct glass_pass *pass);

/* Error: out of GPU memory; all is as it was. */
bool glass_pass_resize(struct glass_pass *pass, int width, int height);

struct glass_inputs {
    const struct smooth_surfaces *surfaces;
    const struct caster_bvh *tree;
    const struct environment *sky; /* where desc.sky */
    GLuint framebuffer;            /* RGBA32F; pixels of smooth surfaces are written: radiance, and
                                      1 + the part of it that is indirect light */
};

/* Once the screen is filled. Timer "glass". */
void glass_pass_render(struct glass_pass *pass, const struct frame *frame,
                       const struct gbuffer *gbuffer, const struct glass_inputs *inputs);

#endif
