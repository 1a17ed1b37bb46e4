/* Fits an environment map by a few infinitely distant area lights [Dong 2011 §5.3.2].
 *
 * The map is drawn onto the faces of a cube. SKY_FIT_RECTANGLES: the brightest free texel grows
 * into a rectangle while a new side adds more than a fraction of its light. Bisection finds the
 * fraction that gives `count` lights. SKY_FIT_EVEN: the area of largest cost is cut in two where
 * the remaining cost is least. Neither sun nor horizon then takes most of the lights.
 *
 * Unlike in the thesis, rectangles do not overlap, and the side that adds most grows first. The
 * lights partition the sphere, so their energy is that of the map in each channel. A constant map
 * lights surfaces exactly. */
#ifndef LIGHTS_ENVIRONMENT_FIT_H
#define LIGHTS_ENVIRONMENT_FIT_H

#include "scene/lights/environment.h"
#include "shared/sky.h"

struct environment_light {
    float radiance[3];   /* constant over the light, W/(sr m2) */
    float corners[4][3]; /* unit directions, ordered so that Lambert's sum over them is positive */
    float solid_angle;   /* sr */
};

enum sky_fit { SKY_FIT_RECTANGLES, SKY_FIT_EVEN };

enum { SKY_FACE_SIZE = 64, ENVIRONMENT_LIGHTS_MIN = 6 };

/* Fits at most `count` lights (ENVIRONMENT_LIGHTS_MIN to ENVIRONMENT_LIGHTS_MAX), brightest first,
 * and returns their number. Black areas have no light. The environment's rotation and strength are
 * ignored: they change no fit. */
int environment_fit(struct environment_light *lights, const struct environment *environment,
                    enum sky_fit fit, int count);

/* Returns the light in world space, with the environment's rotation and strength. */
struct environment_light environment_light_turned(const struct environment_light *light,
                                                  const struct environment *environment);

/* Computes a vector whose dot product with a surface normal is irradiance over radiance, if the
 * whole light is above the horizon. */
void environment_light_vector(const struct environment_light *light, float vector[3]);

/* Computes the direction, not normalised, to the point `place` of the light, in [0, 1]^2. */
void environment_light_direction(const struct environment_light *light, const float place[2],
                                 float direction[3]);

#endif
