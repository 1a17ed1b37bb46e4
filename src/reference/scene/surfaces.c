#include "reference/scene/surfaces.h"

#include "reference/vector.h"

#include "base/halton.h"
#include "base/memory.h"
#include "scene/lights/emissive.h"
#include "scene/mesh/corners.h"
#include "shared/light_tree.h"

#include <math.h>

/* Where a textured triangle is looked at to say how bright it is; and at least so much of what it
 * could be is taken, for there may be light between. */
enum { PLACES = 16 };
static const float least_share = .05F;

/* --- how bright they are ---------------------------------------------------------------------- */

/* A point in the triangle, even in its area. */
static struct triangle_point point_in(uint32_t triangle, float across, float along) {
    float x = sqrtf(across);
    return (struct triangle_point){triangle, x * (1 - along), x * along};
}

static float brightness(vec3s radiance) {
    return radiance.x + radiance.y + radiance.z;
}

static double mean_radiance(const struct hit_table *table, uint32_t triangle) {
    const struct material *material = hit_material(table, triangle);
    double full = (double)brightness(vector_of(material->emission)), sum = 0;
    if (material->emission_texture < 0 && !material->alpha_mask)
        return full;
    for (uint32_t i = 0; i < PLACES; i++) {
        struct triangle_point point =
            point_in(triangle, ((float)i + .5F) / PLACES, (float)radical_inverse(2, i));
        sum += (double)brightness(hit_emission(table, &point));
    }
    return fmax(sum / PLACES, (double)least_share * full);
}

static double area_of(const struct hit_table *table, uint32_t triangle) {
    return corners_area(table->geometry, &table->geometry->indices[3 * (size_t)triangle]);
}

/* --- the list --------------------------------------------------------------------------------- */

static void add_triangle(struct surfaces *surfaces, uint32_t triangle, double *powers) {
    const struct hit_table *table = surfaces->table;
    const struct material *material = hit_material(table, triangle);
    double area = area_of(table, triangle), power = area * mean_radiance(table, triangle);
    if (!(power > 0))
        return;
    surfaces->first[triangle] = surfaces->count;
    for (int side = 0; side < (material->double_sided ? 2 : 1); side++) {
        powers[surfaces->count] = power;
        surfaces->list[surfaces->count++] =
            (struct surface_triangle){triangle, side == 1, (float)(power / area)};
    }
}

static void add_surface(struct surfaces *surfaces, struct emissive_span span, bool listed,
                        double *powers) {
    for (uint32_t i = span.first; i < span.end; i++) {
        surfaces->shines[i] = true;
        if (listed)
            add_triangle(surfaces, i, powers);
    }
}

/* Densities are powers over areas so far. */
static void finish_list(struct surfaces *surfaces, const double *powers) {
    double sum = 0;
    for (int i = 0; i < surfaces->count; i++)
        sum += powers[i];
    for (int i = 0; i < surfaces->count; i++)
        surfaces->list[i].density = (float)((double)surfaces->list[i].density / sum);
    if (surfaces->count > 0)
        alias_init(&surfaces->alias, powers, surfaces->count);
    surfaces->flux = sum / 3;
}

/* Powers are relative. */
static void build_tree(struct surfaces *surfaces) {
    const struct geometry *geometry = surfaces->table->geometry;
    struct light_bounds *bounds = mem_alloc((size_t)surfaces->count, sizeof *bounds);
    for (int i = 0; i < surfaces->count; i++) {
        const struct surface_triangle *item = &surfaces->list[i];
        float power = item->density;
        struct light_triangle triangle = {.red = power, .green = power, .blue = power};
        vec3s edges[2],
            corner = corners_edges(geometry, &geometry->indices[3 * (size_t)item->triangle], edges);
        glm_vec3_copy(corner.raw, triangle.corner);
        glm_vec3_copy(edges[item->back].raw, triangle.edge_1);
        glm_vec3_copy(edges[!item->back].raw, triangle.edge_2);
        bounds[i] = light_bounds_of_triangle(&triangle);
    }
    light_tree_init(&surfaces->tree, bounds, surfaces->count);
    free(bounds);
}

void surfaces_init(struct surfaces *surfaces, const struct hit_table *table,
                   const struct emitters *emitters) {
    const struct scene *scene = table->scene;
    size_t triangles = table->geometry->index_count / 3;
    *surfaces = (struct surfaces){.table = table};
    if (scene->surface_count == 0)
        return;
    double *powers = mem_alloc(2 * triangles, sizeof *powers);
    surfaces->shines = mem_alloc(triangles, sizeof *surfaces->shines);
    surfaces->first = mem_alloc(triangles, sizeof *surfaces->first);
    surfaces->list = mem_alloc(2 * triangles, sizeof *surfaces->list);
    for (size_t i = 0; i < triangles; i++)
        surfaces->first[i] = -1;
    enum lamp_state *lamps = emissive_lamp_states(scene, emitters);
    struct emissive_span *spans = emissive_find_all(table->geometry, scene);
    for (int i = 0; i < scene->surface_count; i++) {
        enum lamp_state lamp = lamps[scene->surfaces[i].lamp];
        if (lamp != LAMP_IS_DARK)
            add_surface(surfaces, spans[i], lamp == LAMP_STOOD_IN_FOR, powers);
    }
    finish_list(surfaces, powers);
    if (surfaces->count > SURFACES_BY_POWER_MAX)
        build_tree(surfaces);
    mem_free(powers, lamps, spans);
}

void surfaces_free(struct surfaces *surfaces) {
    mem_free(surfaces->shines, surfaces->first, surfaces->list);
    alias_free(&surfaces->alias);
    light_tree_free(&surfaces->tree);
    *surfaces = (struct surfaces){0};
}

/* --- light ------------------------------------------------------------------------------------ */

static struct emitter piece_of(const struct surfaces *surfaces, int n, float across, float along,
                               double density) {
    const struct surface_triangle *picked = &surfaces->list[n];
    struct triangle_point point = point_in(picked->triangle, across, along);
    struct emitter piece = {.type = EMITTER_AREA};
    vec3s normal = hit_winding_normal(surfaces->table, picked->triangle);
    vec3s position = hit_position(surfaces->table, &point);
    vec3s radiance = hit_emission(surfaces->table, &point);
    glm_vec3_scale(normal.raw, picked->back ? -1 : 1, piece.direction);
    glm_vec3_copy(position.raw, piece.position);
    glm_vec3_divs(radiance.raw, (float)density, piece.intensity);
    return piece;
}

struct emitter surfaces_piece(const struct surfaces *surfaces, const float place[2],
                              double *density) {
    float across = place[0];
    int n = (int)alias_pick(&surfaces->alias, &across);
    *density = (double)surfaces->list[n].density;
    return piece_of(surfaces, n, across, place[1], *density);
}

static double density_by_tree(const struct surfaces *surfaces, const struct hit *from, int n) {
    float probability =
        light_tree_probability(&surfaces->tree, from->position.raw, from->normal.raw, n);
    return (double)probability / area_of(surfaces->table, surfaces->list[n].triangle);
}

bool surfaces_piece_near(const struct surfaces *surfaces, const struct hit *from, vec3s place,
                         struct emitter *piece, double densities[2]) {
    float probability;
    int n = light_tree_sample(&surfaces->tree, from->position.raw, from->normal.raw, place.x,
                              &probability);
    if (n < 0)
        return false;
    densities[0] = (double)probability / area_of(surfaces->table, surfaces->list[n].triangle);
    densities[1] = (double)surfaces->list[n].density;
    *piece = piece_of(surfaces, n, place.y, place.z, densities[0]);
    return true;
}

float surfaces_chosen(const struct surfaces *surfaces, const struct hit *from,
                      const float place[2]) {
    float across = place[0];
    if (surfaces->tree.node_count == 0)
        return 1;
    int n = (int)alias_pick(&surfaces->alias, &across);
    return (float)(density_by_tree(surfaces, from, n) / (double)surfaces->list[n].density);
}

bool surfaces_densities(const struct surfaces *surfaces, const struct hit *from,
                        const struct hit *hit, double densities[2]) {
    int first = surfaces->first ? surfaces->first[hit->triangle] : -1;
    const struct hit_table *table = surfaces->table;
    if (first < 0)
        return false;
    bool is_double = hit_material(table, hit->triangle)->double_sided;
    if (hit->is_back && !is_double)
        return false;
    int n = first + (hit->is_back ? 1 : 0);
    densities[0] = densities[1] = (double)surfaces->list[n].density;
    if (surfaces->tree.node_count > 0)
        densities[0] = density_by_tree(surfaces, from, n);
    return true;
}

vec3s surfaces_glow(const struct surfaces *surfaces, const struct hit *hit) {
    return surfaces->shines && surfaces->shines[hit->triangle] ? hit->emission : glms_vec3_zero();
}
