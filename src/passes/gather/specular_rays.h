/* Adds light of lit surfaces reflected by non-diffuse surfaces: BVH rays sampled by the specular
 * lobe [Heitz 2018].
 *
 * A ray shades its hit point by one light. The light's RSM gives visibility and texture; a shadow
 * ray decides at points outside the RSM. VPLs find the same light, so the power heuristic weights
 * both [Veach 1997, §9.2.4]. Rays give mirror images where VPLs give spots. VPLs give smooth
 * results on rough surfaces where few rays give noise. Cost: non-diffuse pixels x rays of each x 2
 * rays. */
#ifndef PASSES_SPECULAR_RAYS_H
#define PASSES_SPECULAR_RAYS_H

#include "lights/view.h"
#include "passes/targets.h"
#include "passes/vpls.h"

struct caster_bvh;
struct frame;

struct specular_rays_desc {
    int rays;                           /* rays of a pixel */
    bool later;                         /* surfaces also send indirect light */
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
    const struct gbuffer *rsm;               /* LIGHT_MAP_KINDS maps with specular targets */
    const struct buffer *shares;             /* VPL shares (passes/lights/vpl.h) */
    const struct importance_map *importance; /* required with desc.by_importance */
    GLuint albedos; /* texture of the triangles' albedos (passes/lights/albedos.h) */
    const struct irradiance
        *irradiance; /* with desc.later: the frame's indirect light, in picture order */
    /* Target that the pass adds to: a gather's with SPECULAR_RAYS. */
    const struct irradiance *radiance;
};

/* Adds the reflected light to inputs->radiance. Timer "specular rays". */
void specular_rays_pass_render(const struct specular_rays_pass *pass, const struct frame *frame,
                               const struct gbuffer *gbuffer,
                               const struct specular_rays_inputs *inputs);

#endif
