/* Where paths of light start that bring later bounces: places that lights shine on, dense where their light comes to what
 * the picture shows by more than one bounce.
 *
 * VPLs of the first bounce are no such places: they are few, and those that the picture does not see may have sixteen times
 * the light of an even share. One path from the ground before a window then brings more light than the room has. Starts have
 * an importance map of later bounces (passes/lights/importance_map.h), and at most twice the light of an even share.
 */
#ifndef TECHNIQUES_PATH_STARTS_H
#define TECHNIQUES_PATH_STARTS_H

#include "passes/lights/importance_map.h"
#include "passes/lights/vpl.h"

struct path_starts_desc {
    struct caster_pool *casters; /* must outlive the pass */
    int lights;                  /* of the frame's layout, at least 1 */
    int count;                   /* of starts, one or more for each path */
    int bounces;                 /* more than 1 */
    int seed;
    bool medium, slides, sky_rays; /* as VPLs have them */
};

struct path_starts {
    struct importance_map_pass importance;
    struct vpl_pass places;
    struct vpl_buffer vpls; /* count */
};

/* Error: as importance_map_pass_init. */
bool path_starts_init(struct path_starts *starts, const struct path_starts_desc *desc);
void path_starts_free(struct path_starts *starts);

/* Fills starts->vpls for frame->gbuffer. `rays` have a tree and albedos. */
void path_starts_render(struct path_starts *starts, const struct frame *frame,
                        const struct gbuffer rsm[LIGHT_MAP_KINDS], const struct light_rays *rays);

#endif
