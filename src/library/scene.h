/* Shares a scene among users. The scene itself is immutable. World-space triangles move with time,
 * so each user has its own. */
#ifndef LIBRARY_SCENE_H
#define LIBRARY_SCENE_H

#include "library/manylight.h"
#include "renderer/stage.h"

/* A stage that shares the scene's data. The first user gets the scene's triangles, others
 * copies. */
struct loan {
    struct manylight_scene *from;
    struct stage stage;
    bool has_original;
};

/* Lends the scene at time 0 and keeps it alive until loan_return. Error: out of memory. */
bool loan_take(struct loan *loan, const struct manylight_scene *scene);

/* Returns the triangles and releases the scene. Accepts a zeroed loan. */
void loan_return(struct loan *loan);

/* Poses the stage at the view's time and places its camera and lights. Zeroed views select the
 * defaults. */
bool loan_pose(struct loan *loan, const struct manylight_view *view);

/* Writes where the view's placed camera is in the next and the previous frame. */
bool loan_place_others(const struct manylight_view *view, struct camera others[2]);

/* Finds the motion of the posed stage between frames. camera: text of the view's camera. placed:
 * of loan_place_others, NULL: by the text. */
bool loan_find_motion(struct loan *loan, const char *camera, const struct camera *placed,
                      double time, double step, struct surface_motion *motion);

/* Checks the numbers of a camera. Error: names the member that is not finite or out of range. */
bool check_camera(const struct manylight_camera *camera);

/* Finds the picture size in pixels: width x height, or the named camera's size if both are 0.
 * Error: an invalid size or camera. */
bool loan_size(const struct loan *loan, const char *camera, int width, int height, int size[2]);

#endif
