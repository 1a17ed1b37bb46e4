/* Lights are chosen, changed, added and removed. */
#ifndef VIEWER_LIGHTS_H
#define VIEWER_LIGHTS_H

#include "viewer/state.h"

/* Whether there is a light: there may be the sky alone. */
bool viewer_has_light(const struct viewer *viewer);

/* The light that is chosen, to be changed: then viewer_touch_light. viewer_reset_light takes the
 * scene's own. */
struct emitter *viewer_light(const struct viewer *viewer);
void viewer_touch_light(struct viewer *viewer);
void viewer_reset_light(struct viewer *viewer);

/* Whether an animation leaves it alone. */
bool viewer_light_is_moved(const struct viewer *viewer, int i);

/* W; of a directional light what crosses the scene's sphere. */
double viewer_light_power(const struct viewer *viewer, const struct emitter *light);
void viewer_set_light_power(struct viewer *viewer, struct emitter *light, double power);

/* Of the chosen light, whose power stays. */
void viewer_retype_light(struct viewer *viewer, enum emitter_type type);

/* The new one is chosen. */
void viewer_add_light(struct viewer *viewer, enum emitter_type type);

/* Removes the chosen light; something must go on shining. */
bool viewer_can_remove_light(const struct viewer *viewer);
void viewer_remove_light(struct viewer *viewer);

#endif
