/* How a point looks itself up in a map of depth: a projection, which says where the map has it, and a
 * filter, which says which part of the light reaches it (visibility/lookup.glsl). */
#ifndef SHARED_LOOKUP_H
#define SHARED_LOOKUP_H

#include "shared/types.h"

#define PROJECTION_PARABOLOID 0   /* struct map_view */
#define PROJECTION_PERSPECTIVE 1  /* struct view */
#define PROJECTION_ORTHOGRAPHIC 2 /* struct view */
#define PROJECTION_LIGHT_MAP 3    /* struct light_map of visibility/light_map.glsl */

#define FILTER_NONE 0        /* all is lit */
#define FILTER_HARD 1        /* one texel */
#define FILTER_CSSM 2        /* convolution soft shadow maps */
#define FILTER_PCSS 3        /* percentage-closer soft shadows */
#define FILTER_PCF 4         /* the four nearest texels, weighted */
#define FILTER_RAY 5         /* the texels along the ray to a VPL */
#define FILTER_VSSM 6        /* variance soft shadow maps */
#define FILTER_MSM 7         /* moment shadow maps */
#define FILTER_CSSM_WINDOW 8 /* convolution soft shadow maps of lights' own maps */
#define FILTER_PLANE 9       /* one texel, and the plane of the caster there */
#define FILTER_TRACED 10     /* a ray to a VPL through the scene's triangles */

struct lookup_params {
    float bias;     /* of the point along its normal, texels of the map */
    float map_size; /* texels */
    float map_bias; /* of the point where it is compared with a texel, of its distance */
    float shift;    /* FILTER_CSSM: of the receiver, in the argument of the series */
    float gain;     /* of the blocked part, about a half; FILTER_CSSM_WINDOW: from nothing */
    float contact; /* windowed filters: what is nearer than this, of its distance, is compared */
    int map_count; /* VALs' maps */
    int unused0;
};
STD140_SIZE(lookup_params, 32)

#endif
