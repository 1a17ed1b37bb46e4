#include "scene/emissive.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/names.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- shapes ----------------------------------------------------------------------------------- */

/* How far a shape may be from what it is taken for, of its size or area. */
static const double tolerance = 1e-3;

/* Of an octagon's area, that of the circle around it. */
static const double octagon_share = .9003;

typedef double dvec3[3];

static void difference(const float *a, const double *b, dvec3 out) {
    for (int c = 0; c < 3; c++)
        out[c] = (double)a[c] - b[c];
}

static void cross(const dvec3 a, const dvec3 b, dvec3 out) {
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        out[c] = a[d] * b[e] - a[e] * b[d];
    }
}

static double dot(const dvec3 a, const dvec3 b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double norm(const dvec3 a) {
    return sqrt(dot(a, a));
}

/* All triangles of a primitive taken together. */
struct whole {
    const struct primitive *primitive;
    dvec3 center, normal; /* of the area; unit */
    double area, radius;  /* of the farthest vertex from the centre */
    dvec3 farthest;       /* that vertex, from the centre */
};

static const float *corner_of(const struct primitive *primitive, int index) {
    return primitive->position[primitive->indices[index]];
}

/* Sums areas as vectors: they add up to the sum of lengths only where all face the same way. */
static bool sum_areas(struct whole *whole) {
    const struct primitive *primitive = whole->primitive;
    const double origin[3] = {0};
    dvec3 first;
    if (primitive->index_count < 3)
        return false;
    difference(corner_of(primitive, 0), origin, first);
    for (int i = 0; i + 2 < primitive->index_count; i += 3) {
        dvec3 a, b, c, area;
        difference(corner_of(primitive, i), first, a);
        difference(corner_of(primitive, i + 1), first, b);
        difference(corner_of(primitive, i + 2), first, c);
        dvec3 ab = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        dvec3 ac = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        cross(ab, ac, area);
        double size = norm(area) / 2;
        whole->area += size;
        for (int k = 0; k < 3; k++) {
            whole->normal[k] += area[k] / 2;
            whole->center[k] += (a[k] + b[k] + c[k]) / 3 * size;
        }
    }
    double vector_sum = norm(whole->normal);
    if (!(whole->area > 0) || vector_sum < (1 - tolerance) * whole->area)
        return false;
    for (int k = 0; k < 3; k++) {
        whole->normal[k] /= vector_sum;
        whole->center[k] = whole->center[k] / whole->area + first[k];
    }
    return true;
}

/* Finds the farthest vertex; false where not all lie in one plane. */
static bool measure(struct whole *whole) {
    double off_plane = 0;
    for (int i = 0; i < whole->primitive->index_count; i++) {
        dvec3 from;
        difference(corner_of(whole->primitive, i), whole->center, from);
        off_plane = fmax(off_plane, fabs(dot(from, whole->normal)));
        if (norm(from) > whole->radius) {
            whole->radius = norm(from);
            memcpy(whole->farthest, from, sizeof from);
        }
    }
    return off_plane <= tolerance * whole->radius;
}

static void set_frame(struct flat_shape *shape, const struct whole *whole, const dvec3 right) {
    dvec3 up;
    cross(whole->normal, right, up);
    for (int c = 0; c < 3; c++) {
        shape->center[c] = (float)whole->center[c];
        shape->normal[c] = (float)whole->normal[c];
        shape->right[c] = (float)(right[c] / norm(right));
        shape->up[c] = (float)(up[c] / norm(up));
    }
}

/* A rectangle's farthest vertex is a corner, and of those farthest from the diagonal through it each is
 * another: then area says whether the triangles fill what the corners span. */
static bool fits_rectangle(struct flat_shape *shape, const struct whole *whole) {
    dvec3 other = {0}, right, up, turned;
    double away = 0;
    for (int i = 0; i < whole->primitive->index_count; i++) {
        dvec3 from;
        difference(corner_of(whole->primitive, i), whole->center, from);
        cross(whole->farthest, from, turned);
        if (norm(turned) > away * (1 + tolerance)) {
            away = norm(turned);
            memcpy(other, from, sizeof other);
        }
    }
    for (int c = 0; c < 3; c++) {
        right[c] = other[c] - whole->farthest[c];
        up[c] = other[c] + whole->farthest[c];
    }
    double width = norm(right), height = norm(up);
    if (fabs(dot(right, up)) > tolerance * width * height ||
        fabs(width * height - whole->area) > tolerance * whole->area)
        return false;
    set_frame(shape, whole, right);
    shape->size[0] = (float)width;
    shape->size[1] = (float)height;
    return true;
}

/* The integral of the squared distance from the centre, over the triangles. */
static double second_moment(const struct whole *whole) {
    double sum = 0;
    for (int i = 0; i + 2 < whole->primitive->index_count; i += 3) {
        dvec3 p[3], ab, ac, area, middle;
        for (int k = 0; k < 3; k++)
            difference(corner_of(whole->primitive, i + k), whole->center, p[k]);
        for (int c = 0; c < 3; c++) {
            ab[c] = p[1][c] - p[0][c], ac[c] = p[2][c] - p[0][c];
            middle[c] = p[0][c] + p[1][c] + p[2][c];
        }
        cross(ab, ac, area);
        double squares = dot(p[0], p[0]) + dot(p[1], p[1]) + dot(p[2], p[2]);
        sum += norm(area) / 2 * (squares + dot(middle, middle)) / 12;
    }
    return sum;
}

/* A regular polygon's area tells how many corners it has, and its second moment that it is one. The
 * disk has the same area. */
static bool fits_disk(struct flat_shape *shape, const struct whole *whole) {
    double square = whole->radius * whole->radius, share = whole->area / (GLM_PI * square);
    if (share < octagon_share || share > 1 + tolerance)
        return false;
    /* sin(x) / x = share, x = 2 pi / corners */
    double x = sqrt(fmax(0, 10 * (1 - sqrt(fmax(0, 1 - 1.2 * (1 - share))))));
    double moment = whole->area * square * (2 + cos(x)) / 6;
    if (fabs(second_moment(whole) - moment) > 10 * tolerance * moment)
        return false;
    set_frame(shape, whole, whole->farthest);
    shape->size[0] = (float)(2 * sqrt(whole->area / GLM_PI));
    shape->size[1] = 0;
    return true;
}

bool flat_shape_of(struct flat_shape *shape, const struct primitive *primitive) {
    struct whole whole = {.primitive = primitive};
    return sum_areas(&whole) && measure(&whole) &&
           (fits_rectangle(shape, &whole) || fits_disk(shape, &whole));
}

/* --- lights ----------------------------------------------------------------------------------- */

/* An emissive side of a primitive of a node. */
struct lamp {
    int node, material;
    bool back;
    const struct flat_shape *shape;
    double power; /* over pi, the sum of RGB, W */
};

/* The most powerful of all, in node order. */
struct lamps {
    struct lamp items[EMISSIVE_LIGHTS_MAX];
    int kept;
    long count;
};

static bool is_emissive(const struct scene *scene, const struct primitive *primitive) {
    const float *emission = scene->materials[primitive->material].emission;
    return emission[0] + emission[1] + emission[2] > 0;
}

static bool is_uniform(const struct scene *scene, const struct primitive *primitive) {
    const struct material *material = &scene->materials[primitive->material];
    return material->emission_texture < 0 && !material->alpha_mask && !primitive->joints &&
           !primitive->targets;
}

/* Takes the place of the least, where that is less. */
static void keep_lamp(struct lamps *lamps, const struct lamp *lamp) {
    int least = 0;
    lamps->count++;
    if (lamps->kept < EMISSIVE_LIGHTS_MAX) {
        lamps->items[lamps->kept++] = *lamp;
        return;
    }
    for (int i = 1; i < lamps->kept; i++)
        if (lamps->items[i].power <= lamps->items[least].power)
            least = i;
    if (lamps->items[least].power >= lamp->power)
        return;
    memmove(&lamps->items[least], &lamps->items[least + 1],
            (size_t)(lamps->kept - least - 1) * sizeof *lamp);
    lamps->items[lamps->kept - 1] = *lamp;
}

/* Of the shape's area as the world has it, m2; of a disk, of the square around it. */
static double world_area(const struct flat_shape *shape, const float world[16]) {
    double right[3] = {0}, up[3] = {0}, across[3];
    float height = shape->size[1] > 0 ? shape->size[1] : shape->size[0];
    for (int axis = 0; axis < 3; axis++)
        for (int c = 0; c < 3; c++) {
            right[c] += (double)world[4 * axis + c] * (double)(shape->right[axis] * shape->size[0]);
            up[c] += (double)world[4 * axis + c] * (double)(shape->up[axis] * height);
        }
    cross(right, up, across);
    return norm(across);
}

static void keep_sides(struct lamps *lamps, const struct scene *scene, int node,
                       const struct primitive *primitive, const struct flat_shape *shape,
                       const float world[16]) {
    const struct material *material = &scene->materials[primitive->material];
    struct lamp lamp = {.node = node, .material = primitive->material, .shape = shape};
    double area = world_area(shape, world) * (shape->size[1] > 0 ? 1 : GLM_PI / 4);
    for (int c = 0; c < 3; c++)
        lamp.power += (double)material->emission[c] * area;
    keep_lamp(lamps, &lamp);
    lamp.back = true;
    if (material->double_sided)
        keep_lamp(lamps, &lamp);
}

/* Each primitive's shape, of all meshes in their order; size 0 where it is no lamp's. The names of
 * what stays dark. */
static struct flat_shape *find_shapes(const struct scene *scene, int *first, struct names *dark) {
    int count = 0;
    for (int m = 0; m < scene->mesh_count; m++) {
        first[m] = count;
        count += scene->meshes[m].primitive_count;
    }
    struct flat_shape *shapes = mem_alloc((size_t)count, sizeof *shapes);
    bool *is_dark = mem_alloc((size_t)scene->material_count, sizeof *is_dark);
    for (int m = 0; m < scene->mesh_count; m++)
        for (int p = 0; p < scene->meshes[m].primitive_count; p++) {
            const struct primitive *primitive = &scene->meshes[m].primitives[p];
            if (is_emissive(scene, primitive) &&
                !(is_uniform(scene, primitive) && flat_shape_of(&shapes[first[m] + p], primitive)))
                is_dark[primitive->material] = true;
        }
    for (int m = 0; m < scene->material_count; m++)
        if (is_dark[m])
            names_add(dark, ", ",
                      *scene->materials[m].name ? scene->materials[m].name : "without a name");
    free(is_dark);
    return shapes;
}

static void find_lamps(struct lamps *lamps, const struct scene *scene,
                       const struct flat_shape *shapes, const int *first) {
    float(*worlds)[16] = mem_alloc((size_t)scene->node_count, sizeof *worlds);
    scene_node_worlds(scene, 0, worlds);
    for (int n = 0; n < scene->node_count; n++) {
        int mesh = scene->nodes[n].metaballs < 0 ? scene->nodes[n].mesh : -1;
        for (int p = 0; mesh >= 0 && p < scene->meshes[mesh].primitive_count; p++)
            if (shapes[first[mesh] + p].size[0] > 0)
                keep_sides(lamps, scene, n, &scene->meshes[mesh].primitives[p],
                           &shapes[first[mesh] + p], worlds[n]);
    }
    free(worlds);
}

/* A light shines along its node's -Z, and lies a little above the surface, which would hide it. */
static void place_lamp(struct node *node, const struct lamp *lamp) {
    const struct flat_shape *shape = lamp->shape;
    float lift = 1e-4F * shape->size[0], side = lamp->back ? -1 : 1;
    mat4 matrix = GLM_MAT4_IDENTITY_INIT;
    for (int c = 0; c < 3; c++) {
        matrix[0][c] = shape->right[c] * -side;
        matrix[1][c] = shape->up[c];
        matrix[2][c] = shape->normal[c] * -side;
        matrix[3][c] = shape->center[c] + side * lift * shape->normal[c];
    }
    node->has_matrix = true;
    memcpy(node->matrix, matrix, sizeof node->matrix);
}

static void add_light(struct scene *scene, const struct lamp *lamp) {
    const struct material *material = &scene->materials[lamp->material];
    struct scene_light *light = &scene->lights[scene->light_count];
    struct node *node = &scene->nodes[scene->node_count++];
    *light = (struct scene_light){.type = EMITTER_AREA,
                                  .outer = GLM_PI_2f,
                                  .range = INFINITY,
                                  .size = {lamp->shape->size[0], lamp->shape->size[1]},
                                  .scaling = LIGHT_SCALED_EACH_WAY};
    memcpy(light->intensity, material->emission, sizeof light->intensity);
    snprintf(light->name, sizeof light->name, "%s", material->name);
    *node = (struct node){.parent = lamp->node,
                          .mesh = -1,
                          .light = scene->light_count++,
                          .camera = -1,
                          .skin = -1,
                          .metaballs = -1};
    memcpy(node->name, scene->nodes[lamp->node].name, sizeof node->name);
    place_lamp(node, lamp);
}

void emissive_add_lights(struct scene *scene) {
    struct lamps lamps = {0};
    struct names dark = {0};
    int *first = mem_alloc((size_t)scene->mesh_count, sizeof *first);
    struct flat_shape *shapes = find_shapes(scene, first, &dark);
    if (dark.length)
        log_note(
            "%s: emissive, but no flat rectangle or disk of one colour, so it lights nothing: %s",
            scene->path, dark.text);
    find_lamps(&lamps, scene, shapes, first);
    if (lamps.kept < lamps.count)
        log_note("%s: of %ld emissive surfaces the %d most powerful shine", scene->path,
                 lamps.count, lamps.kept);
    size_t kept = (size_t)lamps.kept;
    scene->nodes = mem_resize(scene->nodes, (size_t)scene->node_count + kept, sizeof *scene->nodes);
    scene->lights =
        mem_resize(scene->lights, (size_t)scene->light_count + kept, sizeof *scene->lights);
    for (int i = 0; i < lamps.kept; i++)
        add_light(scene, &lamps.items[i]);
    free(shapes);
    free(first);
}
