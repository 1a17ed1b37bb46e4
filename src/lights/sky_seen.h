/* Groups environment lights by the light that reaches the picture in one bounce, through windows
 * and open roofs.
 *
 * A few directions for a whole sky hit a narrow opening only by chance. Rays from points that the
 * picture shows by one bounce find the lights that reach them.
 *
 * Cost: at most 512 points; from each a ray to each light in front of it, about half of the
 * lights. */
#ifndef LIGHTS_SKY_SEEN_H
#define LIGHTS_SKY_SEEN_H

#include "lights/sky.h"
#include "scene/surface_rays.h"

/* Makes at most `count` groups by weights. The weight of a light is 1, for longer paths, plus its
 * relative light at the points, of mean 1. Doors are where this light is most concentrated. If no
 * light reaches a point, weights are 1 and doors are absent. Equal inputs give equal bits. */
void sky_groups_by_seen(struct sky_groups *groups, const struct environment_lights *lights,
                        int count, const struct environment *sky, const struct surface_rays *rays,
                        const struct camera *camera, float aspect);

#endif
