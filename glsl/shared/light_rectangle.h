/* The rectangle of an area light that stands for a cluster of VPLs (passes/lights/cluster_light.h). Transform
 * feedback writes it (lights/cluster_light.vert); the gather reads it in a block. All else of the light is a
 * VPL's: position, normal, area, flux. */
#ifndef SHARED_LIGHT_RECTANGLE_H
#define SHARED_LIGHT_RECTANGLE_H

#include "shared/types.h"

#define UNIT_SUM_SQUARES (UNIT_OWN + 0)
#define UNIT_SUM_PRODUCTS (UNIT_OWN + 1)

#define LIGHT_RECTANGLE_ROWS 2

/* What a cluster's light is. A disk has the area of its VPLs, and no more of a shape. */
#define LIGHT_FORM_RECTANGLE 0
#define LIGHT_FORM_DISK 1

struct light_rectangle {
    vec3 right; /* half a side, metres; right x up is along the normal */
    float unused0;
    vec3 up;
    float unused1;
};
STD140_SIZE(light_rectangle, 16 * LIGHT_RECTANGLE_ROWS)

#define LIGHT_RECTANGLES_MAX 1024

#endif
