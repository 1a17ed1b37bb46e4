/* What surfaces that are not diffuse reflect of nearby or sharply seen light: rays, sampled by the lobe
 * [Heitz 2018], look for lit surfaces in the reflective shadow maps.
 *
 * One bounce of light comes from what the lights see, and their maps have all of it, whatever the camera
 * sees: a ray that comes to lie behind what a light sees, and where it does so close to it, has met it. VPLs
 * find the same light; each of both ways counts by the power heuristic [Veach 1997, §9.2.4], so that rays
 * give smooth surfaces what points would give as spots, and VPLs the rough ones what few rays would
 * give as noise. What hides y from x is known as far as light shines on it, and where VALs have maps, by them. Cost: pixels that are not diffuse x
 * rays x groups of lights x steps.
 */
#ifndef PASSES_SPECULAR_RAYS_H
#define PASSES_SPECULAR_RAYS_H

#include "lights/view.h"
#include "passes/slot_lights.h"
#include "passes/visibility/visibility.h"

struct frame;
struct importance_map;

struct specular_rays_desc {
    int rays;      /* of a pixel */
    bool has_maps; /* of VALs: the one nearest to what a ray meets says what else hides it */
    struct visibility_desc visibility;  /* where has_maps */
    bool by_importance, medium, slides; /* as in struct near_field_desc */
    struct light_layout lights;
};

struct specular_rays_pass {
    struct specular_rays_desc desc;
    GLuint program;
    struct buffer params, lookup_params;
    struct slot_lights slot_lights;
};

bool specular_rays_pass_init(struct specular_rays_pass *pass,
                             const struct specular_rays_desc *desc);
void specular_rays_pass_free(struct specular_rays_pass *pass);

struct specular_rays_inputs {
    const struct gbuffer *rsm;               /* LIGHT_MAP_KINDS of them, with specular targets */
    const struct buffer *shares;             /* passes/lights/vpl.h's */
    const struct importance_map *importance; /* where by_importance */
    const struct irradiance *radiance;       /* to be added to: a gather's with SPECULAR_RAYS */
    struct visibility_inputs visibility;
};

/* Adds to inputs->radiance. Timer "specular rays". */
void specular_rays_pass_render(const struct specular_rays_pass *pass, const struct frame *frame,
                               const struct gbuffer *gbuffer,
                               const struct specular_rays_inputs *inputs);

#endif
