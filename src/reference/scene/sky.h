/* The environment as a path tracer needs it: directions picked by radiance x solid angle, a texel at a
 * time, and how likely they are. */
#ifndef REFERENCE_SCENE_SKY_H
#define REFERENCE_SCENE_SKY_H

#include "reference/alias.h"
#include "scene/lights/emitter.h"
#include "scene/lights/environment.h"

struct sky {
    const struct environment *environment;
    struct alias rows, *columns; /* of each row that is not black */
    double power;                /* the integral of the sum over RGB over all directions */
};

/* False where it is black: nothing can be picked then. */
bool sky_init(struct sky *sky, const struct environment *environment);

/* Accepts zeroed ones. */
void sky_free(struct sky *sky);

/* The directional light that the whole sky is on average, from the direction that two numbers in [0, 1)
 * pick; with which density they do, 1/sr. */
struct emitter sky_piece(const struct sky *sky, const float place[2], double *density);

/* The density with which a direction to the sky, unit, is picked. */
double sky_density(const struct sky *sky, const float direction[3]);

#endif
