/* Directions from which an environment's reflected light starts, dense where its light has a short way into the picture:
 * through windows and open roofs.
 *
 * A few directions for a whole sky meet a narrow opening by luck. Places that the picture shows by one bounce tell which
 * lights reach them.
 */
#ifndef LIGHTS_SKY_SEEN_H
#define LIGHTS_SKY_SEEN_H

#include "lights/sky.h"
#include "scene/surface_rays.h"

/* At most `count` groups, by weights: how much of each light comes to the places, of mean 1, and 1 for light that has longer
 * ways. Doors are where the light that comes to the places lies closest together. All weights are 1, and there are no doors,
 * where none comes. The same inputs give the same bits. Cost: at most 512 places, one ray for each of them and for each
 * two lights. */
void sky_groups_by_seen(struct sky_groups *groups, const struct environment_lights *lights,
                        int count, const struct environment *sky, const struct surface_rays *rays,
                        const struct camera *camera, float aspect);

#endif
