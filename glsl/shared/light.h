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
    vec3 intensity; /* W/sr, of a directional light W/m2 */
    float measure;  /* what it shines into: solid angle, sr; of a directional light area, m2 */
    vec3 position;
    int type;       /* LIGHT_TYPE_... */
    vec3 direction; /* with right and up orthonormal */
    int view_count;
    vec3 right;
    float cos_inner;
    vec3 up;
    float cos_outer;
    float direct_scale; /* of the stored direct irradiance: squared scene radius, m2 */
    float unused0, unused1, unused2;
};
STD140_SIZE(light_block, LIGHT_VIEWS_MAX * 128 + 96)

#endif
