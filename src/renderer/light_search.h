/* Finds whether visible surfaces get light from the lamps. If lamps mostly light invisible
 * surfaces, in another room or outdoors, VPLs are placed by importance (lights.importance=auto). It
 * also groups an environment's directions by where light comes in.
 *
 * It runs only for scenes without motion, so that a clip does not switch between both. Lamps with
 * several light samples, and environments, always have VPLs by importance. */
#ifndef RENDERER_LIGHT_SEARCH_H
#define RENDERER_LIGHT_SEARCH_H

#include "renderer/renderer.h"

/* Returns a search that caches its last answer, and a BVH from the first question on: that of the
 * casters where they have it. */
struct light_search *light_search_create(const struct caster_pool *casters);

/* Accepts NULL. */
void light_search_free(struct light_search *search);

/* True if visible surfaces get little light from the lamps of `desc`. samples: layout of the light
 * samples. */
bool light_search_is_unseen(struct light_search *search, const struct renderer_desc *desc,
                            const struct light_layout *samples);

/* Groups the environment lights of `desc` into at most `count` groups. It groups by power alone if
 * importance is off or something moves. */
void light_search_group_sky(struct light_search *search, struct sky_groups *groups,
                            const struct renderer_desc *desc,
                            const struct environment_lights *lights, int count);

#endif
