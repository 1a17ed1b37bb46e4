#include "reference/primary.h"

#include "reference/vector.h"

#include <math.h>

struct primary_rays primary_rays_of(const struct ray_scene *rays, const struct camera *camera,
                                    const struct geometry *geometry, int width, int height) {
    return (struct primary_rays){rays,
                                 camera,
                                 width,
                                 height,
                                 camera_range_of(camera, geometry, (float)width / (float)height),
                                 NULL};
}

/* From a metre in front of a sensor. */
static void sensor_ray(const struct sensor *sensor, vec3s *origin, vec3s *direction) {
    vec3s normal = vector_of(sensor->normal);
    *origin = glms_vec3_add(vector_of(sensor->position), normal);
    *direction = glms_vec3_negate(normal);
}

static struct hit sensor_hit(const struct sensor *sensor) {
    vec3s normal = vector_of(sensor->normal);
    return (struct hit){.position = vector_of(sensor->position),
                        .geometric_normal = normal,
                        .normal = normal,
                        .towards = normal,
                        .brdf = brdf_lambertian(glms_vec3_one()),
                        .share = glms_vec3_one()};
}

void primary_ray(const struct primary_rays *primary, float x, float y, vec3s *origin,
                 vec3s *direction) {
    if (primary->sensors) {
        sensor_ray(&primary->sensors[(int)y], origin, direction);
        return;
    }
    float width = (float)primary->width, height = (float)primary->height;
    camera_ray(primary->camera, x / width, y / height, width / height, origin->raw, direction->raw);
}

bool primary_hit(const struct primary_rays *primary, float x, float y, uint32_t seed,
                 struct hit *hit) {
    vec3s origin, direction;
    float from = 0, to = INFINITY;
    if (primary->sensors) {
        *hit = sensor_hit(&primary->sensors[(int)y]);
        return true;
    }
    primary_ray(primary, x, y, &origin, &direction);
    if (primary->range.cuts) {
        float depth = glms_vec3_dot(direction, vector_of(primary->camera->forward));
        from = primary->range.near / depth;
        to = primary->range.far / depth;
    }
    return ray_scene_camera_hit(primary->rays, origin, direction, (float[]){from, to}, seed, hit);
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
