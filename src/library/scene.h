/* Scenes of the library. What a scene holds does not change; its triangles in the world move with time, so each user has them
 * for itself. */
#ifndef LIBRARY_SCENE_H
#define LIBRARY_SCENE_H

#include "library/manylight.h"
#include "renderer/stage.h"

/* A stage at time 0 that shares what the scene holds. The first user gets the triangles that are there, others get copies. */
struct loan {
    struct manylight_scene *from;
    struct stage stage;
    bool has_original;
};

/* Error: memory. */
bool loan_take(struct loan *loan, const struct manylight_scene *scene);

/* Accepts a zeroed one. */
void loan_return(struct loan *loan);

/* Poses the stage and places camera and lights as the view has them. desc: zeroed where there is none. */
bool loan_pose(struct loan *loan, const struct manylight_view *view);

/* Error: names the member that is not finite or out of its range. */
bool check_camera(const struct manylight_camera *camera);

/* width x height, where 0 x 0 stands for the camera's. Error: a size that the program refuses, in its words. */
bool loan_size(const struct loan *loan, const char *camera, int width, int height, int size[2]);

#endif
