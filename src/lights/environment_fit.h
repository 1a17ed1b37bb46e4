/* An environment as a few area lights, infinitely far away [Dong 2011 §5.3.2].
 *
 * The map is drawn onto the six faces of a cube. There the brightest texel that no light has yet grows into
 * a rectangle, as long as what a side would add is more than a share of what the rectangle has; again,
 * until each texel has its light. In an even sky a side thus stops at 1 / share texels; which share makes
 * so many lights is found by bisection. Or even parts: the area with the largest cost (spread_of) is cut in two where
 * that leaves the least cost, so that neither a sun nor a horizon takes most of the lights.
 *
 * Unlike in the thesis rectangles do not overlap, and where a side could grow that which adds most goes
 * first. Edges of faces are great circles, so that the lights part the sphere: their energy is the map's,
 * channel by channel, and an even sky lights a surface as the whole sky does, exactly.
 */
#ifndef LIGHTS_ENVIRONMENT_FIT_H
#define LIGHTS_ENVIRONMENT_FIT_H

#include "scene/lights/environment.h"
#include "shared/sky.h"

struct environment_light {
    float radiance[3];   /* even, W/(sr m2) */
    float corners[4][3]; /* unit directions; in turn, so that Lambert's sum over them is positive */
    float solid_angle;
};

enum sky_fit { SKY_FIT_RECTANGLES, SKY_FIT_EVEN };

enum { SKY_FACE_SIZE = 64, ENVIRONMENT_LIGHTS_MIN = 6 };

/* At most `count` lights, ENVIRONMENT_LIGHTS_MIN to ENVIRONMENT_LIGHTS_MAX; the brightest first. What is black has none. Returned is
 * how many there are. As the map lies, without its turn and strength: those change no fit. */
int environment_fit(struct environment_light *lights, const struct environment *environment,
                    enum sky_fit fit, int count);

/* The light in the world, with the environment's turn and strength. */
struct environment_light environment_light_turned(const struct environment_light *light,
                                                  const struct environment *environment);

/* What it gives a surface that faces it, as a vector: irradiance over radiance where all of the light is
 * above the horizon is the product with the normal. */
void environment_light_vector(const struct environment_light *light, float vector[3]);

/* Towards a place of it, two numbers in [0, 1]; not unit. */
void environment_light_direction(const struct environment_light *light, const float place[2],
                                 float direction[3]);

#endif
