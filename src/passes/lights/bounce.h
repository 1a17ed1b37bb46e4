/* Traces light of later bounces: paths leave VPLs at surfaces [Keller 1997, Instant Radiosity].
 *
 * 4 P paths start at the first bounce's VPLs or light samples (light_walk.glsl). Each deposits the
 * light of all its bounces at one vertex, chosen by light: one unbiased gather serves all bounces.
 * Past the eighth, Russian roulette ends paths. Every fourth deposit is a VPL. Pools of 512 VPLs
 * share the light of their paths by distance and normals [Shepard 1968]. A path shares with its
 * four nearest VPLs, up to the first that it does not see and a quarter of the scene's radius.
 * Isolated VPLs get the light lost where VPLs are few (bounce_shares.frag). Pixels take VPLs as
 * patches (gather/vpl_terms.glsl), which lose light at small or bent surfaces. The retained
 * fraction is estimated from paths whose light reaches visible surfaces; the lost energy is added
 * back uniformly. Numbers of a path depend on no light or camera. Paths see one colour a triangle.
 * Cost: 4 P rays a bounce and 2 P, half of these a view; per VPL BOUNCE_PARTNERS distances and
 * twice those of its pool's paths. */
#ifndef PASSES_BOUNCE_H
#define PASSES_BOUNCE_H

#include "passes/vpls.h"
#include "scene/gpu/caster_pool.h"

struct frame;

struct bounce_desc {
    struct caster_pool *casters;
    int bounces;
    bool medium; /* frames have a medium */
    bool seen;   /* paths start by importance and deposit light at visible points */
    int count;   /* P */
    int seed;    /* 0: Halton points; else points shifted on the torus */
};

struct bounce_pass {
    struct bounce_desc desc;
    GLuint path_program, area_program, share_program, flux_program, vpl_program;
    GLuint seen_program, kept_program;
    const struct caster_bvh *tree;
    struct texture numbers; /* P x 4 (1 + bounces), RG32F: shared/bounce.h */
    int dealt_pass;         /* frame->pass of `numbers` */
    /* P x 4, RGBA32F: vertices where paths leave light. */
    struct texture positions, normals, fluxes, nexts;
    struct texture areas;          /* P x 4, R32F */
    struct texture shares, shared; /* P x 4, RGBA32F: light over its weights; shared light */
    struct texture seen;           /* P x 1, RGBA32F: retained light of paths in the last view */
    struct texture kept;           /* retained fraction in the last view, one texel a pixel */
    GLuint path_framebuffer, area_framebuffer, share_framebuffer, shared_framebuffer;
    GLuint seen_framebuffer, kept_framebuffer;
    struct vpl_buffer vpls; /* C(i) = 0 */
    struct buffer params;
};

/* Error: driver, memory, or more triangles than OpenGL allows. */
bool bounce_pass_init(struct bounce_pass *pass, const struct bounce_desc *desc);
void bounce_pass_free(struct bounce_pass *pass);

/* Traces paths from `vpls`, the first bounce's VPLs or path starts, into pass->vpls. `albedos` is
 * the triangles' texture (passes/lights/albedos.h). Timer "bounces". */
void bounce_pass_render(struct bounce_pass *pass, const struct frame *frame,
                        const struct vpl_buffer *vpls, GLuint albedos);

/* Estimates the fraction of visible light that patches retain, into pass->kept. Timer "bounces". */
void bounce_pass_find_kept(const struct bounce_pass *pass, const struct frame *frame);

#endif
