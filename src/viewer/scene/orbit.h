/* Moves a camera by hand: around a point that it looks at, or flying.
 *
 * A pose is eye, forward and up; camera_look makes the frame of the three, so that the same numbers
 * give the same picture everywhere. */
#ifndef VIEWER_ORBIT_H
#define VIEWER_ORBIT_H

#include "scene/camera.h"

struct orbit {
    struct camera camera;
    float point[3];    /* centre of turning and zooming */
    float distance;    /* from the eye to the point along the view, metres */
    float world_up[3]; /* turning keeps this axis, so that the horizon stays level */
    float radius;      /* of the scene, metres; steps are fractions of it */
};

/* Starts at a camera. The point lies at the distance of the scene's centre along the view. */
void orbit_start(struct orbit *orbit, const struct camera *camera, const float center[3],
                 float radius);

/* Sets another point to circle. */
void orbit_grab(struct orbit *orbit, const float point[3]);

/* Turns around the point, which stays where it is in the picture: right and down by fractions of
 * the picture's height. */
void orbit_turn(struct orbit *orbit, float right, float down);

/* Moves eye and point, so that the point under the cursor stays there. */
void orbit_pan(struct orbit *orbit, float right, float down);

/* Moves towards the point (steps > 0) or away, by a tenth of the distance per step. The point
 * keeps its place in the picture. */
void orbit_zoom(struct orbit *orbit, float steps);

/* Looks at a whole sphere from the present side, and circles its middle. */
void orbit_frame(struct orbit *orbit, const float center[3], float radius, float aspect);

/* Turns the view; the eye stays. */
void orbit_look(struct orbit *orbit, float right, float down);

/* Moves eye and point along the camera's axes, in scene radii. */
void orbit_fly(struct orbit *orbit, float right, float up, float forward);

#endif
