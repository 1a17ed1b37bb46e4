#include "scene/mesh/geometry.h"

#include "base/error.h"
#include "base/extremes.h"
#include "base/memory.h"
#include "scene/animated.h"
#include "scene/animation.h"
#include "scene/material.h"
#include "scene/shapes/marching_cubes.h"
#include "scene/shapes/metaballs.h"

#include <cglm/cglm.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

/* So many vertices take 3 GiB; a scene of instances grows beyond it only by mistake or malice. */
static const uint64_t max_vertices = 1 << 26, max_indices = 3u << 26;

/* The polygoniser of a node's metaballs, and what it made last. */
struct geometry_balls {
    struct marching_cubes cubes;
    struct surface surface;
};

/* --- parts ------------------------------------------------------------------------------------ */

static struct surface *part_surface(const struct geometry *geometry, const struct scene *scene,
                                    const struct geometry_part *part) {
    return &geometry->balls[scene->nodes[part->node].metaballs].surface;
}

/* Dynamic parts get a half more than they need, so that they seldom outgrow it. */
static uint32_t room(uint32_t count) {
    return count + count / 2 + 3;
}

/* Sets the counts and makes sure of the room. */
static void size_part(const struct geometry *geometry, const struct scene *scene,
                      struct geometry_part *part) {
    const struct primitive *primitive = geometry_primitive(scene, part);
    if (!part->dynamic) {
        part->vertex_count = part->vertex_room = (uint32_t)primitive->vertex_count;
        part->index_count = part->index_room = (uint32_t)primitive->index_count;
        return;
    }
    const struct surface *surface = part_surface(geometry, scene, part);
    part->vertex_count = surface->vertex_count;
    part->index_count = surface->index_count;
    if (part->vertex_count > part->vertex_room)
        part->vertex_room = room(part->vertex_count);
    if (part->index_count > part->index_room)
        part->index_room = room(part->index_count / 3) * 3;
}

static bool has_scale_channel(const struct scene *scene, int node) {
    for (int i = 0; i < scene->clip_count; i++)
        for (int c = 0; c < scene->clips[i].channel_count; c++) {
            const struct channel *channel = &scene->clips[i].channels[c];
            if ((channel->path == CHANNEL_SCALE || channel->path == CHANNEL_VISIBLE) &&
                channel->target == node)
                return true;
        }
    return false;
}

/* Whether a clip scales the node or hides it: at the time when casters are made it may be flat, or
 * a point. */
static bool is_scaled(const struct scene *scene, int node) {
    for (; node >= 0; node = scene->nodes[node].parent)
        if (has_scale_channel(scene, node))
            return true;
    return false;
}

static int count_node_parts(const struct scene *scene, int node, bool dynamic) {
    int mesh = scene->nodes[node].mesh;
    if (mesh < 0 || scene->nodes[node].hidden || dynamic != (scene->nodes[node].metaballs >= 0))
        return 0;
    return dynamic ? 1 : scene->meshes[mesh].primitive_count;
}

static void list_node_parts(struct geometry *geometry, const struct scene *scene, int node,
                            bool dynamic) {
    int mesh = scene->nodes[node].mesh, count = count_node_parts(scene, node, dynamic);
    if (count == 0)
        return;
    bool rigid = !dynamic && scene->nodes[node].skin < 0 && scene->meshes[mesh].target_count == 0 &&
                 !is_scaled(scene, node);
    for (int p = 0; p < count; p++)
        geometry->parts[geometry->part_count++] = (struct geometry_part){
            .node = node, .primitive = p, .dynamic = dynamic, .rigid = rigid};
}

/* The first mapping, and those that any mesh has besides. */
static int count_mappings(const struct scene *scene) {
    int count = 1;
    for (int i = 0; i < scene->mesh_count; i++)
        for (int p = 0; p < scene->meshes[i].primitive_count; p++)
            for (int m = count; m < MAPPINGS_MAX; m++)
                if (scene->meshes[i].primitives[p].uv[m])
                    count = m + 1;
    return count;
}

static void find_attributes(struct geometry *geometry, const struct scene *scene) {
    for (int i = 0; i < geometry->part_count; i++) {
        const struct primitive *primitive = geometry_primitive(scene, &geometry->parts[i]);
        geometry->has_color |= primitive->color && !geometry->parts[i].dynamic;
        for (int m = 0; m < MAPPINGS_MAX; m++)
            geometry->has_uv[m] |= primitive->uv[m] && !geometry->parts[i].dynamic;
    }
}

/* Dynamic parts come last, so that the others' vertices stay where they are when one grows. */
static void list_parts(struct geometry *geometry, const struct scene *scene) {
    size_t count = 0;
    for (int node = 0; node < scene->node_count; node++)
        count +=
            (size_t)(count_node_parts(scene, node, false) + count_node_parts(scene, node, true));
    geometry->parts = mem_alloc(count, sizeof *geometry->parts);
    for (int dynamic = 0; dynamic < 2; dynamic++)
        for (int node = 0; node < scene->node_count; node++)
            list_node_parts(geometry, scene, node, dynamic);
}

static size_t vertex_bytes(const struct geometry *geometry) {
    size_t bytes = sizeof *geometry->position + sizeof *geometry->normal;
    for (int m = 0; m < geometry->mapping_count; m++)
        bytes += geometry->has_uv[m] ? sizeof *geometry->uv[m] : 0;
    return bytes + (geometry->has_color ? sizeof *geometry->color : 0);
}

/* Vertices of part after part. */
static bool lay_vertices(struct geometry *geometry, const struct scene *scene) {
    uint64_t vertices = 0, indices = 0;
    for (int i = 0; i < geometry->part_count; i++) {
        struct geometry_part *part = &geometry->parts[i];
        size_part(geometry, scene, part);
        part->first_vertex = (uint32_t)vertices;
        vertices += part->vertex_room;
        indices += part->index_room;
        if (vertices > max_vertices || indices > max_indices)
            return error_set("more than %u million vertices or triangles", 1u << 6);
    }
    if (indices == 0)
        return error_set("there is no triangle%s", scene->point_primitives + scene->line_primitives
                                                       ? ", and points and lines are not drawn"
                                                       : "");
    if (!mem_check(vertices * vertex_bytes(geometry) + indices * sizeof *geometry->indices))
        return error_prefix("%llu vertices and %llu indices", (unsigned long long)vertices,
                            (unsigned long long)indices);
    geometry->vertex_count = (uint32_t)vertices;
    geometry->index_count = (uint32_t)indices;
    return true;
}

/* Batches are in the order of their kinds. */
enum batch_kind { BATCH_OPAQUE, BATCH_MASKED, BATCH_GLASS, BATCH_PANE, BATCH_KINDS };

static enum batch_kind kind_of(const struct material *material) {
    if (material_is_pane(material))
        return material_smooth_kind(material) == SMOOTH_GLASS ? BATCH_GLASS : BATCH_PANE;
    return material->alpha_mask ? BATCH_MASKED : BATCH_OPAQUE;
}

static void find_blocking(struct geometry *geometry, const struct scene *scene) {
    enum batch_kind last = geometry->glass_blocks ? BATCH_GLASS : BATCH_MASKED;
    geometry->blocking_batch_count = 0;
    geometry->blocking_index_count = 0;
    for (int b = 0; b < geometry->batch_count; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        if (kind_of(&scene->materials[batch->material]) > last)
            break;
        geometry->blocking_batch_count = b + 1;
        geometry->blocking_index_count = batch->first_index + batch->index_count;
    }
}

/* Indices of batch after batch, in the order of drawing. */
static void lay_batches(struct geometry *geometry, const struct scene *scene) {
    struct key {
        uint32_t count, next;
    } *keys = mem_alloc((size_t)scene->material_count * 2, sizeof *keys);
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        keys[2 * geometry_primitive(scene, part)->material + part->dynamic].count +=
            part->index_room;
    }
    geometry->batch_count = 0;
    uint32_t first = 0;
    for (int kind = 0; kind < BATCH_KINDS; kind++) {
        for (int k = 0; k < 2 * scene->material_count; k++) {
            if ((int)kind_of(&scene->materials[k / 2]) != kind || keys[k].count == 0)
                continue;
            geometry->batches[geometry->batch_count++] = (struct geometry_batch){
                .material = k / 2, .first_index = first, .index_count = keys[k].count, k % 2};
            keys[k].next = first;
            first += keys[k].count;
        }
        if (kind == BATCH_OPAQUE)
            geometry->opaque_index_count = first;
    }
    find_blocking(geometry, scene);
    for (int i = 0; i < geometry->part_count; i++) {
        struct geometry_part *part = &geometry->parts[i];
        struct key *key = &keys[2 * geometry_primitive(scene, part)->material + part->dynamic];
        part->first_index = key->next;
        key->next += part->index_room;
    }
    free(keys);
}

static void allocate_arrays(struct geometry *geometry) {
    size_t vertices = geometry->vertex_count;
    geometry->position = mem_alloc(vertices + 1, sizeof *geometry->position);
    geometry->normal = mem_alloc(vertices, sizeof *geometry->normal);
    for (int m = 0; m < geometry->mapping_count; m++)
        geometry->uv[m] = mem_alloc(vertices, sizeof *geometry->uv[m]);
    if (geometry->has_color)
        geometry->color = mem_alloc(vertices, sizeof *geometry->color);
    geometry->indices = mem_alloc(geometry->index_count, sizeof *geometry->indices);
}

static void free_arrays(struct geometry *geometry) {
    mem_free(geometry->position, geometry->normal);
    for (int m = 0; m < MAPPINGS_MAX; m++)
        free(geometry->uv[m]);
    mem_free(geometry->color, geometry->indices);
}

/* What does not move: texture coordinates and colours, white where there is none. */
static void copy_attributes(struct geometry *geometry, const struct scene *scene,
                            const struct geometry_part *part) {
    static const float white[4] = {1, 1, 1, 1};
    const struct primitive *primitive = geometry_primitive(scene, part);
    for (uint32_t i = 0; i < part->vertex_room; i++) {
        uint32_t to = part->first_vertex + i;
        for (int m = 0; m < MAPPINGS_MAX && !part->dynamic; m++)
            if (primitive->uv[m])
                memcpy(geometry->uv[m][to], primitive->uv[m][i], sizeof *geometry->uv[m]);
        if (geometry->color)
            memcpy(geometry->color[to],
                   primitive->color && !part->dynamic ? primitive->color[i] : white, sizeof white);
    }
}

/* Makes the arrays for what the parts need now. */
static bool lay_out(struct geometry *geometry, const struct scene *scene) {
    free_arrays(geometry);
    geometry->position = geometry->normal = NULL;
    memset(geometry->uv, 0, sizeof geometry->uv);
    geometry->color = NULL;
    geometry->indices = NULL;
    geometry->laid_out = geometry->painted = geometry->pose_count;
    if (!lay_vertices(geometry, scene))
        return false;
    lay_batches(geometry, scene);
    allocate_arrays(geometry);
    for (int i = 0; i < geometry->part_count; i++)
        copy_attributes(geometry, scene, &geometry->parts[i]);
    return true;
}

/* --- posing ----------------------------------------------------------------------------------- */

/* A mirroring node turns triangles inside out: their winding is swapped, so that the front stays
 * the front. Room that a dynamic part leaves becomes triangles without area. */
static void fill_indices(struct geometry *geometry, const struct geometry_part *part,
                         const uint32_t *from) {
    uint32_t *to = geometry->indices + part->first_index;
    int swap = part->mirrored;
    for (uint32_t k = 0; k < part->index_count; k += 3) {
        to[k] = from[k] + part->first_vertex;
        to[k + 1 + swap] = from[k + 1] + part->first_vertex;
        to[k + 2 - swap] = from[k + 2] + part->first_vertex;
    }
    for (uint32_t k = part->index_count; k < part->index_room; k++)
        to[k] = part->first_vertex;
}

/* A part that is not shown is a point. */
static bool pose_part(struct geometry *geometry, const struct scene *scene,
                      struct geometry_part *part, bool anew) {
    const struct primitive *primitive = geometry_primitive(scene, part);
    const struct pose *pose = &geometry->pose;
    float(*position)[3] = geometry->position + part->first_vertex;
    float(*normal)[3] = geometry->normal + part->first_vertex;
    const struct surface *surface = part->dynamic ? part_surface(geometry, scene, part) : NULL;
    bool mirrored = pose_mirrors(pose, scene, part->node);
    part->moved = geometry->pose_count;
    if (anew || surface || mirrored != part->mirrored) {
        part->mirrored = mirrored;
        part->rewound = geometry->pose_count;
        fill_indices(geometry, part, surface ? surface->indices : primitive->indices);
    }
    if (surface ? pose_rigid(pose->worlds[part->node], surface->vertex_count, surface->position,
                             surface->normal, position, normal)
                : pose_vertices(pose, scene, part->node, primitive, position, normal)) {
        for (uint32_t i = 0; !pose->shown[part->node] && i < part->vertex_count; i++)
            memcpy(position[i], position[0], sizeof *position);
        return true;
    }
    int mesh = scene->nodes[part->node].mesh;
    return error_prefix("mesh %d '%s'", mesh, scene->meshes[mesh].name);
}

static void measure_part(const struct geometry *geometry, struct geometry_part *part) {
    float *low = part->bounds_min, *high = part->bounds_max;
    for (int c = 0; c < 3; c++)
        low[c] = FLT_MAX, high[c] = -FLT_MAX;
    for (uint32_t k = part->first_index; k < part->first_index + part->index_count; k++)
        for (int c = 0; c < 3; c++) {
            float x = geometry->position[geometry->indices[k]][c];
            low[c] = float_min(x, low[c]);
            high[c] = float_max(x, high[c]);
        }
}

static void measure_farthest(const struct geometry *geometry, struct geometry_part *part) {
    float farthest = 0;
    for (uint32_t k = part->first_index; k < part->first_index + part->index_count; k++)
        farthest = float_max(
            glm_vec3_distance2((float *)geometry->center, geometry->position[geometry->indices[k]]),
            farthest);
    part->farthest = sqrtf(farthest);
}

/* The bounds of the clip and of all parts, of which those that have just moved are measured anew */
static void measure(struct geometry *geometry) {
    float low[3], high[3];
    glm_vec3_copy(geometry->span.bounds_min, low);
    glm_vec3_copy(geometry->span.bounds_max, high);
    for (int i = 0; i < geometry->part_count; i++) {
        struct geometry_part *part = &geometry->parts[i];
        if (part->moved == geometry->pose_count)
            measure_part(geometry, part);
        if (part->index_count) {
            glm_vec3_minv(low, part->bounds_min, low);
            glm_vec3_maxv(high, part->bounds_max, high);
        }
    }
    if (low[0] > high[0]) { /* all metaballs have vanished, and there is nothing else */
        glm_vec3_zero(low);
        glm_vec3_zero(high);
    }
    bool same = memcmp(low, geometry->bounds_min, sizeof low) == 0 &&
                memcmp(high, geometry->bounds_max, sizeof high) == 0;
    glm_vec3_copy(low, geometry->bounds_min);
    glm_vec3_copy(high, geometry->bounds_max);
    glm_vec3_center(low, high, geometry->center);
    geometry->radius = fmaxf(geometry->span.radius, 1e-6F);
    for (int i = 0; i < geometry->part_count; i++) {
        struct geometry_part *part = &geometry->parts[i];
        if (!same || part->moved == geometry->pose_count)
            measure_farthest(geometry, part);
        geometry->radius = fmaxf(geometry->radius, part->farthest);
    }
}

/* Makes the surfaces of metaballs for the time. True when one outgrows its room. */
static bool polygonise(struct geometry *geometry, const struct scene *scene, double time) {
    bool outgrown = false;
    for (int i = 0; i < geometry->part_count; i++) {
        struct geometry_part *part = &geometry->parts[i];
        if (!part->dynamic)
            continue;
        int index = scene->nodes[part->node].metaballs;
        struct geometry_balls *balls = &geometry->balls[index];
        surface_clear(&balls->surface);
        metaballs_polygonise(&scene->metaballs[index], time, &balls->cubes, &balls->surface);
        part->vertex_count = balls->surface.vertex_count;
        part->index_count = balls->surface.index_count;
        outgrown |= part->vertex_count > part->vertex_room || part->index_count > part->index_room;
    }
    return outgrown;
}

/* Smaller parts are not shared, so that one draw can cover neighbouring parts. */
enum { TWIN_TRIANGLES = 1024 };

/* Finds parts of the same primitive and winding. The winding of a rigid part changes by rounding
 * alone, where it is flat. */
static void find_twins(struct geometry *geometry, const struct scene *scene) {
    int(*firsts)[2] = mem_alloc((size_t)scene->mesh_count, sizeof *firsts); /* + 1; 0: none */
    for (int i = 0; i < geometry->part_count; i++) {
        struct geometry_part *part = &geometry->parts[i];
        int *first = &firsts[scene->nodes[part->node].mesh][part->mirrored];
        part->twin = i;
        part->has_twin = false;
        if (!part->rigid || part->index_count < 3 * TWIN_TRIANGLES)
            continue;
        if (*first == 0)
            *first = i - part->primitive + 1;
        part->twin = *first - 1 + part->primitive;
        part->has_twin = geometry->parts[part->twin].has_twin = part->twin != i;
    }
    free(firsts);
}

/* Poses the parts that the new pose moves, or all; then the new pose is the present one. */
static bool pose_parts(struct geometry *geometry, const struct scene *scene, bool all) {
    struct pose before = geometry->pose;
    geometry->pose = geometry->next;
    geometry->next = before;
    for (int i = 0; i < geometry->part_count; i++) {
        struct geometry_part *part = &geometry->parts[i];
        if ((all || pose_differs(&geometry->pose, &before, scene, part->node)) &&
            !pose_part(geometry, scene, part, all))
            return false;
    }
    if (all)
        find_twins(geometry, scene);
    measure(geometry);
    return true;
}

static bool pose_at(struct geometry *geometry, const struct scene *scene, double time) {
    bool first = geometry->pose_count++ == 0;
    if (!pose_set(&geometry->next, scene, time))
        return false;
    bool other_balls = first || geometry->pose.time != time;
    bool outgrown = other_balls && polygonise(geometry, scene, time);
    bool anew = first || outgrown || geometry->broken;
    geometry->broken = !((!anew || lay_out(geometry, scene)) && pose_parts(geometry, scene, anew));
    return !geometry->broken;
}

/* --- the clip --------------------------------------------------------------------------------- */

static void empty_span(struct geometry_span *span, int clip_choice) {
    *span = (struct geometry_span){.clip_choice = clip_choice};
    glm_vec3_broadcast(FLT_MAX, span->bounds_min);
    glm_vec3_broadcast(-FLT_MAX, span->bounds_max);
}

/* The sphere is about the centre of the box, and holds those of all samples. */
static void add_samples(struct geometry_span *span, struct geometry *sample,
                        const struct scene *scene, double duration) {
    enum { STEPS_MAX = 128 };
    float spheres[STEPS_MAX + 1][4], center[3];
    int count = 0, steps = (int)fmin(ceil(duration / .1), STEPS_MAX);
    for (int i = 0; i <= steps; i++) {
        if (!pose_at(sample, scene, duration * i / steps))
            continue; /* a time that cannot be shown */
        glm_vec3_minv(span->bounds_min, sample->bounds_min, span->bounds_min);
        glm_vec3_maxv(span->bounds_max, sample->bounds_max, span->bounds_max);
        glm_vec3_copy(sample->center, spheres[count]);
        spheres[count++][3] = sample->radius;
    }
    glm_vec3_center(span->bounds_min, span->bounds_max, center);
    for (int i = 0; i < count; i++)
        span->radius = fmaxf(span->radius, glm_vec3_distance(center, spheres[i]) + spheres[i][3]);
}

/* By poses of its own, so that what is kept here does not depend on them. */
static void span_clip(struct geometry *geometry, const struct scene *scene) {
    double duration = scene_duration(scene);
    struct geometry sample;
    empty_span(&geometry->span, scene->clip_choice);
    if (duration <= 0 || !geometry_init_still(&sample, scene, 0))
        return;
    add_samples(&geometry->span, &sample, scene, duration);
    geometry_free(&sample);
}

static bool pose_in_clip(struct geometry *geometry, const struct scene *scene, double time) {
    if (!geometry->still && geometry->span.clip_choice != scene->clip_choice)
        span_clip(geometry, scene);
    return pose_at(geometry, scene, time);
}

bool geometry_pose(struct geometry *geometry, struct scene *scene, double time) {
    enum animated_change change = animated_pose_materials(scene, time);
    bool good = pose_in_clip(geometry, scene, time);
    if (change != ANIMATED_NOTHING)
        geometry->painted = geometry->pose_count;
    if (change == ANIMATED_OPACITY)
        geometry->laid_out = geometry->pose_count;
    return good || error_prefix("%s at %g s", scene->path, time);
}

static bool init(struct geometry *geometry, const struct scene *scene, double time, bool still) {
    *geometry = (struct geometry){.balls_count = scene->metaballs_count, .still = still};
    empty_span(&geometry->span, -1);
    geometry->balls = mem_alloc((size_t)scene->metaballs_count, sizeof *geometry->balls);
    for (int i = 0; i < geometry->balls_count; i++)
        marching_cubes_init(&geometry->balls[i].cubes);
    geometry->batches = mem_alloc((size_t)scene->material_count * 2, sizeof *geometry->batches);
    pose_init(&geometry->pose, scene);
    pose_init(&geometry->next, scene);
    list_parts(geometry, scene);
    find_attributes(geometry, scene);
    geometry->mapping_count = count_mappings(scene);
    if (pose_in_clip(geometry, scene, time))
        return true;
    geometry_free(geometry);
    return error_prefix("%s", scene->path);
}

bool geometry_init(struct geometry *geometry, const struct scene *scene, double time) {
    return init(geometry, scene, time, false);
}

bool geometry_init_still(struct geometry *geometry, const struct scene *scene, double time) {
    return init(geometry, scene, time, true);
}

void geometry_free(struct geometry *geometry) {
    for (int i = 0; i < geometry->balls_count; i++) {
        marching_cubes_free(&geometry->balls[i].cubes);
        surface_free(&geometry->balls[i].surface);
    }
    free(geometry->balls);
    pose_free(&geometry->pose);
    pose_free(&geometry->next);
    free_arrays(geometry);
    mem_free(geometry->batches, geometry->parts);
    *geometry = (struct geometry){0};
}

/* --- following -------------------------------------------------------------------------------- */

static bool differ(const void *a, const void *b, size_t first, size_t count, size_t size) {
    return memcmp((const char *)a + first * size, (const char *)b + first * size, count * size);
}

static bool have_one_place(const struct geometry_part *a, const struct geometry_part *b) {
    return a->node == b->node && a->primitive == b->primitive &&
           a->first_vertex == b->first_vertex && a->vertex_count == b->vertex_count &&
           a->first_index == b->first_index && a->index_count == b->index_count;
}

/* Compares what poses leave as it is. */
static bool have_one_layout(const struct geometry *a, const struct geometry *b) {
    size_t count = a->vertex_count;
    bool same = a->part_count == b->part_count && count == b->vertex_count &&
                a->index_count == b->index_count && a->mapping_count == b->mapping_count &&
                a->has_color == b->has_color && !differ(a->has_uv, b->has_uv, 0, 1, MAPPINGS_MAX) &&
                !differ(a->indices, b->indices, 0, a->index_count, sizeof *a->indices);
    for (int i = 0; same && i < a->part_count; i++)
        same = have_one_place(&a->parts[i], &b->parts[i]);
    for (int m = 0; same && m < a->mapping_count; m++)
        same = !a->has_uv[m] || !differ(a->uv[m], b->uv[m], 0, count, sizeof *a->uv[m]);
    return same && (!a->color || !differ(a->color, b->color, 0, count, sizeof *a->color));
}

void geometry_follow(struct geometry *geometry, const struct geometry *before) {
    bool same = have_one_layout(geometry, before);
    unsigned now = before->pose_count + 1;
    geometry->pose_count = geometry->painted = now;
    geometry->laid_out = same ? before->laid_out : now;
    geometry->changed = same ? before->changed : now;
    for (int i = 0; i < geometry->part_count; i++) {
        struct geometry_part *part = &geometry->parts[i];
        size_t first = part->first_vertex, count = part->vertex_count;
        bool moved = !same ||
                     differ(geometry->position, before->position, first, count, sizeof(vec3)) ||
                     differ(geometry->normal, before->normal, first, count, sizeof(vec3));
        part->moved = moved ? now : before->parts[i].moved;
        part->rewound = same ? before->parts[i].rewound : now;
        geometry->changed = moved ? now : geometry->changed;
    }
}

void geometry_block_glass(struct geometry *view, const struct geometry *geometry,
                          const struct scene *scene) {
    *view = *geometry;
    view->glass_blocks = true;
    find_blocking(view, scene);
}

float geometry_clearance(const struct geometry *geometry) {
    float largest = geometry->radius;
    for (int c = 0; c < 3; c++) {
        largest = fmaxf(largest, fabsf(geometry->bounds_min[c]));
        largest = fmaxf(largest, fabsf(geometry->bounds_max[c]));
    }
    return 1e-5F * largest;
}

uint32_t geometry_triangle_count(const struct geometry *geometry) {
    uint32_t indices = 0;
    for (int i = 0; i < geometry->part_count; i++)
        indices += geometry->parts[i].index_count;
    return indices / 3;
}
