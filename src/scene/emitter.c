#include "scene/emitter.h"

#include "base/memory.h"
#include "scene/node.h"

#include <cglm/cglm.h>
#include <stdlib.h>
#include <string.h>

int emitter_node_count(const struct scene *scene) {
    return node_count_carrying(scene, NODE_LIGHT);
}

int emitter_find(const struct scene *scene, const char *text) {
    return node_find_carrying(scene, NODE_LIGHT, text);
}

struct emitters emitters_copy(const struct emitters *emitters) {
    size_t count = (size_t)emitters->count;
    struct emitters copy = {mem_alloc(count, sizeof *copy.items), emitters->count};
    memcpy(copy.items, emitters->items, count * sizeof *copy.items);
    return copy;
}

bool emitters_same(const struct emitters *a, const struct emitters *b) {
    return a->count == b->count &&
           memcmp(a->items, b->items, (size_t)a->count * sizeof *a->items) == 0;
}

void emitters_free(struct emitters *emitters) {
    free(emitters->items);
    *emitters = (struct emitters){0};
}

void emitter_place(struct emitter *emitter, const struct scene *scene, int n, double time) {
    int node = node_carrying(scene, NODE_LIGHT, n);
    const struct scene_light *source = &scene->lights[scene->nodes[node].light];
    float world[16];
    node_world(scene, node, time, world);
    *emitter = (struct emitter){.type = source->type,
                                .number = n,
                                .cos_inner = cosf(source->inner),
                                .cos_outer = cosf(source->outer)};
    memcpy(emitter->intensity, source->intensity, sizeof emitter->intensity);
    memcpy(emitter->position, &world[12], sizeof emitter->position);
    node_frame(world, emitter->right, emitter->up, emitter->direction);
}

void emitter_aim(struct emitter *emitter, const float direction[3]) {
    vec3 forward, right;
    glm_vec3_normalize_to((float *)direction, forward);
    /* Straight up and down, the frame turns about z. */
    vec3 aside = {0, fabsf(forward[1]) < .99F, fabsf(forward[1]) >= .99F};
    glm_vec3_cross(forward, aside, right);
    glm_vec3_normalize(right);
    glm_vec3_copy(forward, emitter->direction);
    glm_vec3_copy(right, emitter->right);
    glm_vec3_cross(right, forward, emitter->up);
}

/* In the cosine of the angle to the axis: how far it is from dark to full light. */
static float falloff_width(const struct emitter *emitter) {
    return fmaxf(.001F, emitter->cos_inner - emitter->cos_outer);
}

float emitter_cone(const struct emitter *emitter, float cos_angle) {
    if (emitter->type != EMITTER_SPOT)
        return 1;
    float width = falloff_width(emitter);
    float falloff = glm_clamp((cos_angle - emitter->cos_outer) / width, 0, 1);
    return falloff * falloff;
}

double emitter_solid_angle(const struct emitter *emitter) {
    switch (emitter->type) {
    case EMITTER_SPOT:
        return 2 * GLM_PI * (1 - (double)emitter->cos_outer);
    case EMITTER_POINT:
        return 4 * GLM_PI;
    case EMITTER_DIRECTIONAL:
        break;
    }
    return 0;
}

/* The integral of the cone's falloff over all directions, sr. */
static double cone_integral(const struct emitter *emitter) {
    double outer = (double)emitter->cos_outer, width = (double)falloff_width(emitter);
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
    case EMITTER_DIRECTIONAL:
        break;
    }
    return mean * GLM_PI * (double)(radius * radius);
}
