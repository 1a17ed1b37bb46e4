/* Cameras placed in the world. */
#ifndef SCENE_CAMERA_H
#define SCENE_CAMERA_H

#include "scene/scene.h"

enum camera_lens {
    LENS_PINHOLE,
    LENS_EQUIRECTANGULAR,
    LENS_CUBE,
    LENS_EQUIDISTANT,
    LENS_EQUISOLID
};
extern const char *const camera_lens_names[];

struct camera {
    bool orthographic;
    float eye[3];
    /* Orthogonal axes; right, up, -forward are right-handed. forward is the unit view direction.
     * Longer right and up widen the picture. */
    float right[3], up[3], forward[3];
    float fov_y;     /* radians, vertical */
    float y_extent;  /* orthographic: half the height, metres */
    float near, far; /* clip distances along forward, metres; far 0: infinite */
    /* Shifted lens: place of the picture's middle, from the axis to the right and up, in halves of
     * the width and height. */
    float shift[2];
    enum camera_lens lens;     /* scene/lens.h; wide ones have near and far as distances */
    float skew, distortion[8]; /* of a pinhole, scene/lens.h */
    int size[2];               /* size of the picture that intrinsics are for, pixels; 0: none */
};

/* A small plane that measures the light of its front. */
struct sensor {
    float position[3], normal[3]; /* metres; unit */
};

/* Places an orthographic camera `distance` metres in front of a sensor, whose picture is 2 `half`
 * high. */
void camera_face(struct camera *camera, const struct sensor *sensor, float distance, float half);

/* Places the camera of the scene's n-th camera node, which must exist. time: seconds. */
void camera_place(struct camera *camera, const struct scene *scene, int n, double time);

/* Moves the camera. `forward` and `up` need not be unit or perpendicular. */
void camera_look(struct camera *camera, const float eye[3], const float forward[3],
                 const float up[3]);

/* Sets the field of view by a pinhole's intrinsics, pixels: focal lengths fx and fy, and the
 * principal point from the top left corner of a picture of `size`. The pixel's first centre is at
 * .5, .5. Axes must be unit. Error: a number that no picture has. */
bool camera_set_intrinsics(struct camera *camera, const double intrinsics[4], const int size[2]);

/* Sets eye and axes by a matrix from camera to world, row by row. The camera's axes are x right, y
 * up, z back (OpenGL), or x right, y down, z forward (opencv). Error: it is not rigid. */
bool camera_set_pose(struct camera *camera, const double pose[16], bool opencv);

/* True if the lens is no pinhole; if the pinhole is distorted or skewed. Frames show neither. */
bool camera_is_wide(const struct camera *camera);
bool camera_is_distorted(const struct camera *camera);

/* Writes the default picture size of the scene's n-th camera: 800 pixels along the longer side in
 * the camera's aspect ratio; square without one. */
void camera_default_size(const struct scene *scene, int n, int size[2]);

/* Error: a frame that is not orthogonal, an angle of view of pi or more, a negative length, or that
 * of lens_check. */
bool camera_check(const struct camera *camera);

/* Returns the squared length of an axis. Unit axes have exactly 1, whatever their rounding. */
float camera_axis_norm2(const float axis[3]);

bool cameras_same(const struct camera *a, const struct camera *b);

int camera_find(const struct scene *scene, const char *text);
int camera_node_count(const struct scene *scene);

/* Returns the ray through a point of the picture, x and y in [0, 1] from the top left corner. The
 * direction is unit. aspect: width / height. */
void camera_ray(const struct camera *camera, float x, float y, float aspect, float origin[3],
                float direction[3]);

/* Projects a point to the picture, in the coordinates of camera_ray. False: it is not in front of
 * the camera. */
bool camera_project(const struct camera *camera, const float point[3], float aspect,
                    float place[2]);

/* Write the transforms as OpenEXR defines them: row vectors times a matrix of four rows. Camera
 * space has x right, y up and z forward. NDC have x from the left and y from the top in [0, 1],
 * after division by w. Their z is 0 at near and 1 at far. Without far it is near over depth. */
void camera_world_to_camera(const struct camera *camera, float matrix[16]);
void camera_world_to_ndc(const struct camera *camera, float aspect, float matrix[16]);

#endif
