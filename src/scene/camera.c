#include "scene/camera.h"

#include "base/error.h"
#include "base/unit.h"
#include "scene/animated.h"
#include "scene/lens.h"
#include "scene/node.h"

#include <math.h>
#include <string.h>

int camera_node_count(const struct scene *scene) {
    return node_count_carrying(scene, NODE_CAMERA);
}

bool cameras_same(const struct camera *a, const struct camera *b) {
    return a->orthographic == b->orthographic && a->fov_y == b->fov_y &&
           a->y_extent == b->y_extent && a->near == b->near && a->far == b->far &&
           memcmp(a->eye, b->eye, sizeof a->eye) == 0 &&
           memcmp(a->right, b->right, sizeof a->right) == 0 &&
           memcmp(a->up, b->up, sizeof a->up) == 0 &&
           memcmp(a->forward, b->forward, sizeof a->forward) == 0 && a->shift[0] == b->shift[0] &&
           a->shift[1] == b->shift[1] && a->lens == b->lens && a->skew == b->skew &&
           memcmp(a->distortion, b->distortion, sizeof a->distortion) == 0;
}

int camera_find(const struct scene *scene, const char *text) {
    return node_find_carrying(scene, NODE_CAMERA, text);
}

void camera_place(struct camera *camera, const struct scene *scene, int n, double time) {
    int node = node_carrying(scene, NODE_CAMERA, n);
    const struct scene_camera source = animated_camera(scene, scene->nodes[node].camera, time);
    float world[16];
    node_world(scene, node, time, world);
    *camera = (struct camera){.orthographic = source.orthographic,
                              .fov_y = source.fov_y,
                              .y_extent = source.y_extent,
                              .near = source.near,
                              .far = source.far};
    memcpy(camera->eye, &world[12], sizeof camera->eye);
    node_frame(world, camera->right, camera->up, camera->forward);
}

void camera_default_size(const struct scene *scene, int n, int size[2]) {
    const float side = 800;
    int node = node_carrying(scene, NODE_CAMERA, n);
    float aspect = scene->cameras[scene->nodes[node].camera].aspect;
    aspect = aspect > 0 ? aspect : 1;
    size[0] = (int)lroundf(side * fminf(aspect, 1));
    size[1] = (int)lroundf(side / fmaxf(aspect, 1));
}

void camera_look(struct camera *camera, const float eye[3], const float forward[3],
                 const float up[3]) {
    vec3 direction, right;
    vec3_unit_to((float *)forward, direction);
    glm_vec3_cross(direction, (float *)up, right);
    vec3_unit(right);
    glm_vec3_copy((float *)eye, camera->eye);
    glm_vec3_copy(direction, camera->forward);
    glm_vec3_copy(right, camera->right);
    glm_vec3_cross(right, direction, camera->up);
}

float camera_axis_norm2(const float axis[3]) {
    float norm2 = glm_vec3_norm2((float *)axis);
    return fabsf(norm2 - 1) < 1e-5F ? 1 : norm2;
}

void camera_face(struct camera *camera, const struct sensor *sensor, float distance, float half) {
    bool upright = fabsf(sensor->normal[1]) < .9F;
    vec3 eye, forward, up = {upright ? 0 : 1, upright ? 1 : 0, 0};
    glm_vec3_copy((float *)sensor->position, eye);
    glm_vec3_muladds((float *)sensor->normal, distance, eye);
    glm_vec3_negate_to((float *)sensor->normal, forward);
    *camera = (struct camera){.orthographic = true, .y_extent = half};
    camera_look(camera, eye, forward, up);
}

/* The axes come as text of a few digits. */
static bool are_orthogonal(const float a[3], const float b[3]) {
    const float most = 2e-3F;
    float lengths = glm_vec3_norm((float *)a) * glm_vec3_norm((float *)b);
    return lengths > 0 && fabsf(glm_vec3_dot((float *)a, (float *)b)) <= most * lengths;
}

static bool check_frame(const struct camera *camera) {
    vec3 back;
    if (glm_vec3_norm((float *)camera->right) == 0)
        return error_set("up is along forward");
    if (!are_orthogonal(camera->right, camera->up) ||
        !are_orthogonal(camera->right, camera->forward) ||
        !are_orthogonal(camera->up, camera->forward))
        return error_set("right, up and forward are not at right angles to each other");
    if (fabsf(glm_vec3_norm((float *)camera->forward) - 1) > 2e-3F)
        return error_set("forward has the length %g, not 1, beside right",
                         (double)glm_vec3_norm((float *)camera->forward));
    glm_vec3_cross((float *)camera->right, (float *)camera->up, back);
    return glm_vec3_dot(back, (float *)camera->forward) < 0 ||
           error_set("right points to the left of forward and up");
}

bool camera_set_intrinsics(struct camera *camera, const double intrinsics[4], const int size[2]) {
    const double fx = intrinsics[0], fy = intrinsics[1], cx = intrinsics[2], cy = intrinsics[3];
    const double width = size[0], height = size[1];
    if (size[0] <= 0 || size[1] <= 0)
        return error_set("intrinsics: %dx%d is no size of a picture", size[0], size[1]);
    if (!(fx > 0 && fy > 0 && isfinite(fx) && isfinite(fy)))
        return error_set("intrinsics: focal lengths of %g and %g pixels are not above 0", fx, fy);
    if (!isfinite(cx) || !isfinite(cy))
        return error_set("intrinsics: the principal point %g, %g is not finite", cx, cy);
    camera->orthographic = false;
    camera->size[0] = size[0];
    camera->size[1] = size[1];
    camera->fov_y = (float)(2 * atan(height / (2 * fy)));
    camera->shift[0] = (float)(1 - 2 * cx / width);
    camera->shift[1] = (float)(2 * cy / height - 1);
    glm_vec3_scale(camera->right, (float)(fy / fx), camera->right);
    return true;
}

bool camera_set_pose(struct camera *camera, const double pose[16], bool opencv) {
    float *const axes[3] = {camera->right, camera->up, camera->forward};
    bool ends = pose[12] == 0 && pose[13] == 0 && pose[14] == 0 && pose[15] == 1;
    for (int row = 0; row < 3; row++) {
        camera->eye[row] = (float)pose[4 * row + 3];
        ends &= isfinite(camera->eye[row]);
        for (int axis = 0; axis < 3; axis++) {
            bool flips = axis == 1 ? opencv : axis == 2 ? !opencv : false;
            axes[axis][row] = (float)(flips ? -pose[4 * row + axis] : pose[4 * row + axis]);
        }
    }
    if (!ends)
        return error_set("pose: its last row is not 0 0 0 1, or its last column is not finite");
    for (int axis = 0; axis < 3; axis++)
        if (!(fabsf(glm_vec3_norm(axes[axis]) - 1) <= 2e-3F))
            return error_set("pose: column %d has the length %g, not 1", axis,
                             (double)glm_vec3_norm(axes[axis]));
    return check_frame(camera) || error_prefix("pose");
}

bool camera_check(const struct camera *camera) {
    bool has_view = camera_is_wide(camera) ||
                    (camera->orthographic ? camera->y_extent > 0
                                          : camera->fov_y > 0 && camera->fov_y < GLM_PIf);
    if (!has_view && camera->orthographic)
        return error_set("extent: %g m is not above 0", (double)camera->y_extent);
    if (!has_view)
        return error_set("fov: %g is not between 0 and pi radians", (double)camera->fov_y);
    if (!isfinite(camera->shift[0]) || !isfinite(camera->shift[1]))
        return error_set("shift: %g,%g is not finite", (double)camera->shift[0],
                         (double)camera->shift[1]);
    if (camera->near < 0 || camera->far < 0)
        return error_set("near=%g far=%g: less than none", (double)camera->near,
                         (double)camera->far);
    return check_frame(camera) && lens_check(camera);
}

/* Takes a place at depth 1 to that of its ray, x right and y up in the camera's axes; or back. */
static void distort(const struct camera *camera, bool back, float *across, float *above) {
    double right = sqrt((double)camera_axis_norm2(camera->right)), out[2];
    const double plane[2] = {(double)*across * right, (double)-*above};
    if (back)
        lens_undistort(camera, plane, out);
    else
        lens_distort(camera, plane, out);
    *across = (float)(out[0] / right);
    *above = (float)-out[1];
}

void camera_ray(const struct camera *camera, float x, float y, float aspect, float origin[3],
                float direction[3]) {
    float half = camera->orthographic ? camera->y_extent : tanf(camera->fov_y / 2);
    float across = (2 * x - 1 + camera->shift[0]) * half * aspect;
    float above = (1 - 2 * y + camera->shift[1]) * half;
    vec3 offset;
    if (camera_is_wide(camera)) {
        memcpy(origin, camera->eye, sizeof camera->eye);
        lens_ray(camera, x, y, aspect, direction);
        return;
    }
    if (camera_is_distorted(camera))
        distort(camera, true, &across, &above);
    for (int c = 0; c < 3; c++)
        offset[c] = across * camera->right[c] + above * camera->up[c];
    memcpy(origin, camera->eye, sizeof camera->eye);
    memcpy(direction, camera->forward, sizeof camera->forward);
    glm_vec3_add(camera->orthographic ? origin : direction, offset,
                 camera->orthographic ? origin : direction);
    vec3_unit(direction);
}

bool camera_project(const struct camera *camera, const float point[3], float aspect,
                    float place[2]) {
    vec3 to_point;
    glm_vec3_sub((float *)point, (float *)camera->eye, to_point);
    if (camera_is_wide(camera)) {
        lens_project(camera, to_point, aspect, place);
        return true;
    }
    float depth = glm_vec3_dot(to_point, (float *)camera->forward);
    float half = camera->orthographic ? camera->y_extent : tanf(camera->fov_y / 2) * depth;
    if (depth <= 0)
        return false;
    float right = glm_vec3_dot(to_point, (float *)camera->right) / (half * aspect);
    float up = glm_vec3_dot(to_point, (float *)camera->up) / half;
    right /= camera_axis_norm2(camera->right);
    up /= camera_axis_norm2(camera->up);
    if (camera_is_distorted(camera)) {
        float across = tanf(camera->fov_y / 2) * aspect, above = tanf(camera->fov_y / 2);
        right *= across;
        up *= above;
        distort(camera, false, &right, &up);
        right /= across;
        up /= above;
    }
    place[0] = .5F + .5F * (right - camera->shift[0]);
    place[1] = .5F - .5F * (up - camera->shift[1]);
    return true;
}

void camera_world_to_camera(const struct camera *camera, float matrix[16]) {
    const float *const axes[3] = {camera->right, camera->up, camera->forward};
    for (int column = 0; column < 3; column++) {
        float length = sqrtf(camera_axis_norm2(axes[column]));
        for (int row = 0; row < 3; row++)
            matrix[4 * row + column] = axes[column][row] / length;
        matrix[12 + column] = -glm_vec3_dot((float *)axes[column], (float *)camera->eye) / length;
    }
    for (int row = 0; row < 4; row++)
        matrix[4 * row + 3] = row == 3 ? 1 : 0;
}

/* A column is a plane: that of its coordinate times w. */
void camera_world_to_ndc(const struct camera *camera, float aspect, float matrix[16]) {
    float view[16], half = camera->orthographic ? camera->y_extent : tanf(camera->fov_y / 2),
                    depth = camera->far > 0 ? 1 / (camera->far - camera->near) : 1;
    float right = sqrtf(camera_axis_norm2(camera->right)) * half * aspect;
    float up = sqrtf(camera_axis_norm2(camera->up)) * half;
    if (!camera->orthographic && camera->far > 0)
        depth *= camera->far;
    camera_world_to_camera(camera, view);
    for (int row = 0; row < 4; row++) {
        const float *from = view + 4 * row;
        float *to = matrix + 4 * row, w = camera->orthographic ? from[3] : from[2];
        to[0] = .5F * (from[0] / right + w - camera->shift[0] * w);
        to[1] = .5F * (w - from[1] / up + camera->shift[1] * w);
        to[2] = depth * (from[2] - camera->near * from[3]);
        to[3] = w;
    }
}
