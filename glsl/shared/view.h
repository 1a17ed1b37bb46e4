/* View of a camera or light: transforms between world points and texels.
 *
 * Depth is reversed: near / z for a perspective view, 1 - z / far for an orthographic one; 0 is the
 * far plane. With float depth the relative error of z is then 1e-7 everywhere. */
#ifndef SHARED_VIEW_H
#define SHARED_VIEW_H

#include "shared/types.h"

struct view {
    mat4 world_to_clip;
    vec3 origin;
    float near; /* metres */
    vec3 right; /* from the axis to the right edge at z = 1 (orthographic: at any z) */
    BOOL orthographic;
    vec3 up;      /* from the axis to the top edge */
    BOOL leans;   /* the camera has a shifted lens: forward is not along the axis */
    vec3 forward; /* to the picture's centre, at z = 1 */
    float far;    /* distance of linear depth 1, metres: 1 m except for an orthographic view */
};
STD140_SIZE(view, 128)

#endif
