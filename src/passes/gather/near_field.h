/* Renders the near field: light of surfaces within a few VPL spacings of the receiver.
 *
 * A VPL stands for a patch as wide as the spacing, so closer than that a point light is wrong
 * however it is clamped. The integral is split by near(d) = (1 - d^2 / (reach^2 area))^2. VPLs give
 * 1 - near, and this pass gives near, from RSM texels around the receiver [Dachsbacher and
 * Stamminger 2005]. It replaces clamping and compensation [Kollig and Keller 2004]. With rays, one
 * sample of a group, chosen by its light, tests visibility for all: unbiased. Without rays near
 * light counts as unoccluded except at detail (src/passes/gather/near_field.frag), and with
 * few VPLs light leaks through walls. Cost: pixels in reach x samples x light groups. Slots share
 * the lights of a group by flux. List entries take all lights and divide their samples. */
#ifndef PASSES_NEAR_FIELD_H
#define PASSES_NEAR_FIELD_H

#include "lights/view.h"
#include "passes/slot_lights.h"
#include "passes/targets.h"
#include "scene/gpu/caster_pool.h"
#include "shared/gather.h"

struct frame;
struct pixel_lists;
struct importance_map;

struct near_field_desc {
    int samples;   /* samples that the n x n pixels of a pattern share */
    bool adaptive; /* draws pixels of lists separately */
    /* Slots whose samples one entry of each list takes, at most `samples`. 0: the list is not
     * drawn. */
    int list_slots[LIST_KINDS];
    float adaptive_part;         /* fraction of these samples that is drawn, for n > 1 */
    int occlusion;               /* NEAR_...; tests by views run only for list entries */
    struct caster_pool *casters; /* for NEAR_BY_RAYS; must outlive the pass */
    bool facets;                 /* normals of the RSM are those of triangles */
    bool normal_maps;            /* normals of the G-buffer may be bent off their triangles */
    bool by_importance;          /* an importance map sets the density of VPLs */
    bool medium;                 /* frames have a medium */
    bool slides;                 /* lights may have slides */
    int rsm_size;                /* setting of the lights, texels */
    struct light_layout lights;
};

struct near_field_pass {
    struct near_field_desc desc;
    const struct caster_bvh *tree; /* tree of desc.casters */
    GLuint light_program, program, adaptive_program;
    /* RGBA32UI, layers as in the RSM (src/passes/gather/near_light.glsl). */
    struct texture lights[LIGHT_MAP_KINDS];
    GLuint lights_framebuffers[LIGHT_MAP_KINDS];
    struct buffer params;
    struct slot_lights slot_lights;
};

bool near_field_pass_init(struct near_field_pass *pass, const struct near_field_desc *desc);
void near_field_pass_free(struct near_field_pass *pass);

/* Converts the RSM into reflected light. `shares` come from passes/lights/vpl.h. Timer "near
 * light". */
void near_field_pass_render_lights(struct near_field_pass *pass, const struct frame *frame,
                                   const struct gbuffer rsm[LIGHT_MAP_KINDS],
                                   const struct buffer *shares,
                                   const struct importance_map *importance);

struct near_field_inputs {
    const struct buffer *shares;         /* VPL shares (passes/lights/vpl.h) */
    const struct irradiance *irradiance; /* target that the pass adds to */
    const struct pixel_lists *lists;     /* required with desc.adaptive */
    bool of_lists;                       /* draws the tiles of lists in place of all other pixels */
};

/* Adds the near field to inputs->irradiance. Timer "near field" or "adaptive near field". */
void near_field_pass_render(const struct near_field_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct near_field_inputs *inputs);

#endif
