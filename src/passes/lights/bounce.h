/* Light of further bounces: paths of light leave VPLs where they meet surfaces [Keller 1997, Instant Radiosity].
 *
 * Each of P paths takes an even share of the first bounce's VPLs, and follows it from surface to surface by rays through
 * the scene's triangles (glsl/lights/bounce_path.frag). It leaves one VPL with the light of all its bounces, at one of its
 * surfaces, picked by light: one gather of the picture serves all bounces. What there is of light is right on the mean,
 * whatever the scene is made of: nothing leaks, and nothing is lost between what is near.
 *
 * Pixels take the VPLs as patches (glsl/gather/patch.glsl), which lose light where surfaces are small or crooked. What
 * they keep of it is told by how far each path's light goes from its VPL, of those whose light goes to what the camera
 * sees, and what is lost is given back to all pixels alike.
 *
 * A path's numbers depend on no light and no camera, so that a frame depends on its time alone. Cost: P rays for each
 * bounce, and two, one of them for each view; and P places of others for each VPL's area, at most BOUNCE_PARTNERS. A
 * triangle has one colour to paths.
 */
#ifndef PASSES_BOUNCE_H
#define PASSES_BOUNCE_H

#include "passes/frame.h"
#include "scene/gpu/caster_pool.h"
#include "scene/material.h"

struct bounce_desc {
    const struct scene *scene;
    const struct geometry *geometry;
    struct caster_pool *casters; /* of the geometry */
    enum materials materials;
    int bounces;
    int count; /* P */
    int seed;  /* 0 = Halton's points as they are; else shifted on the torus */
};

struct bounce_pass {
    struct bounce_desc desc;
    GLuint path_program, area_program, seen_program, kept_program, vpl_program;
    const struct caster_tree *tree;
    struct buffer albedos; /* struct triangle_albedo of each triangle */
    GLuint albedo_texels;
    unsigned laid_out;      /* the geometry's, that they are of */
    struct texture numbers; /* P x (1 + bounces), RG32F: shared/bounce.h */
    int dealt_pass;         /* that they are those of */
    struct texture positions, normals, fluxes, nexts, areas; /* P x 1, RGBA32F: what paths leave */
    struct texture seen;                                     /* P x 1, RGBA32F, of the last view */
    struct texture kept;                                     /* a pixel, likewise */
    GLuint path_framebuffer, area_framebuffer, seen_framebuffer, kept_framebuffer;
    struct vpl_buffer vpls; /* C(i) = 0 */
    struct buffer params;
};

/* Error: driver, memory, or more triangles than OpenGL has room for. */
bool bounce_pass_init(struct bounce_pass *pass, const struct bounce_desc *desc);
void bounce_pass_free(struct bounce_pass *pass);

/* From the first bounce's VPLs to pass->vpls. Timer "bounces". */
void bounce_pass_render(struct bounce_pass *pass, const struct frame *frame,
                        const struct vpl_buffer *vpls);

/* What patches keep of the light that goes to what the camera sees, into pass->kept. Timer "bounces". */
void bounce_pass_find_kept(const struct bounce_pass *pass, const struct frame *frame);

#endif
