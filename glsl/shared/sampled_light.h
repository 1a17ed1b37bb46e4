/* Lights without maps (passes/sampled_lights.h), and parameters of their direct light. */
#ifndef SHARED_SAMPLED_LIGHT_H
#define SHARED_SAMPLED_LIGHT_H

#include "shared/gather.h"
#include "shared/light.h"

#define SAMPLED_LIGHT_ROWS 7

struct sampled_light {
    vec3 intensity;    /* W/sr on the axis */
    float flux_before; /* flux of all lights before this one, over that of all */
    vec3 position;
    float flux;     /* over that of all */
    vec3 direction; /* orthonormal with right and up; those of a triangle are its edges */
    int type;       /* LIGHT_TYPE_... */
    vec3 right;
    float cos_inner;
    vec3 up;
    float cos_outer;
    float width, height; /* as in struct emitter */
    int shape;           /* LIGHT_SHAPE_... */
    float range_inverse2;
    int slide; /* as in struct light, with the next three */
    float slide_scale, slide_width, slide_height;
};
STD140_SIZE(sampled_light, 16 * SAMPLED_LIGHT_ROWS)

/* Parameters of passes/visibility/sampled_direct.h. */
#define UNIT_EXACT (UNIT_OWN + 0)
#define UNIT_EXACT_SPECULAR (UNIT_OWN + 1)

struct sampled_direct_params {
    int samples;       /* of a pixel with neighbours on its surface */
    int alone_samples; /* of a pixel without */
    float distance;    /* within which neighbours count, over the picture's height at their depth */
    float cosine;      /* least cosine between their normals */
    float scale;       /* of the stored irradiance */
    float turn;        /* of the pass: shift of all numbers */
    int pass;          /* index of the pass */
    int unused;
};
STD140_SIZE(sampled_direct_params, 32)

/* Parameters of passes/gather/near_sampled.h. */
struct near_sampled_params {
    STRUCT(interleaving) pattern;
    int many;    /* number of the light that is all sampled lights */
    int rays;    /* of a pixel */
    float scale; /* of the stored irradiance */
    int pass;    /* index of the pass */
};
STD140_SIZE(near_sampled_params, 32)

#endif
