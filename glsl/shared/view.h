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
    vec4 origin;  /* w: near, metres */
    vec4 right;   /* from the axis to the right edge at z = 1 (orthographic: at any z); w: 1 if orthographic */
    vec4 up;      /* from the axis to the top edge; w unused */
    vec4 forward; /* unit; w: far, metres, of an orthographic view */
};

#endif
