/* The surface where a ray meets the scene: its place, its two normals, how it reflects, and what it emits.
 *
 * The shading normal is the vertices' interpolated one, turned by a normal map; the geometric normal is
 * the triangle's own. A material's double_sided decides what its back is: reflecting like the front, or
 * black (it still blocks light). So is what is unlit: the eye alone sees it.
 */
#ifndef REFERENCE_SCENE_HIT_H
#define REFERENCE_SCENE_HIT_H

#include "base/unit.h"
#include "reference/brdf.h"
#include "scene/mesh/geometry.h"

/* A point of a triangle: position = (1 - u - v) p0 + u p1 + v p2. */
struct triangle_point {
    uint32_t triangle; /* its indices start at 3 x triangle */
    float u, v;
};

struct hit {
    vec3s position;
    vec3s geometric_normal; /* unit, on the side that the ray came from */
    vec3s normal;           /* shading normal, unit, turned with the geometric one */
    vec3s towards;          /* unit: where the ray came from */
    struct brdf brdf;       /* black on the back of a single-sided material */
    vec3s emission;         /* radiance; the same */
    vec3s unlit;            /* radiance that the eye sees, and nothing else; the same */
    /* Glass or a mirror, which is black then, where the table tells these apart (hit_table_find_smooth); else NULL. */
    const struct material *smooth;
    vec3s tint; /* of those: the base colour */
    vec3s
        share; /* of what it sends along the ray: by panes on the way, over the chance to meet it */
    uint32_t triangle;
    bool is_back; /* of it */
};

/* The triangles of a geometry with their materials. Keeps references to scene and geometry. Not
 * changed after init, hence safe to read from several threads. */
struct hit_table {
    const struct scene *scene;
    const struct geometry *geometry;
    enum materials materials;
    bool has_specular; /* some surface is not Lambertian */
    bool has_smooth;   /* some surface is glass or a mirror, which hits tell */
    int *material_of;  /* of each triangle */
    vec3s *normal_of;  /* the same: geometric, unit, by the winding; zero where there is no area */
    float srgb_to_linear[256];
};

void hit_table_init(struct hit_table *table, const struct scene *scene,
                    const struct geometry *geometry, enum materials materials);

/* Lets hits tell glass and mirrors (material_smooth_kind), on all sides but the black back of a mirror: the camera sees
 * both sides of glass. False where the scene has neither, or all surfaces are Lambertian. */
bool hit_table_find_smooth(struct hit_table *table);

/* Accepts zeroed tables. */
void hit_table_free(struct hit_table *table);

/* The surface as a ray of that direction meets it. */
void hit_at(const struct hit_table *table, const struct triangle_point *point, vec3s ray_direction,
            struct hit *hit);

/* What leaves a surface by reflection: by its diffuse part, over the albedo, and by its specular part. */
struct reflected {
    vec3s diffuse, specular;
};

static inline struct reflected reflected_scale(const struct reflected *light, vec3s share) {
    return (struct reflected){glms_vec3_mul(light->diffuse, share),
                              glms_vec3_mul(light->specular, share)};
}

/* All of it, radiance. */
static inline vec3s hit_radiance(const struct hit *hit, const struct reflected *light) {
    vec3s diffuse = glms_vec3_mul(hit->brdf.albedo, light->diffuse);
    return hit->brdf.diffuse ? diffuse : glms_vec3_add(diffuse, light->specular);
}

/* Whether light has nothing to gain from it. */
static inline bool hit_is_black(const struct hit *hit) {
    return hit->brdf.diffuse && glms_vec3_norm2(hit->brdf.albedo) == 0;
}

/* The density, 1/sr, with which rays that are sampled by its reflection leave in a unit direction; cosine:
 * the direction's, above 0. */
static inline float hit_density(const struct hit *hit, vec3s direction, float cosine) {
    return hit->brdf.diffuse ? cosine * GLM_1_PIf
                             : brdf_density(&hit->brdf, hit->normal, hit->towards, direction);
}

/* Where it is; and what its material emits there, on the front, zero in holes. */
vec3s hit_position(const struct hit_table *table, const struct triangle_point *point);
vec3s hit_emission(const struct hit_table *table, const struct triangle_point *point);

/* Whether the alpha mask has a hole at the point. */
bool hit_is_hole(const struct hit_table *table, const struct triangle_point *point);

/* Whether the triangle lets light pass straight on; and how much of it, at the point. */
bool hit_is_pane(const struct hit_table *table, uint32_t triangle);
struct passing hit_passing(const struct hit_table *table, const struct triangle_point *point,
                           vec3s ray_direction);

/* Whether a ray of that direction meets the back of a single-sided triangle. */
bool hit_is_hidden(const struct hit_table *table, uint32_t triangle, vec3s ray_direction);

#endif
