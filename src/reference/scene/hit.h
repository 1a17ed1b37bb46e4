/* The surface at a ray's hit point: position, two normals, reflection and emission.
 *
 * The shading normal is interpolated from the vertices and bent by a normal map; the geometric
 * normal is the triangle's. With double_sided the back reflects like the front; else it is black,
 * but blocks light. Unlit materials are black too, and only the camera sees their radiance. */
#ifndef REFERENCE_SCENE_HIT_H
#define REFERENCE_SCENE_HIT_H

#include "base/unit.h"
#include "reference/brdf.h"
#include "scene/mesh/geometry.h"

/* A point of a triangle: position = (1 - u - v) p0 + u p1 + v p2. */
struct triangle_point {
    uint32_t triangle; /* its first index is 3 x triangle */
    float u, v;
};

struct hit {
    vec3s position;
    vec3s geometric_normal; /* unit, on the side of the ray's origin */
    vec3s normal;           /* unit shading normal, on this side too */
    vec3s towards;          /* unit, towards the ray's origin */
    struct brdf brdf;       /* black on the back of a single-sided material */
    vec3s emission;         /* radiance; 0 on the back of a single-sided material */
    vec3s unlit; /* radiance for the camera alone; 0 on the back of a single-sided material */
    /* Glass or mirror, whose brdf is black, after hit_table_find_smooth; else NULL. */
    const struct material *smooth;
    vec3s tint; /* base colour of glass or mirror */
    /* Factor of light sent along the ray: transmittance of panes on the way, over the probability
     * of the hit. */
    vec3s share;
    uint32_t triangle;
    bool is_back; /* the back of the triangle */
};

/* Triangles of a geometry with their materials. It refers to scene and geometry. It is constant
 * after init, so threads can share it. */
struct hit_table {
    const struct scene *scene;
    const struct geometry *geometry;
    enum materials materials;
    bool has_specular; /* some surface is not Lambertian */
    bool has_smooth;   /* some surface is glass or a mirror, and hits report it */
    float srgb_to_linear[256];
};

void hit_table_init(struct hit_table *table, const struct scene *scene,
                    const struct geometry *geometry, enum materials materials);

/* Lets hits report glass and mirrors (material_smooth_kind), except the black back of a mirror.
 * Both sides of glass are visible. False: the scene has neither, or all surfaces are Lambertian. */
bool hit_table_find_smooth(struct hit_table *table);

const struct material *hit_material(const struct hit_table *table, uint32_t triangle);

/* Returns the geometric normal, unit, by the winding; zero without area. */
vec3s hit_winding_normal(const struct hit_table *table, uint32_t triangle);

/* Computes the surface for a ray in `ray_direction`. */
void hit_at(const struct hit_table *table, const struct triangle_point *point, vec3s ray_direction,
            struct hit *hit);

/* Reflected light: of the diffuse part, over the albedo; of the specular part. */
struct reflected {
    vec3s diffuse, specular;
};

static inline struct reflected reflected_scale(const struct reflected *light, vec3s share) {
    return (struct reflected){glms_vec3_mul(light->diffuse, share),
                              glms_vec3_mul(light->specular, share)};
}

/* Returns the sum of both, radiance. */
static inline vec3s hit_radiance(const struct hit *hit, const struct reflected *light) {
    vec3s diffuse = glms_vec3_mul(hit->brdf.albedo, light->diffuse);
    return hit->brdf.diffuse ? diffuse : glms_vec3_add(diffuse, light->specular);
}

/* True if the surface reflects no light. */
static inline bool hit_is_black(const struct hit *hit) {
    return hit->brdf.diffuse && glms_vec3_norm2(hit->brdf.albedo) == 0;
}

/* Returns the density of rays sampled by the reflection in a unit direction, 1/sr. cosine: of the
 * direction, above 0. */
static inline float hit_density(const struct hit *hit, vec3s direction, float cosine) {
    return hit->brdf.diffuse ? cosine * GLM_1_PIf
                             : brdf_density(&hit->brdf, hit->normal, hit->towards, direction);
}

/* Return the position; the emission of the front, zero in holes, W/(sr m2). */
vec3s hit_position(const struct hit_table *table, const struct triangle_point *point);
vec3s hit_emission(const struct hit_table *table, const struct triangle_point *point);

/* True if the alpha mask has a hole at the point. */
bool hit_is_hole(const struct hit_table *table, const struct triangle_point *point);

/* True if the triangle is a pane; the transmittance and coverage of a pane at the point. */
bool hit_is_pane(const struct hit_table *table, uint32_t triangle);
struct passing hit_passing(const struct hit_table *table, const struct triangle_point *point,
                           vec3s ray_direction);

/* True if a ray in this direction meets the back of a single-sided triangle. */
bool hit_is_hidden(const struct hit_table *table, uint32_t triangle, vec3s ray_direction);

#endif
