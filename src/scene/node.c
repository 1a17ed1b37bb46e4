#include "scene/node.h"

#include "base/error.h"
#include "base/memory.h"
#include "scene/animation.h"

#include <assert.h>
#include <cglm/cglm.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct node node_new(void) {
    return (struct node){.parent = -1,
                         .mesh = -1,
                         .light = -1,
                         .camera = -1,
                         .skin = -1,
                         .metaballs = -1,
                         .rotation = {0, 0, 0, 1},
                         .scale = {1, 1, 1}};
}

/* A local transform; of a node with a matrix only that counts. */
struct trs {
    float translation[3], rotation[4], scale[3];
};

static void local_matrix(const struct node *node, const struct trs *trs, mat4 matrix) {
    if (node->has_matrix) {
        memcpy(matrix, node->matrix, sizeof node->matrix);
        return;
    }
    versor rotation;
    memcpy(rotation, trs->rotation, sizeof rotation);
    glm_quat_mat4(rotation, matrix);
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++)
            matrix[column][row] *= trs->scale[column];
    memcpy(matrix[3], trs->translation, sizeof trs->translation);
}

/* The local transforms of all nodes: as the file has them, then as clips move them. */
static struct trs *animate(const struct scene *scene, double time) {
    struct trs *locals = mem_alloc((size_t)scene->node_count, sizeof *locals);
    for (int i = 0; i < scene->node_count; i++) {
        const struct node *node = &scene->nodes[i];
        memcpy(locals[i].translation, node->translation, sizeof node->translation);
        memcpy(locals[i].rotation, node->rotation, sizeof node->rotation);
        memcpy(locals[i].scale, node->scale, sizeof node->scale);
    }
    const struct channel *channel;
    for (struct channel_place place = {0}; (channel = scene_next_channel(scene, &place));) {
        if (channel->path > CHANNEL_SCALE)
            continue;
        struct trs *local = &locals[channel->target];
        float *const fields[] = {local->translation, local->rotation, local->scale};
        channel_sample(channel, time, fields[channel->path]);
    }
    return locals;
}

void scene_node_worlds(const struct scene *scene, double time, float (*worlds)[16]) {
    struct trs *locals = animate(scene, time);
    for (int i = 0; i < scene->node_count; i++) {
        const struct node *node = &scene->nodes[i];
        mat4 world;
        local_matrix(node, &locals[i], world);
        if (node->parent >= 0) {
            assert(node->parent < i);
            mat4 parent;
            memcpy(parent, worlds[node->parent], sizeof parent);
            glm_mat4_mul(parent, world, world);
        }
        memcpy(worlds[i], world, sizeof world);
    }
    free(locals);
}

void scene_nodes_shown(const struct scene *scene, double time, bool *shown) {
    const struct channel *channel;
    for (int i = 0; i < scene->node_count; i++)
        shown[i] = !scene->nodes[i].dark;
    for (struct channel_place place = {0}; (channel = scene_next_channel(scene, &place));) {
        float value;
        if (channel->path != CHANNEL_VISIBLE)
            continue;
        channel_sample(channel, time, &value);
        shown[channel->target] = value >= .5F;
    }
    for (int i = 0; i < scene->node_count; i++)
        if (scene->nodes[i].parent >= 0)
            shown[i] &= shown[scene->nodes[i].parent];
}

bool node_check_worlds(const struct scene *scene, float (*worlds)[16]) {
    for (int i = 0; i < scene->node_count; i++)
        for (int k = 0; k < 16; k++)
            if (!isfinite(worlds[i][k]))
                return error_set("the node '%s' lies at infinity in the world",
                                 scene->nodes[i].name);
    return true;
}

void node_world(const struct scene *scene, int node, double time, float world[16]) {
    float(*worlds)[16] = mem_alloc((size_t)scene->node_count, sizeof *worlds);
    scene_node_worlds(scene, time, worlds);
    memcpy(world, worlds[node], sizeof worlds[node]);
    free(worlds);
}

/* The index into its array of what the node carries of that kind; -1 = nothing. */
static int node_carries(const struct node *node, enum node_kind kind) {
    switch (kind) {
    case NODE_MESH:
        return node->mesh;
    case NODE_LIGHT:
        return node->light;
    case NODE_CAMERA:
        return node->camera;
    }
    return -1;
}

int node_count_carrying(const struct scene *scene, enum node_kind kind) {
    int count = 0;
    for (int i = 0; i < scene->node_count; i++)
        count += node_carries(&scene->nodes[i], kind) >= 0;
    return count;
}

int node_carrying(const struct scene *scene, enum node_kind kind, int n) {
    int node = 0;
    for (; node < scene->node_count; node++)
        if (node_carries(&scene->nodes[node], kind) >= 0 && n-- == 0)
            break;
    assert(node < scene->node_count);
    return node;
}

/* The name of the light, camera or mesh on the node. */
static const char *carried_name(const struct scene *scene, enum node_kind kind, int node) {
    int index = node_carries(&scene->nodes[node], kind);
    switch (kind) {
    case NODE_LIGHT:
        return scene->lights[index].name;
    case NODE_CAMERA:
        return scene->cameras[index].name;
    case NODE_MESH:
        return scene->meshes[index].name;
    }
    return "";
}

const char *node_shown_name(const struct scene *scene, enum node_kind kind, int node) {
    const char *name = scene->nodes[node].name;
    return *name ? name : carried_name(scene, kind, node);
}

const char *node_name_carrying(const struct scene *scene, enum node_kind kind, int n) {
    return node_shown_name(scene, kind, node_carrying(scene, kind, n));
}

static bool matches(const struct scene *scene, enum node_kind kind, int node, const char *text) {
    return strcmp(scene->nodes[node].name, text) == 0 ||
           strcmp(carried_name(scene, kind, node), text) == 0;
}

int node_find_carrying(const struct scene *scene, enum node_kind kind, const char *text) {
    static const char *const nouns[] = {"mesh", "light", "camera"};
    enum { MOST_LISTED = 20 };
    char list[MOST_LISTED * (SCENE_NAME_SIZE + 16)] = "", *end;
    long number = strtol(text, &end, 10);
    int n = 0;
    for (int node = 0; node < scene->node_count; node++) {
        if (node_carries(&scene->nodes[node], kind) < 0)
            continue;
        if (*text && (matches(scene, kind, node, text) || (!*end && number == n)))
            return n;
        n++;
    }
    for (int node = 0, listed = 0; node < scene->node_count && listed < MOST_LISTED; node++) {
        if (node_carries(&scene->nodes[node], kind) < 0)
            continue;
        const char *name = node_shown_name(scene, kind, node);
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, " %d%s%s", listed++, *name ? "=" : "", name);
    }
    error_set("no %s '%s' (there is:%s)", nouns[kind], text, *list ? list : " none");
    return -1;
}

/* Writes the vector at unit length; false where it has none. */
static bool unit(const double v[3], float out[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 1e-30) || !isfinite(length))
        return false;
    for (int c = 0; c < 3; c++)
        out[c] = (float)(v[c] / length);
    return true;
}

static void cross(const float a[3], const float b[3], double out[3]) {
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        out[c] = (double)a[d] * b[e] - (double)a[e] * b[d];
    }
}

void node_frame(const float world[16], float right[3], float up[3], float forward[3]) {
    double axis[3] = {-world[8], -world[9], -world[10]};
    if (!unit(axis, forward))
        memcpy(forward, (float[3]){0, 0, -1}, sizeof(float[3]));
    cross(forward, &world[4], axis);
    if (!unit(axis, right)) {
        /* No usable +Y: any direction across will do. */
        float other[3] = {0, 0, 0};
        other[fabsf(forward[1]) < .9F ? 1 : 0] = 1;
        cross(forward, other, axis);
        unit(axis, right);
    }
    cross(right, forward, axis);
    unit(axis, up);
}
