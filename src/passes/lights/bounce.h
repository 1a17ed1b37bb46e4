/* Light of later bounces: paths of light leave VPLs where they meet surfaces [Keller 1997, Instant Radiosity].
 *
 * Each of 4 P paths takes an even share of the first bounce's VPLs, or of starts of its light.
 * It follows the light from surface to surface by rays through the scene's triangles (src/passes/lights/light_walk.glsl). It
 * leaves the light of all its bounces at one of its surfaces, picked by light: one gather of the picture serves all bounces.
 * What there is of light is right on the mean, whatever the scene is made of: nothing leaks, and nothing is lost between
 * what is near. There may be any number of bounces: past the eighth, chance ends paths as often as surfaces absorb light.
 *
 * Where every fourth has left its light there is a VPL, and VPLs share out the light of the others: a pixel looks at P
 * places, and what they send is known of 4 P paths, so that the picture is steadier and errs less (bench/STABILITY.md). Pools
 * of 512 VPLs share out the light of their own paths, by nearness along their surface and like normals [Shepard 1968].
 * Each path gives to its four nearest VPLs, up to the first that it does not see, and hardly beyond a quarter of the
 * scene's radius; what is lost so is given back to VPLs that are alone (src/passes/lights/bounce_shares.frag).
 *
 * Pixels take the VPLs as patches (src/passes/gather/patch.glsl), which lose light where surfaces are small or crooked. What
 * they keep of it is told by how far the light of a VPL's own path goes from there, of those whose light goes to what the camera
 * sees, and what is lost is given back to all pixels alike.
 *
 * A path's numbers depend on no light and no camera, so that a frame depends on its time alone. Cost: 4 P rays for each
 * bounce, at most 32 P between VPLs, and 2 P, half of them for each view; for each VPL the places of others, at most BOUNCE_PARTNERS, for its area, and
 * twice those of its pool's paths. A triangle has one colour to paths.
 */
#ifndef PASSES_BOUNCE_H
#define PASSES_BOUNCE_H

#include "passes/vpls.h"
#include "scene/gpu/caster_pool.h"

struct frame;

struct bounce_desc {
    struct caster_pool *casters;
    int bounces;
    bool medium; /* frames have one */
    bool seen;   /* paths start by importance, and leave light where pixels see it */
    int count;   /* P */
    int seed;    /* 0 = Halton's points as they are; else shifted on the torus */
};

struct bounce_pass {
    struct bounce_desc desc;
    GLuint path_program, area_program, share_program, flux_program, vpl_program;
    GLuint seen_program, kept_program;
    const struct caster_bvh *tree;
    struct texture numbers; /* P x 4 (1 + bounces), RG32F: shared/bounce.h */
    int dealt_pass;         /* that they are those of */
    struct texture positions, normals, fluxes, nexts; /* P x 4, RGBA32F: what paths leave */
    struct texture areas;                             /* P x 4, R32F */
    struct texture shares, shared; /* P x 4, RGBA32F: light over its shares; light, shared out */
    struct texture seen;           /* P x 1, RGBA32F, of the last view */
    struct texture kept;           /* a pixel, likewise */
    GLuint path_framebuffer, area_framebuffer, share_framebuffer, shared_framebuffer;
    GLuint seen_framebuffer, kept_framebuffer;
    struct vpl_buffer vpls; /* C(i) = 0 */
    struct buffer params;
};

/* Error: driver, memory, or more triangles than OpenGL has room for. */
bool bounce_pass_init(struct bounce_pass *pass, const struct bounce_desc *desc);
void bounce_pass_free(struct bounce_pass *pass);

/* From the first bounce's VPLs, or from starts of its light, to pass->vpls. `albedos` are the triangles'
 * (passes/lights/albedos.h). Timer "bounces". */
void bounce_pass_render(struct bounce_pass *pass, const struct frame *frame,
                        const struct vpl_buffer *vpls, GLuint albedos);

/* What patches keep of the light that goes to what the camera sees, into pass->kept. Timer "bounces". */
void bounce_pass_find_kept(const struct bounce_pass *pass, const struct frame *frame);

#endif
