#include "reference/primary.h"

#include "base/memory.h"
#include "reference/rows.h"
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

/* Writes the range of distances that the camera sees along a ray. */
static void set_ends(const struct primary_rays *primary, vec3s direction, float ends[2]) {
    float depth = camera_is_wide(primary->camera)
                      ? 1
                      : glms_vec3_dot(direction, vector_of(primary->camera->forward));
    ends[0] = primary->range.cuts ? primary->range.near / depth : 0;
    ends[1] = primary->range.cuts ? primary->range.far / depth : INFINITY;
}

bool primary_hit(const struct primary_rays *primary, float x, float y, uint32_t seed,
                 struct hit *hit) {
    vec3s origin, direction;
    float ends[2];
    if (primary->sensors) {
        *hit = sensor_hit(&primary->sensors[(int)y]);
        return true;
    }
    primary_ray(primary, x, y, &origin, &direction);
    set_ends(primary, direction, ends);
    return ray_scene_camera_hit(primary->rays, origin, direction, ends, seed, hit);
}

static uint32_t triangle_at(const struct primary_rays *primary, float x, float y) {
    const struct ray_scene *rays = primary->rays;
    vec3s origin, direction;
    struct hit hit;
    float ends[2];
    primary_ray(primary, x, y, &origin, &direction);
    set_ends(primary, direction, ends);
    while (ray_scene_camera_hit(rays, origin, direction, ends, 0, &hit)) {
        if (!hit_is_pane(rays->table, hit.triangle))
            return hit.triangle + 1;
        ends[0] = glms_vec3_distance(origin, hit.position) + rays->clearance;
    }
    return 0;
}

/* One place in all pixels. */
struct looking {
    const struct primary_rays *primary;
    const float *place;
    uint32_t *triangles;
};

static void look_along(void *context, int row) {
    const struct looking *looking = context;
    uint32_t *triangles = looking->triangles + (size_t)row * (size_t)looking->primary->width;
    for (int x = 0; x < looking->primary->width; x++)
        triangles[x] = triangle_at(looking->primary, (float)x + looking->place[0],
                                   (float)row + looking->place[1]);
}

uint32_t *primary_triangles(const struct primary_rays *primary, const float place[2], int threads) {
    size_t pixels = (size_t)primary->width * (size_t)primary->height;
    struct looking looking = {primary, place, mem_alloc(pixels, sizeof(uint32_t))};
    rows_render(&(struct rows){primary->height, threads, look_along, NULL, &looking});
    return looking.triangles;
}

float primary_depth(const struct primary_rays *primary, vec3s position) {
    vec3s from_eye = glms_vec3_sub(position, vector_of(primary->camera->eye));
    return camera_is_wide(primary->camera)
               ? glms_vec3_norm(from_eye)
               : glms_vec3_dot(from_eye, vector_of(primary->camera->forward));
}

float primary_pixel_size(const struct primary_rays *primary, float depth) {
    const struct camera *camera = primary->camera;
    if (camera_is_wide(camera))
        return GLM_PIf * depth / (float)primary->height;
    float half = camera->orthographic ? camera->y_extent : tanf(camera->fov_y / 2) * depth;
    return 2 * half * sqrtf(camera_axis_norm2(camera->up)) / (float)primary->height;
}
