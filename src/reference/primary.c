#include "reference/primary.h"

#include "reference/vector.h"

#include <math.h>

bool primary_hit(const struct primary_rays *primary, float x, float y, struct hit *hit) {
    float width = (float)primary->width, height = (float)primary->height, origin[3], direction[3];
    camera_ray(primary->camera, x / width, y / height, width / height, origin, direction);
    return ray_scene_camera_hit(primary->rays, vector_of(origin), vector_of(direction), hit);
}

float primary_depth(const struct primary_rays *primary, vec3s position) {
    return glms_vec3_dot(glms_vec3_sub(position, vector_of(primary->camera->eye)),
                         vector_of(primary->camera->forward));
}

float primary_pixel_size(const struct primary_rays *primary, float depth) {
    const struct camera *camera = primary->camera;
    float half = camera->orthographic ? camera->y_extent : tanf(camera->fov_y / 2) * depth;
    return 2 * half / (float)primary->height;
}
