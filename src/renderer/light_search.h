/* Which lights light what the camera sees something of. VPLs are placed by importance where lamps light mostly what it sees
 * nothing of: those next door, or outdoors beside a hall (lights.importance=auto). Directions of a sky lie where its light
 * comes in.
 *
 * Asked where nothing moves, so that pictures of a clip do not change from one choice to the other. Lamps with several
 * light samples, and environments, have VPLs by importance without asking.
 */
#ifndef RENDERER_LIGHT_SEARCH_H
#define RENDERER_LIGHT_SEARCH_H

#include "renderer/renderer.h"

/* Keeps the last answer, and a tree of triangles once somebody asks. */
struct light_search *light_search_create(void);

/* Accepts NULL. */
void light_search_free(struct light_search *search);

/* Of the lights and the camera of `desc`, whose light samples have that layout. */
bool light_search_is_unseen(struct light_search *search, const struct renderer_desc *desc,
                            const struct light_layout *samples);

/* At most `count` groups of lights of the sky of `desc`; by power alone where importance is off or something moves. */
void light_search_group_sky(struct light_search *search, struct sky_groups *groups,
                            const struct renderer_desc *desc,
                            const struct environment_lights *lights, int count);

#endif
