/* Whether lamps light mostly what the camera sees nothing of: those next door, or outdoors beside a hall. VPLs are then placed
 * by importance (lights.importance=auto).
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

#endif
