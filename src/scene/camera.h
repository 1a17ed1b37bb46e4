/* A camera placed in the world. */
#ifndef SCENE_CAMERA_H
#define SCENE_CAMERA_H

#include "scene/scene.h"

struct camera {
    bool orthographic;
    float eye[3];
    float right[3], up[3],
        forward[3]; /* orthogonal, right-handed with -forward, where it looks. Longer right and
                                          up widen the picture; forward is unit */
    float fov_y;    /* radians, vertical */
    float y_extent; /* orthographic: half the height, metres */
    float near,
        far; /* what lies nearer or farther along forward is not seen, metres; far 0 = no end */
};

/* Places the scene's n-th camera node. Asserts that there is one. */
void camera_place(struct camera *camera, const struct scene *scene, int n, double time);

/* Moves the camera: its frame is made of a direction and of what shall be up, neither unit nor
 * perpendicular. */
void camera_look(struct camera *camera, const float eye[3], const float forward[3],
                 const float up[3]);

/* The size of a picture of the scene's n-th camera where none is asked for: 800 pixels along the longer side, in
 * the camera's aspect ratio; square where it tells none. */
void camera_default_size(const struct scene *scene, int n, int size[2]);

/* Error: a frame that is not orthogonal, an angle of view of pi or more, a negative length. */
bool camera_check(const struct camera *camera);

bool cameras_same(const struct camera *a, const struct camera *b);

int camera_find(const struct scene *scene, const char *text);
int camera_node_count(const struct scene *scene);

/* The ray through a point of the picture, x and y in [0, 1] from the top left corner. The direction
 * is unit. aspect = width / height. */
void camera_ray(const struct camera *camera, float x, float y, float aspect, float origin[3],
                float direction[3]);

/* The other way round: where a point lies in the picture. False: not in front of the camera. */
bool camera_project(const struct camera *camera, const float point[3], float aspect,
                    float place[2]);

/* The same for other programs, by the conventions of OpenEXR: row vectors times a matrix of four rows. Camera space has x
 * right, y up and z forward. NDC are x from the left and y from the top in [0, 1], after the division by w; z is 0 at near
 * and 1 at far, or without end the distance to near over the depth. */
void camera_world_to_camera(const struct camera *camera, float matrix[16]);
void camera_world_to_ndc(const struct camera *camera, float aspect, float matrix[16]);

#endif
