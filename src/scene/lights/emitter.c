#include "scene/lights/emitter.h"

#include "base/memory.h"
#include "base/unit.h"
#include "scene/animated.h"
#include "scene/node.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const emitter_type_names[] = {"spot", "point", "directional", "area", NULL};

int emitter_node_count(const struct scene *scene) {
    return node_count_carrying(scene, NODE_LIGHT);
}

int emitter_find(const struct scene *scene, const char *text) {
    return node_find_carrying(scene, NODE_LIGHT, text);
}

struct emitters emitters_copy(const struct emitters *emitters) {
    size_t count = (size_t)emitters->count;
    struct emitters copy = *emitters;
    copy.items = mem_alloc(count, sizeof *copy.items);
    if (count) /* else there may be no items */
        memcpy(copy.items, emitters->items, count * sizeof *copy.items);
    return copy;
}

bool emitters_same(const struct emitters *a, const struct emitters *b) {
    return a->count == b->count && a->sky == b->sky &&
           (a->count == 0 || memcmp(a->items, b->items, (size_t)a->count * sizeof *a->items) == 0);
}

void emitters_free(struct emitters *emitters) {
    free(emitters->items);
    *emitters = (struct emitters){0};
}

/* Of a node's world, along its axes. */
static void scales_of(const struct scene_light *source, const float world[16], float scales[2]) {
    float along[3];
    for (int axis = 0; axis < 3; axis++)
        along[axis] = glm_vec3_norm((float *)&world[4 * axis]);
    bool each = source->scaling == LIGHT_SCALED_EACH_WAY;
    for (int axis = 0; axis < 2; axis++)
        scales[axis] = source->scaling == LIGHT_NOT_SCALED ? 1
                       : each                              ? along[axis]
                                                           : glm_vec3_max(along);
    /* A disk stays one, of the same area. */
    if (each && source->size[1] == 0)
        scales[0] = sqrtf(along[0] * along[1]);
}

static void set_size(struct emitter *emitter, const struct scene_light *source,
                     const float world[16]) {
    float scales[2];
    scales_of(source, world, scales);
    for (int axis = 0; axis < 2; axis++)
        emitter->size[axis] = source->size[axis] * scales[axis];
    if (source->type == EMITTER_AREA)
        glm_vec3_scale(emitter->intensity, (float)emitter_extent(emitter), emitter->intensity);
}

static void place(struct emitter *emitter, const struct scene *scene,
                  const struct scene_light *source, int n, const float world[16]) {
    *emitter = (struct emitter){.type = source->type,
                                .number = n,
                                .cos_inner = cosf(source->inner),
                                .cos_outer = cosf(source->outer),
                                .range = isfinite(source->range) ? source->range : 0,
                                .lamp = source->lamp,
                                .stands_in = source->stands_in,
                                .slide = source->slide ? &scene->slides[source->slide - 1] : NULL};
    memcpy(emitter->intensity, source->intensity, sizeof emitter->intensity);
    memcpy(emitter->position, &world[12], sizeof emitter->position);
    set_size(emitter, source, world);
    node_frame(world, emitter->right, emitter->up, emitter->direction);
}

struct emitter emitter_new(enum emitter_type type) {
    struct emitter emitter = {.type = type,
                              .number = -1,
                              .intensity = {1, 1, 1},
                              .cos_inner = 1,
                              .cos_outer = cosf(GLM_PI_4f)};
    emitter_aim(&emitter, (float[]){0, -1, 0});
    return emitter;
}

/* One that is not shown is black. */
static struct scene_light light_of(const struct scene *scene, int node, double time, bool shown) {
    struct scene_light light = animated_light(scene, scene->nodes[node].light, time);
    if (!shown)
        memset(light.intensity, 0, sizeof light.intensity);
    return light;
}

static bool *nodes_shown(const struct scene *scene, double time) {
    bool *shown = mem_alloc((size_t)scene->node_count, sizeof *shown);
    scene_nodes_shown(scene, time, shown);
    return shown;
}

void emitter_place(struct emitter *emitter, const struct scene *scene, int n, double time) {
    int node = node_carrying(scene, NODE_LIGHT, n);
    float world[16];
    node_world(scene, node, time, world);
    bool *shown = nodes_shown(scene, time);
    const struct scene_light light = light_of(scene, node, time, shown[node]);
    place(emitter, scene, &light, n, world);
    free(shown);
}

struct emitters emitters_place(const struct scene *scene, double time) {
    float(*worlds)[16] = mem_alloc((size_t)scene->node_count, sizeof *worlds);
    struct emitters all = {.items = mem_alloc((size_t)emitter_node_count(scene), sizeof *all.items),
                           .sky = scene->environment};
    bool *shown = nodes_shown(scene, time);
    scene_node_worlds(scene, time, worlds);
    for (int i = 0; i < scene->node_count; i++)
        if (scene->nodes[i].light >= 0) {
            const struct scene_light light = light_of(scene, i, time, shown[i]);
            place(&all.items[all.count], scene, &light, all.count, worlds[i]);
            all.count++;
        }
    mem_free(shown, worlds);
    return all;
}

void emitter_aim(struct emitter *emitter, const float direction[3]) {
    vec3 forward, right;
    vec3_unit_to((float *)direction, forward);
    /* Straight up and down, the frame turns about z. */
    vec3 aside = {0, fabsf(forward[1]) < .99F, fabsf(forward[1]) >= .99F};
    glm_vec3_cross(forward, aside, right);
    vec3_unit(right);
    glm_vec3_copy(forward, emitter->direction);
    glm_vec3_copy(right, emitter->right);
    glm_vec3_cross(right, forward, emitter->up);
}

/* --- shape ------------------------------------------------------------------------------------ */

enum emitter_shape emitter_shape(const struct emitter *emitter) {
    if (emitter->size[0] <= 0)
        return EMITTER_IS_POINT;
    if (emitter->type == EMITTER_DIRECTIONAL)
        return EMITTER_IS_CAP;
    if (emitter->type == EMITTER_POINT)
        return EMITTER_IS_SPHERE;
    return emitter->size[1] > 0 ? EMITTER_IS_RECTANGLE : EMITTER_IS_DISK;
}

double emitter_extent(const struct emitter *emitter) {
    double across = (double)emitter->size[0];
    switch (emitter_shape(emitter)) {
    case EMITTER_IS_POINT:
        break;
    case EMITTER_IS_RECTANGLE:
        return across * (double)emitter->size[1];
    case EMITTER_IS_DISK:
        return GLM_PI / 4 * across * across;
    case EMITTER_IS_SPHERE:
        return GLM_PI * across * across;
    case EMITTER_IS_CAP:
        return 2 * GLM_PI * (1 - cos(across / 2));
    }
    return 0;
}

/* Moves by so much along right, up and the direction. */
static void add_offset(const struct emitter *emitter, const float offset[3], float to[3]) {
    glm_vec3_muladds((float *)emitter->right, offset[0], to);
    glm_vec3_muladds((float *)emitter->up, offset[1], to);
    glm_vec3_muladds((float *)emitter->direction, offset[2], to);
}

/* The place's unit direction, even over the cap of the sphere that reaches from cos 1 to that. */
static void direction_of(const float place[2], float cos_rim, float direction[3]) {
    float height = place[0] * (1 - cos_rim), turn = 2 * GLM_PIf * place[1];
    float across = sqrtf(fmaxf(0, height * (2 - height)));
    glm_vec3_copy((vec3){across * cosf(turn), across * sinf(turn), 1 - height}, direction);
}

/* A bit of the sphere's surface: it has a quarter of the area that is seen. */
static void cut_sphere(struct emitter *piece, const float place[2]) {
    vec3 out, outwards = {0, 0, 0};
    direction_of(place, -1, out);
    add_offset(piece, out, outwards);
    glm_vec3_muladds(outwards, piece->size[0] / 2, piece->position);
    glm_vec3_scale(piece->intensity, 4, piece->intensity);
    piece->type = EMITTER_AREA;
    piece->cos_outer = 0;
    emitter_aim(piece, outwards);
}

/* All pieces of a sun together cross an area that faces its middle. */
static void cut_cap(struct emitter *piece, const float place[2]) {
    vec3 out, direction = {0, 0, 0};
    float cos_rim = cosf(piece->size[0] / 2);
    direction_of(place, cos_rim, out);
    add_offset(piece, out, direction);
    glm_vec3_scale(piece->intensity, 2 / (1 + cos_rim), piece->intensity);
    emitter_aim(piece, direction);
}

struct emitter emitter_piece(const struct emitter *emitter, const float place[2]) {
    struct emitter piece = *emitter;
    float radius = emitter->size[0] / 2 * sqrtf(place[0]), turn = 2 * GLM_PIf * place[1];
    switch (emitter_shape(emitter)) {
    case EMITTER_IS_POINT:
        return piece;
    case EMITTER_IS_RECTANGLE:
        add_offset(
            emitter,
            (float[]){(place[0] - .5F) * emitter->size[0], (place[1] - .5F) * emitter->size[1], 0},
            piece.position);
        break;
    case EMITTER_IS_DISK:
        add_offset(emitter, (float[]){radius * cosf(turn), radius * sinf(turn), 0}, piece.position);
        break;
    case EMITTER_IS_SPHERE:
        cut_sphere(&piece, place);
        break;
    case EMITTER_IS_CAP:
        cut_cap(&piece, place);
        break;
    }
    piece.size[0] = piece.size[1] = 0;
    return piece;
}

/* --- rays that come to it --------------------------------------------------------------------- */

/* Of a point, relative to the middle. */
static void in_frame(const struct emitter *emitter, const float offset[3], float local[3]) {
    local[0] = glm_vec3_dot((float *)offset, (float *)emitter->right);
    local[1] = glm_vec3_dot((float *)offset, (float *)emitter->up);
    local[2] = glm_vec3_dot((float *)offset, (float *)emitter->direction);
}

static float turn_of(const float local[3]) {
    float turn = atan2f(local[1], local[0]) / (2 * GLM_PIf);
    return turn < 0 ? turn + 1 : turn;
}

static bool meet_plane(const struct emitter *emitter, const float from[3], const float along[3],
                       float place[2], float *distance) {
    if (along[2] >= 0 || from[2] <= 0)
        return false;
    *distance = -from[2] / along[2];
    vec3 at;
    glm_vec3_copy((float *)from, at);
    glm_vec3_muladds((float *)along, *distance, at);
    if (emitter_shape(emitter) == EMITTER_IS_RECTANGLE) {
        for (int axis = 0; axis < 2; axis++)
            place[axis] = at[axis] / emitter->size[axis] + .5F;
        return place[0] >= 0 && place[0] < 1 && place[1] >= 0 && place[1] < 1;
    }
    place[0] = 4 * (at[0] * at[0] + at[1] * at[1]) / (emitter->size[0] * emitter->size[0]);
    place[1] = turn_of(at);
    return place[0] < 1;
}

static bool meet_sphere(const struct emitter *emitter, const float from[3], const float along[3],
                        float place[2], float *distance) {
    float radius = emitter->size[0] / 2, middle = -glm_vec3_dot((float *)from, (float *)along);
    vec3 nearest;
    glm_vec3_copy((float *)from, nearest);
    glm_vec3_muladds((float *)along, middle, nearest);
    float depth2 = radius * radius - glm_vec3_norm2(nearest);
    if (depth2 <= 0 || middle <= sqrtf(depth2))
        return false;
    *distance = middle - sqrtf(depth2);
    glm_vec3_muladds((float *)along, -sqrtf(depth2), nearest);
    place[0] = glm_clamp((1 - nearest[2] / radius) / 2, 0, 1);
    place[1] = turn_of(nearest);
    return true;
}

static bool meet_cap(const struct emitter *emitter, const float along[3], float place[2],
                     float *distance) {
    vec3 shines;
    glm_vec3_negate_to((float *)along, shines);
    *distance = INFINITY;
    place[0] = (1 - shines[2]) / (1 - cosf(emitter->size[0] / 2));
    place[1] = turn_of(shines);
    return place[0] < 1;
}

bool emitter_meet(const struct emitter *emitter, const float origin[3], const float direction[3],
                  float place[2], float *distance) {
    vec3 offset, from, along;
    glm_vec3_sub((float *)origin, (float *)emitter->position, offset);
    in_frame(emitter, offset, from);
    in_frame(emitter, direction, along);
    switch (emitter_shape(emitter)) {
    case EMITTER_IS_POINT:
        break;
    case EMITTER_IS_RECTANGLE:
    case EMITTER_IS_DISK:
        return meet_plane(emitter, from, along, place, distance);
    case EMITTER_IS_SPHERE:
        return meet_sphere(emitter, from, along, place, distance);
    case EMITTER_IS_CAP:
        return meet_cap(emitter, along, place, distance);
    }
    return false;
}

/* --- radiometry ------------------------------------------------------------------------------- */

float emitter_falloff_width(const struct emitter *emitter) {
    return fmaxf(.001F, emitter->cos_inner - emitter->cos_outer);
}

float emitter_cone(const struct emitter *emitter, float cos_angle) {
    if (emitter->type == EMITTER_AREA)
        return fmaxf(cos_angle, 0);
    if (emitter->type != EMITTER_SPOT)
        return 1;
    float width = emitter_falloff_width(emitter);
    float falloff = glm_clamp((cos_angle - emitter->cos_outer) / width, 0, 1);
    return falloff * falloff;
}

float emitter_in_range(const struct emitter *emitter, float distance) {
    if (emitter->range <= 0 || emitter->type == EMITTER_DIRECTIONAL)
        return 1;
    float part = distance / emitter->range, part2 = part * part;
    return fmaxf(1 - part2 * part2, 0);
}

double emitter_solid_angle(const struct emitter *emitter) {
    switch (emitter->type) {
    case EMITTER_SPOT:
        return 2 * GLM_PI * (1 - (double)emitter->cos_outer);
    case EMITTER_POINT:
        return 4 * GLM_PI;
    case EMITTER_AREA:
        return 2 * GLM_PI;
    case EMITTER_MANY:
    case EMITTER_DIRECTIONAL:
        break;
    }
    return 0;
}

/* The integral of the cone's falloff over all directions, sr. */
static double cone_integral(const struct emitter *emitter) {
    double outer = (double)emitter->cos_outer, width = (double)emitter_falloff_width(emitter);
    double full = fmin(outer + width, 1), rising = (full - outer) / width;
    return 2 * GLM_PI * (width * rising * rising * rising / 3 + 1 - full);
}

double emitter_flux(const struct emitter *emitter, float radius) {
    double mean = 0;
    for (int c = 0; c < 3; c++)
        mean += (double)emitter->intensity[c] / 3;
    switch (emitter->type) {
    case EMITTER_SPOT:
        return mean * cone_integral(emitter);
    case EMITTER_POINT:
        return mean * 4 * GLM_PI;
    case EMITTER_AREA:
        return mean * GLM_PI;
    case EMITTER_MANY:
        return mean;
    case EMITTER_DIRECTIONAL:
        break;
    }
    return mean * GLM_PI * (double)(radius * radius);
}
