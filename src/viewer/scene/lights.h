/* Chooses, changes, adds and removes lights. */
#ifndef VIEWER_LIGHTS_H
#define VIEWER_LIGHTS_H

#include "viewer/state.h"

/* Returns true if there is a light. There may be the sky alone. */
bool viewer_has_light(const struct viewer *viewer);

/* viewer_light returns the chosen light. Call viewer_touch_light after a change.
 * viewer_reset_light restores the scene's own light. */
struct emitter *viewer_light(const struct viewer *viewer);
void viewer_touch_light(struct viewer *viewer);
void viewer_reset_light(struct viewer *viewer);

/* Returns true if no animation moves light i: the user has moved or added it. */
bool viewer_light_is_moved(const struct viewer *viewer, int i);

/* Get and set the power of a light, W. For a directional light: the power through the scene's
 * bounding sphere. */
double viewer_light_power(const struct viewer *viewer, const struct emitter *light);
void viewer_set_light_power(struct viewer *viewer, struct emitter *light, double power);

/* Changes the type of the chosen light and keeps its power. */
void viewer_retype_light(struct viewer *viewer, enum emitter_type type);

/* Adds a light and chooses it. */
void viewer_add_light(struct viewer *viewer, enum emitter_type type);

/* viewer_remove_light removes the chosen light. viewer_can_remove_light is false if nothing else
 * shines. */
bool viewer_can_remove_light(const struct viewer *viewer);
void viewer_remove_light(struct viewer *viewer);

#endif
