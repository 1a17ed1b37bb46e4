/* The near field of lit surfaces: the light of what lies within a few spacings of VPLs.
 *
 * A VPL stands for a patch as wide as the spacing; nearer than that, a point light is wrong however
 * it is clamped, and in a lit corner the deficit reaches half of the irradiance. So the integral is
 * split: with near(d) = (1 - d^2 / (reach^2 area))^2 the VPLs give (1 - near), and this pass gives
 * near, from the texels of the reflective shadow map around the receiver [Dachsbacher and
 * Stamminger 2005]. It takes the place of clamping and compensation [Kollig and Keller 2004]. One of
 * some samples, taken by its light, asks by a ray for all: unbiased. Without rays what is near counts as unoccluded, but
 * where there is detail (src/passes/gather/near_by_views.glsl); VPLs that are few and far apart then shine through walls.
 * Cost: pixels x samples x groups of lights, for pixels in reach of a light alone: the tiles of a pattern
 * share the lights of a group out by their flux; what is on a list takes all of them, and divides its samples.
 */
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
    int samples;   /* that the n x n pixels of a pattern share out */
    bool adaptive; /* pixels of lists come by themselves, and not with all others */
    int list_slots
        [LIST_KINDS]; /* what is on a list takes as many samples as so many slots have; 0: none */
    float adaptive_part;         /* of them, of patterns of more than a pixel */
    int occlusion;               /* NEAR_...: by views from what is on a list alone */
    struct caster_pool *casters; /* of NEAR_BY_RAYS; must outlive the pass */
    bool facets;                 /* the shadow map's normals are of triangles */
    bool by_importance;          /* VPLs are as dense as an importance map has it */
    bool medium;                 /* frames have one */
    bool slides;                 /* lights may have some */
    int rsm_size;                /* as lights' settings have it */
    struct light_layout lights;
};

struct near_field_pass {
    struct near_field_desc desc;
    const struct caster_bvh *tree; /* of desc.casters */
    GLuint light_program, program, adaptive_program;
    struct texture lights[LIGHT_MAP_KINDS]; /* RGBA32UI, maps as the shadow map's,
                                               src/passes/gather/near_light.glsl */
    GLuint lights_framebuffers[LIGHT_MAP_KINDS];
    struct buffer params;
    struct slot_lights slot_lights;
};

bool near_field_pass_init(struct near_field_pass *pass, const struct near_field_desc *desc);
void near_field_pass_free(struct near_field_pass *pass);

/* What the reflective shadow map says, made ready; shares are passes/lights/vpl.h's. Timer "near light". */
void near_field_pass_render_lights(struct near_field_pass *pass, const struct frame *frame,
                                   const struct gbuffer rsm[LIGHT_MAP_KINDS],
                                   const struct buffer *shares,
                                   const struct importance_map *importance);

struct near_field_inputs {
    const struct buffer *shares;         /* passes/lights/vpl.h's */
    const struct irradiance *irradiance; /* to be added to */
    const struct pixel_lists *lists;     /* where desc.adaptive */
    bool of_lists; /* the tiles are these lists', not those of all other pixels */
};

/* Adds to inputs->irradiance. Timer "near field", or "adaptive near field". */
void near_field_pass_render(const struct near_field_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct near_field_inputs *inputs);

#endif
