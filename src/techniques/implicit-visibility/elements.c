#include "techniques/implicit-visibility/elements.h"

#include "base/memory.h"
#include "scene/mesh/corners.h"

#include <math.h>
#include <string.h>

/* Side of a cell over the longest edge: cut triangles keep their vertices apart. */
static const float cell_fraction = .35F;

/* Area of a pane's element over its surface's: no partner of others. */
static const float pane_area = 1e-9F;

/* Attempts to find the grid with so many cells; each makes it coarser. */
enum { ATTEMPTS = 40 };

/* Parts of a triangle that wait to be cut. */
enum { STACK_MAX = 96 };

/* What a corner of a cut triangle adds: a third of its area. Weights of the geometry's corners. */
struct third {
    const uint32_t *corners;
    float at[3];    /* the vertex */
    float inner[3]; /* the middle of the third */
    float side, area;
    vec3s albedo, emission;
};

struct cluster {
    uint64_t key;
    double area, place[3], albedo[3], emission[3];
    float distance2; /* of the element from the mean place */
    struct element element;
};

struct maker {
    const struct elements_desc *desc;
    float edge, cell; /* longest edge; side of a cell, m */
    uint32_t *slots;  /* hash table of clusters: index + 1; 0 = empty */
    uint32_t slot_count;
    struct cluster *clusters;
    uint32_t count, room;
    bool colored; /* thirds have an albedo */
    bool pane;    /* as they are */
    struct surface_colors colors;
};

typedef void visit_third(struct maker *maker, const struct third *third);

/* --- clusters --------------------------------------------------------------------------------- */

static struct corners corners_of(const uint32_t *index, const float *weight) {
    struct corners corners;
    memcpy(corners.index, index, sizeof corners.index);
    memcpy(corners.weight, weight, sizeof corners.weight);
    return corners;
}

static vec3s place_of(const struct maker *maker, const uint32_t *index, const float *weight) {
    struct corners corners = corners_of(index, weight);
    return corners_vector(&corners, maker->desc->geometry->position);
}

/* Along the greatest component, where near ties go one way. */
static uint64_t facing(vec3s normal) {
    float x = fabsf(normal.x) * 1.01F, y = fabsf(normal.y), z = fabsf(normal.z) * .99F;
    int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    return (uint64_t)(2 * axis + (normal.raw[axis] < 0));
}

/* Planes of a scene lie at its bounds: no cell ends there. */
static uint64_t key_of(const struct maker *maker, const struct third *third) {
    const struct geometry *geometry = maker->desc->geometry;
    struct corners corners = corners_of(third->corners, third->at);
    vec3s place = corners_vector(&corners, geometry->position);
    vec3s normal = glms_vec3_scale(corners_vector(&corners, geometry->normal), third->side);
    uint64_t key = 1 + facing(normal) + (maker->pane ? 8 : 0);
    for (int c = 0; c < 3; c++) {
        double cells = (double)(place.raw[c] - geometry->bounds_min[c]) / (double)maker->cell + .37;
        key = key << 20 | (uint64_t)fmin(fmax(cells, 0), (1 << 20) - 1);
    }
    return key;
}

static uint32_t slot_of(const struct maker *maker, uint64_t key) {
    uint64_t hash = key * 0x9E3779B97F4A7C15U;
    uint32_t slot = (uint32_t)(hash >> 32) & (maker->slot_count - 1);
    while (maker->slots[slot] && maker->clusters[maker->slots[slot] - 1].key != key)
        slot = (slot + 1) & (maker->slot_count - 1);
    return slot;
}

static void grow_slots(struct maker *maker) {
    free(maker->slots);
    maker->slot_count *= 2;
    maker->slots = mem_alloc(maker->slot_count, sizeof *maker->slots);
    for (uint32_t i = 0; i < maker->count; i++)
        maker->slots[slot_of(maker, maker->clusters[i].key)] = i + 1;
}

static struct cluster *cluster_of(struct maker *maker, const struct third *third) {
    uint64_t key = key_of(maker, third);
    uint32_t slot = slot_of(maker, key);
    if (maker->slots[slot])
        return &maker->clusters[maker->slots[slot] - 1];
    if (maker->count == maker->room) {
        maker->room = 2 * maker->room + 64;
        maker->clusters = mem_resize(maker->clusters, maker->room, sizeof *maker->clusters);
    }
    struct cluster *cluster = &maker->clusters[maker->count++];
    *cluster = (struct cluster){.key = key, .distance2 = INFINITY};
    maker->slots[slot] = maker->count;
    if (2 * maker->count > maker->slot_count)
        grow_slots(maker);
    return cluster;
}

static void add_third(struct maker *maker, const struct third *third) {
    struct cluster *cluster = cluster_of(maker, third);
    vec3s place = place_of(maker, third->corners, third->inner);
    cluster->area += (double)third->area;
    for (int c = 0; c < 3; c++) {
        cluster->place[c] += (double)(third->area * place.raw[c]);
        cluster->albedo[c] += (double)(third->area * third->albedo.raw[c]);
        cluster->emission[c] += (double)(third->area * third->emission.raw[c]);
    }
}

static void consider(const struct maker *maker, struct cluster *cluster, const struct third *third,
                     const float *weights) {
    vec3s place = place_of(maker, third->corners, weights);
    float distance2 = 0;
    for (int c = 0; c < 3; c++) {
        double from = (double)place.raw[c] - cluster->place[c] / cluster->area;
        distance2 += (float)(from * from);
    }
    if (!(distance2 < cluster->distance2))
        return;
    cluster->distance2 = distance2;
    memcpy(cluster->element.corners, third->corners, sizeof cluster->element.corners);
    memcpy(cluster->element.weights, weights, sizeof cluster->element.weights);
    cluster->element.side = third->side;
    cluster->element.pane = maker->pane;
}

/* An element lies where its cluster's surface is nearest to its middle: within a face, not on its
 * edge. */
static void choose_place(struct maker *maker, const struct third *third) {
    struct cluster *cluster = cluster_of(maker, third);
    consider(maker, cluster, third, third->at);
    consider(maker, cluster, third, third->inner);
}

/* --- triangles -------------------------------------------------------------------------------- */

struct piece {
    float at[3][3]; /* weights of the triangle's corners at the piece's */
};

static int longest_edge(const vec3s places[3], float *length2) {
    int longest = 0;
    *length2 = -1;
    for (int e = 0; e < 3; e++) {
        float each = glms_vec3_distance2(places[e], places[(e + 1) % 3]);
        if (each > *length2) {
            *length2 = each;
            longest = e;
        }
    }
    return longest;
}

static vec3s emission_at(const struct maker *maker, const struct corners *corners,
                         const struct material *material) {
    const struct surface_colors *colors = &maker->colors;
    vec4s texel = corners_texel(
        corners, colors->scene, colors->geometry, colors->srgb_to_linear,
        &(struct corners_texture){material->emission_texture, material->emission_mapping});
    const float *emission = material->emission;
    return (vec3s){{emission[0] * texel.r, emission[1] * texel.g, emission[2] * texel.b}};
}

static void visit_piece(struct maker *maker, const uint32_t *index, const struct piece *piece,
                        const vec3s places[3], const struct material *material,
                        visit_third *visit) {
    struct third third = {.corners = index, .albedo = glms_vec3_one()};
    float middle[3], alpha = 1;
    for (int c = 0; c < 3; c++)
        middle[c] = (piece->at[0][c] + piece->at[1][c] + piece->at[2][c]) / 3;
    if (material->alpha_mask || maker->colored) {
        struct corners corners = corners_of(index, middle);
        vec4s albedo = corners_albedo(&corners, &maker->colors, material, NULL);
        third.albedo = glms_vec3(albedo);
        if (maker->colored)
            third.emission = emission_at(maker, &corners, material);
        alpha = albedo.w;
    }
    if (material_is_hole(material, alpha))
        return;
    third.area = glms_vec3_norm(glms_vec3_cross(glms_vec3_sub(places[1], places[0]),
                                                glms_vec3_sub(places[2], places[0]))) /
                 6;
    if (!(third.area > 0))
        return;
    const float last = material->double_sided || maker->pane ? -1 : 1;
    for (int v = 0; v < 3; v++) {
        memcpy(third.at, piece->at[v], sizeof third.at);
        for (int c = 0; c < 3; c++) /* the centroid of what is nearest to the corner, by medians */
            third.inner[c] = (5 * piece->at[v][c] + 7 * middle[c]) / 12;
        for (third.side = 1; third.side >= last; third.side -= 2)
            visit(maker, &third);
    }
}

/* Cuts the triangle in halves until no edge is too long. */
static void visit_triangle(struct maker *maker, const uint32_t *index,
                           const struct material *material, visit_third *visit) {
    struct piece stack[STACK_MAX] = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    for (int size = 1; size > 0;) {
        struct piece piece = stack[--size], half = piece;
        vec3s places[3];
        float length2;
        for (int v = 0; v < 3; v++)
            places[v] = place_of(maker, index, piece.at[v]);
        int edge = longest_edge(places, &length2);
        if (!(length2 > maker->edge * maker->edge) || size + 2 > STACK_MAX) {
            visit_piece(maker, index, &piece, places, material, visit);
            continue;
        }
        int next = (edge + 1) % 3;
        for (int c = 0; c < 3; c++)
            piece.at[next][c] = half.at[edge][c] = (piece.at[edge][c] + piece.at[next][c]) / 2;
        stack[size++] = half;
        stack[size++] = piece;
    }
}

static void visit_all(struct maker *maker, visit_third *visit) {
    const struct geometry *geometry = maker->desc->geometry;
    int end = maker->desc->panes ? geometry->batch_count : geometry->blocking_batch_count;
    for (int b = 0; b < end; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        maker->pane = b >= geometry->blocking_batch_count;
        for (uint32_t i = 0; i < batch->index_count; i += 3)
            visit_triangle(maker, &geometry->indices[batch->first_index + i],
                           &maker->desc->scene->materials[batch->material], visit);
    }
}

static void count_third(struct maker *maker, const struct third *third) {
    if (maker->count <= 8 * (uint32_t)maker->desc->most)
        cluster_of(maker, third);
}

/* --- elements --------------------------------------------------------------------------------- */

static double area_of(const struct elements_desc *desc) {
    double area = 0;
    for (int b = 0; b < desc->geometry->blocking_batch_count; b++) {
        const struct geometry_batch *batch = &desc->geometry->batches[b];
        double sides = desc->scene->materials[batch->material].double_sided ? 2 : 1;
        for (uint32_t i = 0; i < batch->index_count; i += 3)
            area += sides *
                    corners_area(desc->geometry, &desc->geometry->indices[batch->first_index + i]);
    }
    return area;
}

static void empty(struct maker *maker) {
    maker->count = 0;
    memset(maker->slots, 0, maker->slot_count * sizeof *maker->slots);
}

/* The finest grid with no more occupied cells than elements are wanted, within a tenth. */
static void fit_grid(struct maker *maker, double area) {
    const float most = (float)maker->desc->most;
    const float finest = .4F * geometry_clearance(maker->desc->geometry); /* more than rounding */
    maker->edge = fmaxf(sqrtf(2 * (float)area / most), finest);
    for (int i = 0; i < ATTEMPTS; i++) {
        maker->cell = fmaxf(cell_fraction * maker->edge, finest);
        empty(maker);
        visit_all(maker, count_third);
        if ((float)maker->count <= most)
            return;
        maker->edge *= fmaxf(sqrtf(.97F * (float)maker->count / most), 1.03F);
    }
}

static void take_clusters(struct elements *elements, const struct maker *maker) {
    elements->items = mem_alloc(maker->count, sizeof *elements->items);
    for (uint32_t i = 0; i < maker->count; i++) {
        const struct cluster *cluster = &maker->clusters[i];
        struct element *element = &elements->items[elements->count];
        if (!(cluster->area > 0) || !isfinite(cluster->distance2))
            continue;
        *element = cluster->element;
        element->area = (float)cluster->area * (element->pane ? pane_area : 1);
        for (int c = 0; c < 3; c++) {
            element->albedo.raw[c] = (float)(cluster->albedo[c] / cluster->area);
            element->emission.raw[c] = (float)(cluster->emission[c] / cluster->area);
        }
        elements->count++;
    }
}

void elements_init(struct elements *elements, const struct elements_desc *desc) {
    struct maker maker = {.desc = desc,
                          .slot_count = 1 << 14,
                          .colors = {.scene = desc->scene,
                                     .geometry = desc->geometry,
                                     .materials = desc->materials,
                                     .smooth_black = desc->smooth_black}};
    double area = area_of(desc);
    *elements = (struct elements){0};
    if (!(area > 0))
        return;
    texture_decode_table(maker.colors.srgb_to_linear);
    maker.slots = mem_alloc(maker.slot_count, sizeof *maker.slots);
    fit_grid(&maker, area);
    empty(&maker);
    maker.colored = true;
    visit_all(&maker, add_third);
    maker.colored = false;
    visit_all(&maker, choose_place);
    take_clusters(elements, &maker);
    mem_free(maker.slots, maker.clusters);
    elements->edge = maker.edge;
    elements_place(elements, desc->geometry);
}

void elements_free(struct elements *elements) {
    free(elements->items);
    *elements = (struct elements){0};
}

void elements_place(struct elements *elements, const struct geometry *geometry) {
    for (int i = 0; i < elements->count; i++) {
        struct element *element = &elements->items[i];
        struct corners corners = corners_of(element->corners, element->weights);
        element->position = corners_vector(&corners, geometry->position);
        element->normal =
            glms_vec3_scale(vec3s_unit(corners_vector(&corners, geometry->normal)), element->side);
    }
}
