#include "scene/camera_range.h"

#include "base/log.h"
#include "scene/node.h"

#include <cglm/cglm.h>
#include <math.h>
#include <string.h>

enum {
    SIDES = 4,
    CORNERS_MAX = 3 + SIDES + 2, /* each plane adds one to a triangle */
};

/* Beyond the picture's edges by so much: its pixels move by half of one. */
static const float margin = 1.02F;

struct frustum {
    const struct camera *camera;
    float half[2]; /* of the picture, at a depth of 1; of an orthographic one everywhere */
    float near, far;
};

static struct frustum frustum_of(const struct camera *camera, float aspect) {
    float half = margin * (camera->orthographic ? camera->y_extent : tanf(camera->fov_y / 2));
    return (struct frustum){.camera = camera, .half = {half * aspect, half}};
}

/* To the right and up, in lengths of these axes, and along forward. */
static void in_camera(const struct camera *camera, const float point[3], vec3 local) {
    vec3 from_eye;
    glm_vec3_sub((float *)point, (float *)camera->eye, from_eye);
    local[0] = glm_vec3_dot(from_eye, (float *)camera->right) / camera_axis_norm2(camera->right);
    local[1] = glm_vec3_dot(from_eye, (float *)camera->up) / camera_axis_norm2(camera->up);
    local[2] = glm_vec3_dot(from_eye, (float *)camera->forward);
}

/* How far inside a plane the point is: the four sides, near, far. */
static float inside(const struct frustum *frustum, int plane, const vec3 local) {
    if (plane == SIDES)
        return local[2] - frustum->near;
    if (plane > SIDES)
        return frustum->far - local[2];
    int axis = plane / 2;
    float edge = frustum->half[axis] * (frustum->camera->orthographic ? 1 : local[2]);
    float aside = local[axis] - frustum->camera->shift[axis] * edge / margin;
    return plane % 2 ? edge - aside : edge + aside;
}

/* [Sutherland and Hodgman 1974] */
static int cut(const struct frustum *frustum, int plane, vec3 *corners, int count) {
    vec3 kept[CORNERS_MAX];
    int made = 0;
    for (int i = 0; i < count; i++) {
        float *a = corners[i], *b = corners[(i + 1) % count];
        float at_a = inside(frustum, plane, a), at_b = inside(frustum, plane, b);
        if (at_a > 0)
            glm_vec3_copy(a, kept[made++]);
        if ((at_a > 0) != (at_b > 0) && made < CORNERS_MAX)
            glm_vec3_lerp(a, b, at_a / (at_a - at_b), kept[made++]);
        if (made == CORNERS_MAX)
            break;
    }
    memcpy(corners, kept, (size_t)made * sizeof *kept);
    return made;
}

static bool holds_triangle(const struct frustum *frustum, const struct geometry *geometry,
                           const uint32_t index[3]) {
    vec3 corners[CORNERS_MAX];
    int count = 3;
    for (int k = 0; k < 3; k++)
        in_camera(frustum->camera, geometry->position[index[k]], corners[k]);
    for (int plane = SIDES + 1; plane >= 0 && count > 0; plane--)
        if (plane <= SIDES || isfinite(frustum->far))
            count = cut(frustum, plane, corners, count);
    return count > 0;
}

/* Depths of the box that a part's vertices are in. */
static void depths_of(const struct geometry_part *part, const struct camera *camera, float *nearest,
                      float *farthest) {
    *nearest = INFINITY;
    *farthest = -INFINITY;
    for (int corner = 0; corner < 8; corner++) {
        vec3 point, local;
        for (int c = 0; c < 3; c++)
            point[c] = (corner >> c & 1 ? part->bounds_max : part->bounds_min)[c];
        in_camera(camera, point, local);
        *nearest = fminf(*nearest, local[2]);
        *farthest = fmaxf(*farthest, local[2]);
    }
}

/* How many triangles of the scene lie in the frustum between the two depths, at least in part; up
 * to most. */
static size_t count_triangles(struct frustum frustum, const struct geometry *geometry, float near,
                              float far, size_t most) {
    size_t count = 0;
    frustum.near = near;
    frustum.far = far;
    if (!(near < far))
        return 0;
    for (int p = 0; p < geometry->part_count && count < most; p++) {
        const struct geometry_part *part = &geometry->parts[p];
        float nearest, farthest;
        depths_of(part, frustum.camera, &nearest, &farthest);
        if (farthest <= near || nearest >= far)
            continue;
        for (uint32_t i = 0; i + 2 < part->index_count && count < most; i += 3)
            count += holds_triangle(&frustum, geometry, &geometry->indices[part->first_index + i]);
    }
    return count;
}

static bool holds_something(struct frustum frustum, const struct geometry *geometry, float near,
                            float far) {
    return count_triangles(frustum, geometry, near, far, 1) > 0;
}

static float end_of(const struct camera *camera) {
    return camera->far > 0 ? camera->far : INFINITY;
}

struct camera_range camera_range_of(const struct camera *camera, const struct geometry *geometry,
                                    float aspect) {
    struct camera_range range = {.near = camera->near, .far = end_of(camera)};
    struct frustum frustum = frustum_of(camera, aspect);
    if (camera_is_wide(camera)) {
        range.cuts = range.near > 0 || isfinite(range.far);
        return range;
    }
    range.cuts = holds_something(frustum, geometry, 0, range.near) ||
                 holds_something(frustum, geometry, range.far, INFINITY);
    return range;
}

/* Whether the camera sees a part of the scene, and would without its range. */
static bool is_blind(const struct camera *camera, const struct geometry *geometry) {
    struct frustum frustum = frustum_of(camera, 1);
    return (camera->near > 0 || camera->far > 0) &&
           !holds_something(frustum, geometry, camera->near, end_of(camera)) &&
           holds_something(frustum, geometry, 0, INFINITY);
}

/* Exporters write a zfar of 100 m where there was none. */
static void note_beyond(const struct scene *scene, int n, const struct camera *camera,
                        const struct geometry *geometry) {
    struct frustum frustum = frustum_of(camera, 1);
    if (camera->far <= 0)
        return;
    size_t beyond = count_triangles(frustum, geometry, camera->far, INFINITY, SIZE_MAX);
    if (beyond > 0)
        log_note("%s: camera %d: %zu of %zu triangles in its view reach beyond its zfar of %g m, "
                 "where it sees nothing (--camera \"%d far=0\" sees all)",
                 scene->path, n, beyond, count_triangles(frustum, geometry, 0, INFINITY, SIZE_MAX),
                 (double)camera->far, n);
}

void scene_check_ranges(struct scene *scene, const struct geometry *geometry) {
    const int most = 32; /* each is looked for among all nodes */
    int count = camera_node_count(scene);
    for (int n = 0; n < count && n < most; n++) {
        int node = node_carrying(scene, NODE_CAMERA, n);
        struct scene_camera *source = &scene->cameras[scene->nodes[node].camera];
        struct camera camera;
        camera_place(&camera, scene, n, 0);
        if (!is_blind(&camera, geometry)) {
            note_beyond(scene, n, &camera, geometry);
            continue;
        }
        log_note(
            "%s: camera %d: nothing of the scene lies between its znear of %g m and its zfar, so "
            "it sees all",
            scene->path, n, (double)camera.near);
        source->near = source->far = 0;
    }
}
