/* The medium as a path tracer needs it: how much light gets from one point to another, and how it is scattered. */
#ifndef REFERENCE_SCENE_MEDIUM_BALL_H
#define REFERENCE_SCENE_MEDIUM_BALL_H

#include "base/unit.h"
#include "scene/mesh/geometry.h"

/* All zero: none. */
struct medium_ball {
    bool exists;
    vec3s scattering, extinction; /* 1/m */
    float g;
    vec3s center; /* of the ball that the medium fills, the scene's bounding sphere */
    float radius; /* metres */
};

struct medium_ball medium_ball_of(const struct medium *medium, const struct geometry *geometry);

/* From where to where a ray of that unit direction and length is in the medium, metres; false: nowhere. */
bool medium_segment(const struct medium_ball *medium, vec3s origin, vec3s direction, float length,
                    float segment[2]);

/* The share of light that passes so many metres of the medium; and that gets so far along a ray. 1 without a medium. */
vec3s medium_passes(const struct medium_ball *medium, float length);
vec3s medium_transmittance(const struct medium_ball *medium, vec3s origin, vec3s direction,
                           float length);

/* Henyey and Greenstein's phase function, 1/sr, by the cosine between the directions in which light travels. */
float medium_phase(float g, float cosine);

#endif
