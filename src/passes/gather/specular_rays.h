/* What surfaces that are not diffuse reflect of lit surfaces: rays through the BVH, sampled by the lobe [Heitz 2018].
 *
 * A ray shades the surface that it meets by one light. The light's reflective shadow map tells whether this surface is
 * lit, and its texture; where the map has it not, a shadow ray tells. VPLs find the same light: each of both ways counts
 * by the power heuristic [Veach 1997, §9.2.4]. Rays give smooth surfaces images where points would give spots; VPLs give
 * rough surfaces even light where few rays would give noise. Cost: pixels that are not diffuse x two rays x rays of each.
 */
#ifndef PASSES_SPECULAR_RAYS_H
#define PASSES_SPECULAR_RAYS_H

#include "lights/view.h"
#include "passes/targets.h"
#include "passes/vpls.h"

struct caster_bvh;
struct frame;

struct specular_rays_desc {
    int rays;                           /* of a pixel */
    bool later;                         /* surfaces send indirect light, too */
    bool by_importance, medium, slides; /* as in struct near_field_desc */
    struct light_layout lights;
};

struct specular_rays_pass {
    struct specular_rays_desc desc;
    GLuint program;
    struct buffer params;
};

bool specular_rays_pass_init(struct specular_rays_pass *pass,
                             const struct specular_rays_desc *desc);
void specular_rays_pass_free(struct specular_rays_pass *pass);

struct specular_rays_inputs {
    const struct caster_bvh *tree;
    const struct gbuffer *rsm;               /* LIGHT_MAP_KINDS of them, with specular targets */
    const struct buffer *shares;             /* passes/lights/vpl.h's */
    const struct importance_map *importance; /* where by_importance */
    GLuint albedos;                          /* of triangles (passes/lights/albedos.h) */
    const struct irradiance
        *irradiance; /* where later: the frame's indirect light, in picture order */
    const struct irradiance *radiance; /* to be added to: a gather's with SPECULAR_RAYS */
};

/* Adds to inputs->radiance. Timer "specular rays". */
void specular_rays_pass_render(const struct specular_rays_pass *pass, const struct frame *frame,
                               const struct gbuffer *gbuffer,
                               const struct specular_rays_inputs *inputs);

#endif
