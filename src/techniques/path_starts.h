/* Makes the starts of light paths for later bounces: lit points, dense where their light reaches
 * the picture after more than one bounce.
 *
 * VPLs of the first bounce are unsuitable. They are few, and invisible ones may have 16 times the
 * light of an equal share. One path from the ground outside a window then carries more light than
 * the room. Starts have an importance map of later bounces (passes/lights/importance_map.h), and at
 * most twice the light of an equal share. */
#ifndef TECHNIQUES_PATH_STARTS_H
#define TECHNIQUES_PATH_STARTS_H

#include "passes/lights/importance_map.h"
#include "passes/lights/vpl.h"

struct path_starts_desc {
    struct caster_pool *casters; /* must outlive the pass */
    int lights;                  /* lights of the frame's layout, at least 1 */
    int count;                   /* number of starts, at least one a path */
    int bounces;                 /* more than 1 */
    int seed;
    bool medium, slides, sky_rays, sampled; /* as in struct vpl_desc */
};

struct path_starts {
    struct importance_map_pass importance;
    struct vpl_pass places;
    struct vpl_buffer vpls; /* `count` starts */
};

/* Error: that of importance_map_pass_init. */
bool path_starts_init(struct path_starts *starts, const struct path_starts_desc *desc);
void path_starts_free(struct path_starts *starts);

/* Fills starts->vpls for frame->gbuffer. `rays` needs a tree and albedos. */
void path_starts_render(struct path_starts *starts, const struct frame *frame,
                        const struct gbuffer rsm[LIGHT_MAP_KINDS], const struct light_rays *rays);

#endif
