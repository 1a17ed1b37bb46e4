/* The environment for the path tracer: samples directions by radiance x solid angle, texel by
 * texel. */
#ifndef REFERENCE_SCENE_SKY_H
#define REFERENCE_SCENE_SKY_H

#include "reference/alias.h"
#include "scene/lights/emitter.h"
#include "scene/lights/environment.h"

struct sky {
    const struct environment *environment;
    struct alias rows, *columns; /* one for each row that is not black */
    double power;                /* integral of R + G + B over all directions */
};

/* Builds the tables. False: the environment is black. */
bool sky_init(struct sky *sky, const struct environment *environment);

/* Accepts a zeroed object. */
void sky_free(struct sky *sky);

/* Returns a directional light for two numbers in [0, 1); its mean is the whole environment.
 * density: of its direction, 1/sr. */
struct emitter sky_piece(const struct sky *sky, const float place[2], double *density);

/* Returns the density of a unit direction, 1/sr. */
double sky_density(const struct sky *sky, const float direction[3]);

#endif
