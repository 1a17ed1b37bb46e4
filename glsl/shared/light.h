/* The light and the views from it: one of a spot or a directional light, six of a point light. */
#ifndef SHARED_LIGHT_H
#define SHARED_LIGHT_H

#include "shared/view.h"

#define LIGHT_VIEWS_MAX 6

#define LIGHT_TYPE_SPOT 0
#define LIGHT_TYPE_POINT 1
#define LIGHT_TYPE_DIRECTIONAL 2

struct light_block {
    STRUCT(view) views[LIGHT_VIEWS_MAX];
    vec4 intensity; /* W/sr, W/m2 for a directional light; w: solid angle in sr, area in m2 */
    vec4 position;  /* w: type */
    vec4 direction; /* w: number of views */
    vec4 right;     /* with up and direction orthonormal; w: cos inner */
    vec4 up;        /* w: cos outer */
    float direct_scale; /* of the stored direct irradiance: squared scene radius, m2 */
    float unused0, unused1, unused2;
};

#endif
