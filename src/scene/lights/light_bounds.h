/* Bounds of lights: a box, a cone of axes, an angle of emission and power [Conty and Kulla
 * 2018]. */
#ifndef SCENE_LIGHTS_LIGHT_BOUNDS_H
#define SCENE_LIGHTS_LIGHT_BOUNDS_H

#include "scene/lights/emitter.h"

struct light_bounds {
    float low[3], high[3]; /* box, metres; of distant lights: of unit directions to them */
    float axis[3];         /* unit axis of the cone */
    float theta_o;         /* half angle of the cone of axes, radians */
    float theta_e;         /* greatest angle between an axis and its light, radians */
    float power; /* sum of intensities on the axis, mean of RGB, W/sr (distant: W/m2); 0: dark */
    float reach; /* greatest range, metres, or infinite; 0: distant */
};

/* Returns the bounds of all light of one emitter. */
struct light_bounds light_bounds_of(const struct emitter *emitter);

/* Returns the bounds of a triangle (glsl/shared/light_tree.h). */
struct light_triangle;
struct light_bounds light_bounds_of_triangle(const struct light_triangle *triangle);

/* Returns the bounds of both; dark ones count nothing. */
struct light_bounds light_bounds_merge(const struct light_bounds *a, const struct light_bounds *b);

/* Returns M_O, the solid angle that the lights emit to, each direction weighted by its cosine,
 * sr. */
float light_bounds_orientation(const struct light_bounds *bounds);

#endif
