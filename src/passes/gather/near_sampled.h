/* Adds the near field of sampled lights, which have no reflective shadow map: light of surfaces
 * within a few VPL spacings of the receiver, by rays from the receiver. Each surface that a ray
 * meets takes one light by the light tree, and a ray tests its visibility. VPLs give all other
 * light (passes/gather/near_field.h has the split). Unbiased, as the area of a VPL is estimated
 * alike for both. Cost: pixels x rays x (two rays + three samples of the tree). */
#ifndef PASSES_NEAR_SAMPLED_H
#define PASSES_NEAR_SAMPLED_H

#include "gl/buffer.h"
#include "passes/targets.h"
#include "scene/gpu/caster_pool.h"

struct frame;
struct pixel_lists;
struct importance_map;
struct light_rays;

struct near_sampled_desc {
    bool adaptive;              /* draws pixels of lists separately */
    int list_slots[LIST_KINDS]; /* 0: the list is not drawn */
    bool by_importance;         /* an importance map sets the density of VPLs */
    bool medium, slides;        /* as in struct vpl_desc */
};

struct near_sampled_pass {
    struct near_sampled_desc desc;
    GLuint program, adaptive_program;
    struct buffer params;
};

bool near_sampled_pass_init(struct near_sampled_pass *pass, const struct near_sampled_desc *desc);
void near_sampled_pass_free(struct near_sampled_pass *pass);

struct near_sampled_inputs {
    const struct buffer *shares;             /* VPL shares (passes/lights/vpl.h) */
    const struct importance_map *importance; /* with desc.by_importance */
    const struct light_rays *rays;
    const struct irradiance *irradiance; /* target that the pass adds to */
    const struct pixel_lists *lists;     /* required with desc.adaptive */
    bool of_lists;                       /* draws the tiles of lists in place of all other pixels */
};

/* Adds the near field to inputs->irradiance. Timer "near field, sampled". */
void near_sampled_pass_render(const struct near_sampled_pass *pass, const struct frame *frame,
                              const struct gbuffer *gbuffer,
                              const struct near_sampled_inputs *inputs);

#endif
