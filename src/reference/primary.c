#include "reference/primary.h"

#include "reference/vector.h"

bool primary_hit(const struct primary_rays *primary, float x, float y, struct hit *hit) {
    float width = (float)primary->width, height = (float)primary->height, origin[3], direction[3];
    camera_ray(primary->camera, x / width, y / height, width / height, origin, direction);
    return ray_scene_camera_hit(primary->rays, vector_of(origin), vector_of(direction), hit);
}

float primary_depth(const struct primary_rays *primary, const struct hit *hit) {
    return glms_vec3_dot(glms_vec3_sub(hit->position, vector_of(primary->camera->eye)),
                         vector_of(primary->camera->forward));
}
