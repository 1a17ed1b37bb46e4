#include "reference/view.h"

#include "reference/vector.h"

bool view_hit(const struct view *view, float x, float y, struct hit *hit) {
    float width = (float)view->width, height = (float)view->height, origin[3], direction[3];
    camera_ray(view->camera, x / width, y / height, width / height, origin, direction);
    return ray_scene_camera_hit(view->rays, vector_of(origin), vector_of(direction), hit);
}

float view_depth(const struct view *view, const struct hit *hit) {
    return glms_vec3_dot(glms_vec3_sub(hit->position, vector_of(view->camera->eye)),
                         vector_of(view->camera->forward));
}
