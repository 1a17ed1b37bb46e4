#include "scene/lights/emissive.h"

#include "base/deal.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/names.h"
#include "scene/lights/flat_shape.h"
#include "scene/lights/islands.h"
#include "scene/lights/lamp_parts.h"
#include "scene/lights/lamp_triangles.h"
#include "scene/node.h"
#include "scene/texture.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* An emissive surface of the scene, an island of a primitive, and how it becomes lights. */
struct finding {
    int node;
    const struct primitive *primitive;
    int number;              /* of the primitive in its mesh */
    struct primitive island; /* of the primitive's triangles these alone: all arrays are its */
    const struct material *material;
    bool is_flat; /* a rectangle or a disk of one colour */
    struct flat_shape shape;
    float radiance[3]; /* of a flat one, W/(sr m2) */
    double power;      /* of all sides, over pi, the sum of RGB, W */
    int lights;        /* that it gets; 0: it is of the rest */
};

struct findings {
    struct scene *scene;
    float (*worlds)[16]; /* at time 0 */
    struct finding *items;
    int count, room;
    struct islands **islands; /* of each mesh's primitives; without ends where not needed yet */
    bool *told;               /* each material: it is among the names */
    uint32_t looks;           /* left, as struct lamp_triangles has them */
    float srgb_to_linear[256];
    struct names dark;
};

/* Findings from which on a primitive is one, however many islands it has. */
enum { FINDINGS_MAX = 1 << 16 };

/* --- surfaces --------------------------------------------------------------------------------- */

static int sides_of(const struct finding *finding) {
    return finding->material->double_sided ? 2 : 1;
}

/* Adds the triangles of a finding. */
static void add_triangles(struct lamp_triangles *triangles, const struct findings *findings,
                          const struct finding *finding) {
    triangles->srgb_to_linear = findings->srgb_to_linear;
    lamp_triangles_add(triangles, findings->scene, &finding->island,
                       findings->worlds[finding->node]);
}

/* Finds power, shape and colour. */
static void measure(struct findings *findings, struct finding *finding) {
    struct lamp_triangles triangles = {.looks = findings->looks};
    add_triangles(&triangles, findings, finding);
    finding->power = lamp_triangles_power(&triangles);
    finding->is_flat = lamp_triangles_color(&triangles, finding->radiance) &&
                       flat_shape_of(&finding->shape, &finding->island);
    findings->looks = triangles.looks;
    lamp_triangles_free(&triangles);
}

static void add_finding(struct findings *findings, const struct finding *finding) {
    if (findings->count == findings->room) {
        findings->room = 2 * findings->room + 16;
        findings->items =
            mem_resize(findings->items, (size_t)findings->room, sizeof *findings->items);
    }
    findings->items[findings->count] = *finding;
    measure(findings, &findings->items[findings->count]);
    findings->count += findings->items[findings->count].power > 0;
}

static const struct islands *islands_of(struct findings *findings, int mesh, int number) {
    const struct mesh *of = &findings->scene->meshes[mesh];
    if (!findings->islands[mesh])
        findings->islands[mesh] =
            mem_alloc((size_t)of->primitive_count, sizeof **findings->islands);
    struct islands *islands = &findings->islands[mesh][number];
    if (!islands->ends)
        islands_init(islands, &of->primitives[number]);
    return islands;
}

static void find_surface(struct findings *findings, int node, int mesh, int number) {
    const struct scene *scene = findings->scene;
    const struct primitive *primitive = &scene->meshes[mesh].primitives[number];
    const struct material *material = &scene->materials[primitive->material];
    struct finding finding = {
        .node = node, .primitive = primitive, .number = number, .material = material};
    if (glm_vec3_max((float *)material->emission) <= 0)
        return;
    if (primitive->joints || primitive->targets || scene->nodes[node].metaballs >= 0) {
        if (!findings->told[primitive->material])
            names_add(&findings->dark, ", ", *material->name ? material->name : "without a name");
        findings->told[primitive->material] = true;
        return;
    }
    const struct islands *islands = islands_of(findings, mesh, number);
    bool whole = islands->count > FINDINGS_MAX - findings->count;
    for (int i = 0; i < (whole ? 1 : islands->count); i++) {
        int end = islands->ends[whole ? islands->count : i + 1];
        finding.island = *primitive;
        finding.island.indices += islands->ends[i];
        finding.island.index_count = end - islands->ends[i];
        add_finding(findings, &finding);
    }
}

static void find_surfaces(struct findings *findings) {
    const struct scene *scene = findings->scene;
    for (int n = 0; n < scene->node_count; n++) {
        int mesh = scene->nodes[n].hidden ? -1 : scene->nodes[n].mesh;
        for (int p = 0; mesh >= 0 && p < scene->meshes[mesh].primitive_count; p++)
            find_surface(findings, n, mesh, p);
    }
}

/* --- shares ----------------------------------------------------------------------------------- */

static int least_lights(const struct finding *finding) {
    return finding->is_flat ? sides_of(finding) : 1;
}

static int by_power(const void *a, const void *b) {
    const struct finding *const *x = a, *const *y = b;
    double p = (*x)->power, q = (*y)->power;
    return p != q ? (p < q) - (p > q) : (*x > *y) - (*x < *y); /* the same whatever qsort does */
}

/* Gives the most powerful what they need at least; returns how many lights are left. */
static int give_least(struct findings *findings) {
    struct finding **order = mem_alloc((size_t)findings->count, sizeof *order);
    int needed = 0, left = EMISSIVE_LIGHTS_MAX;
    for (int i = 0; i < findings->count; i++) {
        order[i] = &findings->items[i];
        needed += least_lights(order[i]);
    }
    qsort(order, (size_t)findings->count, sizeof *order, by_power);
    if (needed > EMISSIVE_LIGHTS_MAX)
        left -= STAND_INS_OF_REST;
    for (int i = 0; i < findings->count && left >= least_lights(order[i]); i++) {
        order[i]->lights = least_lights(order[i]);
        left -= order[i]->lights;
    }
    free(order);
    return needed > EMISSIVE_LIGHTS_MAX ? 0 : left;
}

/* Deals what is left to those that are no flat shape, by power. */
static void give_more(struct findings *findings, int left) {
    double *powers = mem_alloc((size_t)findings->count, sizeof *powers), sum = 0;
    int *counts = mem_alloc((size_t)findings->count, sizeof *counts), shaped = 0;
    for (int i = 0; i < findings->count; i++) {
        const struct finding *finding = &findings->items[i];
        bool shares = !finding->is_flat && finding->lights > 0;
        powers[i] = shares ? finding->power : 0;
        sum += powers[i];
        shaped += shares;
    }
    int count = shaped * STAND_INS_MAX < left + shaped ? shaped * STAND_INS_MAX : left + shaped;
    struct dealt *dealt = mem_alloc((size_t)count, sizeof *dealt);
    if (sum > 0)
        deal(powers, findings->count, dealt, count, counts);
    for (int i = 0; i < findings->count; i++)
        if (counts[i] > 0)
            findings->items[i].lights = counts[i] < STAND_INS_MAX ? counts[i] : STAND_INS_MAX;
    mem_free(dealt, powers, counts);
}

/* --- lights ----------------------------------------------------------------------------------- */

/* The frame of a light that shines along a normal from a place: along its node's -Z. */
static void set_frame(mat4 matrix, const float center[3], const float right[3], const float up[3],
                      const float normal[3]) {
    glm_mat4_identity(matrix);
    for (int c = 0; c < 3; c++) {
        matrix[0][c] = -right[c];
        matrix[1][c] = up[c];
        matrix[2][c] = -normal[c];
        matrix[3][c] = center[c];
    }
}

/* Below a node; parent -1: the root. */
static void add_light(struct scene *scene, int parent, const char *name,
                      const struct scene_light *source, mat4 matrix) {
    struct scene_light *light = &scene->lights[scene->light_count];
    struct node *node = &scene->nodes[scene->node_count++];
    *light = *source;
    snprintf(light->name, sizeof light->name, "%s", name);
    *node = node_new();
    node->parent = parent;
    node->light = scene->light_count++;
    node->has_matrix = true;
    if (parent >= 0)
        memcpy(node->name, scene->nodes[parent].name, sizeof node->name);
    memcpy(node->matrix, matrix, sizeof node->matrix);
}

static struct scene_light area_light(const float radiance[3], const float size[2], int lamp) {
    return (struct scene_light){.type = EMITTER_AREA,
                                .outer = GLM_PI_2f,
                                .range = INFINITY,
                                .intensity = {radiance[0], radiance[1], radiance[2]},
                                .size = {size[0], size[1]},
                                .scaling = LIGHT_SCALED_EACH_WAY,
                                .lamp = lamp};
}

/* It lies a little above the surface, which would hide it. */
static void add_flat_lights(struct scene *scene, const struct finding *finding, int lamp) {
    const struct flat_shape *shape = &finding->shape;
    const struct material *material = finding->material;
    struct scene_light light = area_light(finding->radiance, shape->size, lamp);
    for (int i = 0; i < sides_of(finding); i++) {
        float side = i ? -1 : 1;
        vec3 center, right, normal;
        mat4 matrix;
        glm_vec3_scale((float *)shape->right, side, right);
        glm_vec3_scale((float *)shape->normal, side, normal);
        glm_vec3_copy((float *)shape->center, center);
        glm_vec3_muladds(normal, 1e-4F * shape->size[0], center);
        set_frame(matrix, center, right, shape->up, normal);
        add_light(scene, finding->node, material->name, &light, matrix);
    }
}

/* Where a node has no inverse, the light hangs on none. */
static bool find_inverse(const float world[16], mat4 inverse) {
    mat4 matrix;
    memcpy(matrix, world, sizeof matrix);
    float scale = glm_vec3_norm(matrix[0]) * glm_vec3_norm(matrix[1]) * glm_vec3_norm(matrix[2]);
    if (!(fabsf(glm_mat4_det(matrix)) > 1e-6F * scale))
        return false;
    glm_mat4_inv(matrix, inverse);
    return true;
}

static void add_stand_ins(struct findings *findings, const struct lamp_triangles *triangles,
                          int node, const char *name, int lamp, int most) {
    struct lamp_part parts[STAND_INS_OF_REST];
    int count = lamp_parts_make(triangles->items, triangles->count, parts, most);
    mat4 inverse = GLM_MAT4_IDENTITY_INIT;
    if (node >= 0 && !find_inverse(findings->worlds[node], inverse))
        node = -1;
    for (int i = 0; i < count; i++) {
        const struct lamp_part *part = &parts[i];
        struct scene_light light = area_light(part->radiance, part->size, lamp);
        light.stands_in = true;
        mat4 matrix;
        set_frame(matrix, part->center, part->right, part->up, part->normal);
        glm_mat4_mul(inverse, matrix, matrix);
        add_light(findings->scene, node, name, &light, matrix);
    }
}

/* --- all together ----------------------------------------------------------------------------- */

static void add_lamp(struct findings *findings, const struct finding *finding, int lamp) {
    if (finding->is_flat) {
        add_flat_lights(findings->scene, finding, lamp);
        return;
    }
    struct lamp_triangles triangles = {.looks = LAMP_LOOKS};
    add_triangles(&triangles, findings, finding);
    add_stand_ins(findings, &triangles, finding->node, finding->material->name, lamp,
                  finding->lights);
    lamp_triangles_free(&triangles);
}

/* Those that got no lights of their own, as one lamp that does not move. */
static void add_rest(struct findings *findings, int lamp) {
    struct lamp_triangles triangles = {.looks = LAMP_LOOKS};
    int rest = 0;
    for (int i = 0; i < findings->count; i++) {
        const struct finding *finding = &findings->items[i];
        if (finding->lights > 0)
            continue;
        add_triangles(&triangles, findings, finding);
        rest++;
    }
    if (rest > 0) {
        log_note("%s: of %d emissive surfaces the %d least powerful share %d lights, which stay "
                 "where they are, in frames that do not sample lights",
                 findings->scene->path, findings->count, rest, STAND_INS_OF_REST);
        add_stand_ins(findings, &triangles, -1, "other lamps", lamp, STAND_INS_OF_REST);
    }
    lamp_triangles_free(&triangles);
}

/* Lists which triangles are of the lamp. Triangles that look dark are of the lamp before them. */
static void add_surface(struct scene *scene, const struct finding *finding, int lamp) {
    int count = scene->surface_count;
    struct emissive_surface surface = {finding->node, finding->number, 0,
                                       finding->primitive->index_count, lamp};
    struct emissive_surface *last = count > 0 ? &scene->surfaces[count - 1] : NULL;
    if (last && last->node == surface.node && last->primitive == surface.primitive) {
        if (last->lamp == lamp)
            return;
        surface.first = last->end = (int)(finding->island.indices - finding->primitive->indices);
    }
    scene->surfaces[scene->surface_count++] = surface;
}

static void add_lamps(struct findings *findings) {
    struct scene *scene = findings->scene;
    int count = findings->count, rest = count + 1; /* the number of their lamp */
    scene->surfaces = mem_alloc((size_t)count, sizeof *scene->surfaces);
    for (int i = 0; i < count; i++) {
        const struct finding *finding = &findings->items[i];
        int lamp = finding->lights > 0 ? i + 1 : rest;
        add_surface(scene, finding, lamp);
        if (finding->lights > 0)
            add_lamp(findings, finding, lamp);
    }
    add_rest(findings, rest);
}

static void findings_free(struct findings *findings) {
    for (int m = 0; m < findings->scene->mesh_count; m++) {
        for (int p = 0; findings->islands[m] && p < findings->scene->meshes[m].primitive_count; p++)
            free(findings->islands[m][p].ends);
        free(findings->islands[m]);
    }
    mem_free(findings->islands, findings->items, findings->worlds, findings->told);
}

void emissive_add_lights(struct scene *scene) {
    struct findings findings = {.scene = scene, .looks = LAMP_LOOKS};
    findings.worlds = mem_alloc((size_t)scene->node_count, sizeof *findings.worlds);
    findings.told = mem_alloc((size_t)scene->material_count, sizeof *findings.told);
    findings.islands = mem_alloc((size_t)scene->mesh_count, sizeof *findings.islands);
    texture_decode_table(findings.srgb_to_linear);
    scene_node_worlds(scene, 0, findings.worlds);
    find_surfaces(&findings);
    if (findings.dark.length)
        log_note("%s: emissive, but it deforms, so it lights nothing: %s", scene->path,
                 findings.dark.text);
    if (findings.count > 0) {
        size_t most = EMISSIVE_LIGHTS_MAX;
        scene->nodes =
            mem_resize(scene->nodes, (size_t)scene->node_count + most, sizeof *scene->nodes);
        scene->lights =
            mem_resize(scene->lights, (size_t)scene->light_count + most, sizeof *scene->lights);
        give_more(&findings, give_least(&findings));
        add_lamps(&findings);
    }
    findings_free(&findings);
}

static struct emissive_span span_in(const struct geometry_part *part,
                                    const struct emissive_surface *surface) {
    return (struct emissive_span){(part->first_index + (uint32_t)surface->first) / 3,
                                  (part->first_index + (uint32_t)surface->end) / 3};
}

struct emissive_span emissive_find(const struct geometry *geometry,
                                   const struct emissive_surface *surface) {
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        if (part->node == surface->node && part->primitive == surface->primitive)
            return span_in(part, surface);
    }
    return (struct emissive_span){0, 0};
}

struct emissive_span *emissive_find_all(const struct geometry *geometry,
                                        const struct scene *scene) {
    struct emissive_span *spans = mem_alloc((size_t)scene->surface_count, sizeof *spans);
    int nodes = 0;
    for (int i = 0; i < geometry->part_count; i++)
        nodes = geometry->parts[i].node >= nodes ? geometry->parts[i].node + 1 : nodes;
    int *last = mem_alloc((size_t)nodes, sizeof *last); /* part of each node, + 1 */
    int *before = mem_alloc((size_t)geometry->part_count + 1, sizeof *before);
    for (int i = 1; i <= geometry->part_count; i++) {
        before[i] = last[geometry->parts[i - 1].node];
        last[geometry->parts[i - 1].node] = i;
    }
    for (int s = 0; s < scene->surface_count; s++) {
        const struct emissive_surface *surface = &scene->surfaces[s];
        for (int i = surface->node < nodes ? last[surface->node] : 0; i > 0; i = before[i])
            if (geometry->parts[i - 1].primitive == surface->primitive)
                spans[s] = span_in(&geometry->parts[i - 1], surface);
    }
    mem_free(last, before);
    return spans;
}

enum lamp_state *emissive_lamp_states(const struct scene *scene, const struct emitters *emitters) {
    int most = 0;
    for (int i = 0; i < scene->surface_count; i++)
        most = scene->surfaces[i].lamp > most ? scene->surfaces[i].lamp : most;
    enum lamp_state *states = mem_alloc((size_t)most + 1, sizeof *states);
    for (int i = 0; i < emitters->count; i++) {
        const struct emitter *light = &emitters->items[i];
        if (light->lamp > 0 && light->lamp <= most)
            states[light->lamp] = light->stands_in ? LAMP_STOOD_IN_FOR : LAMP_HAS_LIGHTS;
    }
    return states;
}
