/* The medium for the path tracer: transmittance between points, and scattering. */
#ifndef REFERENCE_SCENE_MEDIUM_BALL_H
#define REFERENCE_SCENE_MEDIUM_BALL_H

#include "base/unit.h"
#include "scene/mesh/geometry.h"

/* All zero: no medium. */
struct medium_ball {
    bool exists;
    vec3s scattering, extinction; /* 1/m */
    float g;
    vec3s center; /* centre of the ball with the medium, the scene's bounding sphere */
    float radius; /* metres */
};

struct medium_ball medium_ball_of(const struct medium *medium, const struct geometry *geometry);

/* Writes the interval of a ray inside the medium, metres. direction: unit. False: empty. */
bool medium_segment(const struct medium_ball *medium, vec3s origin, vec3s direction, float length,
                    float segment[2]);

/* Return the transmittance of `length` metres of the medium, and along a ray up to `length`. 1
 * without a medium. */
vec3s medium_passes(const struct medium_ball *medium, float length);
vec3s medium_transmittance(const struct medium_ball *medium, vec3s origin, vec3s direction,
                           float length);

/* Returns the Henyey-Greenstein phase function, 1/sr, by the cosine between the directions of
 * travel. */
float medium_phase(float g, float cosine);

#endif
