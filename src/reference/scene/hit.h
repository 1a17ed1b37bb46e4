/* The surface where a ray meets the scene: its place, its two normals, its albedo, and what it emits.
 *
 * Every surface is Lambertian. The shading normal is the vertices' interpolated one; the geometric
 * normal is the triangle's own. A material's double_sided decides what its back is: reflecting like
 * the front, or black (it still blocks light).
 */
#ifndef REFERENCE_SCENE_HIT_H
#define REFERENCE_SCENE_HIT_H

#include "scene/mesh/geometry.h"

#include <cglm/struct.h>

/* A point of a triangle: position = (1 - u - v) p0 + u p1 + v p2. */
struct triangle_point {
    uint32_t triangle; /* its indices start at 3 x triangle */
    float u, v;
};

struct hit {
    vec3s position;
    vec3s geometric_normal; /* unit, on the side that the ray came from */
    vec3s normal;           /* shading normal, unit, turned with the geometric one */
    vec3s albedo;           /* zero on the back of a single-sided material */
    vec3s emission;         /* radiance; the same */
    uint32_t triangle;
    bool is_back; /* of it */
};

/* The triangles of a geometry with their materials. Keeps references to scene and geometry. Not
 * changed after init, hence safe to read from several threads. */
struct hit_table {
    const struct scene *scene;
    const struct geometry *geometry;
    int *material_of; /* of each triangle */
    vec3s *normal_of; /* the same: geometric, unit, by the winding; zero where there is no area */
    float srgb_to_linear[256];
};

void hit_table_init(struct hit_table *table, const struct scene *scene,
                    const struct geometry *geometry);

/* Accepts zeroed tables. */
void hit_table_free(struct hit_table *table);

/* The surface as a ray of that direction meets it. */
void hit_at(const struct hit_table *table, const struct triangle_point *point, vec3s ray_direction,
            struct hit *hit);

/* Where it is; and what its material emits there, on the front, zero in holes. */
vec3s hit_position(const struct hit_table *table, const struct triangle_point *point);
vec3s hit_emission(const struct hit_table *table, const struct triangle_point *point);

/* Whether the alpha mask has a hole at the point. */
bool hit_is_hole(const struct hit_table *table, const struct triangle_point *point);

/* Whether a ray of that direction meets the back of a single-sided triangle. */
bool hit_is_hidden(const struct hit_table *table, uint32_t triangle, vec3s ray_direction);

#endif
