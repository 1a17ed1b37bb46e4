/* How a camera is moved by hand: around a point that it looks at, or flying.
 *
 * A pose is eye, forward and up; camera_look makes the frame of the three, so that the same numbers
 * give the same picture everywhere. */
#ifndef VIEWER_ORBIT_H
#define VIEWER_ORBIT_H

#include "scene/camera.h"

struct orbit {
    struct camera camera;
    float point[3];    /* that is circled, and to which a zoom goes */
    float distance;    /* from the eye to it along the view, metres */
    float world_up[3]; /* turning keeps it: a picture that stays level */
    float radius;      /* of the scene, metres: steps are fractions of it */
};

/* Begins at a camera; circles the scene's centre, at its distance along the view. */
void orbit_start(struct orbit *orbit, const struct camera *camera, const float center[3],
                 float radius);

/* Circles another point from now on. */
void orbit_grab(struct orbit *orbit, const float point[3]);

/* Turns around the point, which stays where it is in the picture: right and down by fractions of
 * the picture's height. */
void orbit_turn(struct orbit *orbit, float right, float down);

/* Moves eye and point with the picture: what was under the cursor stays there. */
void orbit_pan(struct orbit *orbit, float right, float down);

/* Goes nearer to the point (steps > 0) or away by a tenth of the distance a step; it stays where it
 * is in the picture. */
void orbit_zoom(struct orbit *orbit, float steps);

/* Looks at a sphere from the present side, so that all of it is in sight; circles its middle. */
void orbit_frame(struct orbit *orbit, const float center[3], float radius, float aspect);

/* Turns the head: the eye stays. */
void orbit_look(struct orbit *orbit, float right, float down);

/* Moves eye and point along the camera's axes, in scene radii. */
void orbit_fly(struct orbit *orbit, float right, float up, float forward);

#endif
