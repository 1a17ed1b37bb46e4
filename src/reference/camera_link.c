#include "reference/camera_link.h"

#include "reference/vector.h"

#include <math.h>

struct camera_link camera_link_of(const struct primary_rays *primary, float radius) {
    bool cuts = primary->range.cuts;
    float right2 = camera_axis_norm2(primary->camera->right);
    float up2 = camera_axis_norm2(primary->camera->up);
    return (struct camera_link){.primary = *primary,
                                .across = primary_pixel_size(primary, 1),
                                .aspect = sqrtf(right2 / up2),
                                .least = 1e-6F * radius,
                                .near = cuts ? primary->range.near : 0,
                                .far = cuts ? primary->range.far : INFINITY};
}

bool camera_link_view(const struct camera_link *link, vec3s point, struct camera_view *view) {
    const struct primary_rays *primary = &link->primary;
    const struct camera *camera = primary->camera;
    float width = (float)primary->width, height = (float)primary->height, place[2];
    float depth = primary_depth(primary, point),
          of_pixel = link->across * link->across * link->aspect;
    if (depth < link->least || !camera_project(camera, point.raw, width / height, place))
        return false;
    float x = floorf(place[0] * width), y = floorf(place[1] * height);
    if (!(x >= 0 && x < width && y >= 0 && y < height))
        return false;
    view->in_range = depth >= link->near && depth <= link->far;
    view->pixel = (size_t)y * (size_t)primary->width + (size_t)x;
    vec3s eye = vector_of(camera->eye), forward = vector_of(camera->forward);
    if (camera->orthographic) {
        view->eye = glms_vec3_muladds(forward, -depth, point);
        view->to_eye = glms_vec3_negate(forward);
        view->distance = depth;
        view->weight = 1 / of_pixel;
    } else {
        vec3s path = glms_vec3_sub(eye, point);
        view->eye = eye;
        view->distance = glms_vec3_norm(path);
        view->to_eye = glms_vec3_scale(path, 1 / view->distance);
        /* 1 / (distance^2 times the pixel's solid angle, of_pixel cos^3) */
        view->weight = view->distance / (of_pixel * depth * depth * depth);
    }
    return isfinite(view->weight);
}

vec3s camera_link_sees(const struct camera_link *link, const struct camera_view *view,
                       vec3s point) {
    const struct ray_scene *rays = link->primary.rays;
    vec3s path = glms_vec3_sub(point, view->eye);
    float distance = glms_vec3_norm(path);
    float of_depth = distance / primary_depth(&link->primary, point);
    float ends[2] = {of_depth * link->near,
                     fminf(distance - rays->clearance, of_depth * link->far)};
    return ends[1] <= ends[0] ? glms_vec3_one()
                              : ray_scene_camera_is_open(rays, view->eye,
                                                         glms_vec3_scale(path, 1 / distance), ends);
}

/* What lies where a linear function of the place along the ray is positive. */
static void cut(float at_origin, float slope, float piece[2]) {
    float root = -at_origin / slope;
    if (slope > 0)
        piece[0] = fmaxf(piece[0], root);
    else if (slope < 0)
        piece[1] = fminf(piece[1], root);
    else if (at_origin <= 0)
        piece[1] = piece[0];
}

bool camera_link_cut(const struct camera_link *link, vec3s origin, vec3s direction,
                     float piece[2]) {
    const struct primary_rays *primary = &link->primary;
    const struct camera *camera = primary->camera;
    vec3s axes[2] = {vector_of(camera->right), vector_of(camera->up)};
    vec3s from_eye = glms_vec3_sub(origin, vector_of(camera->eye));
    float pixels[2] = {(float)primary->width, (float)primary->height};
    float depth = primary_depth(primary, origin);
    float sinks = glms_vec3_dot(direction, vector_of(camera->forward));
    cut(depth - link->least, sinks, piece);
    for (int axis = 0; axis < 2; axis++) {
        float length = sqrtf(camera_axis_norm2(axes[axis].raw)), shift = camera->shift[axis];
        float half = link->across * pixels[axis] / 2 * (axis == 0 ? link->aspect : 1);
        float edge = camera->orthographic ? half : half * depth;
        float opens = camera->orthographic ? 0 : half * sinks;
        float aside = glms_vec3_dot(from_eye, axes[axis]) / length;
        float goes = glms_vec3_dot(direction, axes[axis]) / length;
        cut((1 + shift) * edge - aside, (1 + shift) * opens - goes, piece);
        cut((1 - shift) * edge + aside, (1 - shift) * opens + goes, piece);
    }
    return piece[0] < piece[1];
}
