/* A camera's or light's view: how world points become texels and back.
 *
 * Depth is reversed: near / z for a perspective view, 1 - z / far for an orthographic one; 0 is far,
 * where nothing was drawn. With float depth the relative error of z is then 1e-7 everywhere.
 */
#ifndef SHARED_VIEW_H
#define SHARED_VIEW_H

#include "shared/types.h"

struct view {
    mat4 world_to_clip;
    vec3 origin;
    float near; /* metres */
    vec3 right; /* from the axis to the right edge at z = 1 (orthographic: at any z) */
    BOOL orthographic;
    vec3 up; /* from the axis to the top edge */
    float unused;
    vec3 forward; /* to the middle of the picture, at z = 1 */
    float far;    /* where depth is 1 if linear, metres: 1 m but for an orthographic view */
};
STD140_SIZE(view, 128)

#endif
