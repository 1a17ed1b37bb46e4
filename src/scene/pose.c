#include "scene/pose.h"

#include "base/error.h"
#include "base/memory.h"
#include "scene/animation.h"
#include "scene/mesh/primitive.h"
#include "scene/node.h"

#include <cglm/cglm.h>
#include <stdlib.h>
#include <string.h>

/* Farther out, squared lengths leave the range of floats. */
static const float max_coordinate = 1e15F;

static int node_targets(const struct scene *scene, int node) {
    int mesh = scene->nodes[node].mesh;
    return mesh >= 0 ? scene->meshes[mesh].target_count : 0;
}

void pose_init(struct pose *pose, const struct scene *scene) {
    *pose = (struct pose){0};
    pose->worlds = mem_alloc((size_t)scene->node_count, sizeof *pose->worlds);
    pose->shown = mem_alloc((size_t)scene->node_count, sizeof *pose->shown);
    pose->first_weight = mem_alloc((size_t)scene->node_count, sizeof *pose->first_weight);
    for (int i = 0; i < scene->node_count; i++) {
        pose->first_weight[i] = pose->weight_count;
        pose->weight_count += node_targets(scene, i);
    }
    pose->weights = mem_alloc((size_t)pose->weight_count, sizeof *pose->weights);
}

void pose_free(struct pose *pose) {
    mem_free(pose->worlds, pose->shown, pose->weights, pose->first_weight);
    *pose = (struct pose){0};
}

/* As the file has them, then as clips move them. */
static void set_weights(struct pose *pose, const struct scene *scene) {
    for (int i = 0; i < scene->node_count; i++) {
        const struct node *node = &scene->nodes[i];
        if (node_targets(scene, i))
            memcpy(pose->weights + pose->first_weight[i],
                   node->weights ? node->weights : scene->meshes[node->mesh].weights,
                   (size_t)node_targets(scene, i) * sizeof *pose->weights);
    }
    const struct channel *channel;
    for (struct channel_place place = {0}; (channel = scene_next_channel(scene, &place));)
        if (channel->path == CHANNEL_WEIGHTS)
            channel_sample(channel, pose->time,
                           pose->weights + pose->first_weight[channel->target] + channel->offset);
}

bool pose_set(struct pose *pose, const struct scene *scene, double time) {
    pose->time = time;
    scene_node_worlds(scene, time, pose->worlds);
    scene_nodes_shown(scene, time, pose->shown);
    set_weights(pose, scene);
    return node_check_worlds(scene, pose->worlds);
}

static const struct skin *node_skin(const struct scene *scene, int node) {
    int skin = scene->nodes[node].skin;
    return skin >= 0 ? &scene->skins[skin] : NULL;
}

bool pose_differs(const struct pose *a, const struct pose *b, const struct scene *scene, int node) {
    const struct skin *skin = node_skin(scene, node);
    size_t first = (size_t)a->first_weight[node], count = (size_t)node_targets(scene, node);
    if (memcmp(a->weights + first, b->weights + first, count * sizeof *a->weights) != 0 ||
        memcmp(a->worlds[node], b->worlds[node], sizeof *a->worlds) != 0 ||
        a->shown[node] != b->shown[node] ||
        (scene->nodes[node].metaballs >= 0 && a->time != b->time))
        return true;
    for (int i = 0; skin && i < skin->joint_count; i++)
        if (memcmp(a->worlds[skin->joints[i]], b->worlds[skin->joints[i]], sizeof *a->worlds) != 0)
            return true;
    return false;
}

/* The cofactors of a matrix's upper left 3x3, column by column. They are the inverse transpose
 * times the determinant, but exist for flat scales too. */
static void cofactors(const float matrix[16], double out[3][3]) {
    for (int column = 0; column < 3; column++) {
        const float *a = &matrix[(column + 1) % 3 * 4], *b = &matrix[(column + 2) % 3 * 4];
        for (int row = 0; row < 3; row++) {
            int d = (row + 1) % 3, e = (row + 2) % 3;
            out[column][row] = (double)a[d] * b[e] - (double)a[e] * b[d];
        }
    }
}

/* The determinant's sign is negative. */
static bool mirrors(const float matrix[16], double cofactor[3][3]) {
    return matrix[0] * cofactor[0][0] + matrix[1] * cofactor[0][1] + matrix[2] * cofactor[0][2] < 0;
}

static void joint_matrix(const struct pose *pose, const struct skin *skin, int joint,
                         float out[16]) {
    mat4 world, inverse, product;
    memcpy(world, pose->worlds[skin->joints[joint]], sizeof world);
    memcpy(inverse, skin->inverse_bind[joint], sizeof inverse);
    glm_mat4_mul(world, inverse, product);
    memcpy(out, product, sizeof product);
}

bool pose_mirrors(const struct pose *pose, const struct scene *scene, int node) {
    const struct skin *skin = node_skin(scene, node);
    float matrix[16];
    double cofactor[3][3];
    if (skin)
        joint_matrix(pose, skin, 0, matrix);
    else
        memcpy(matrix, pose->worlds[node], sizeof matrix);
    cofactors(matrix, cofactor);
    return mirrors(matrix, cofactor);
}

/* What takes a vertex to its place. */
struct placer {
    float matrix[16];
    double cofactor[3][3], sign;
};

static void set_matrix(struct placer *placer) {
    cofactors(placer->matrix, placer->cofactor);
    placer->sign = mirrors(placer->matrix, placer->cofactor) ? -1 : 1;
}

/* Normals go by the inverse transpose, whose direction the cofactors have, but for its sign. */
static void place_normal(const struct placer *placer, const float normal[3], float out[3]) {
    double n[3], length = 0;
    for (int c = 0; c < 3; c++) {
        n[c] = 0;
        for (int column = 0; column < 3; column++)
            n[c] += placer->sign * placer->cofactor[column][c] * normal[column];
        length += n[c] * n[c];
    }
    length = sqrt(length);
    for (int c = 0; c < 3; c++)
        out[c] = length > 0 ? (float)(n[c] / length) : normal[c];
}

static bool place(const struct placer *placer, const float position[3], const float normal[3],
                  float out_position[3], float out_normal[3]) {
    const float *m = placer->matrix;
    for (int c = 0; c < 3; c++) {
        out_position[c] =
            m[c] * position[0] + m[4 + c] * position[1] + m[8 + c] * position[2] + m[12 + c];
        if (!(fabsf(out_position[c]) <= max_coordinate))
            return error_set("a vertex lies %g m from the world's origin", (double)out_position[c]);
    }
    place_normal(placer, normal, out_normal);
    return true;
}

bool pose_rigid(const float world[16], uint32_t count, float (*from_position)[3],
                float (*from_normal)[3], float (*position)[3], float (*normal)[3]) {
    struct placer placer;
    memcpy(placer.matrix, world, sizeof placer.matrix);
    set_matrix(&placer);
    for (uint32_t i = 0; i < count; i++)
        if (!place(&placer, from_position[i], from_normal[i], position[i], normal[i]))
            return false;
    return true;
}

/* Adds the displacements at their weights. */
static void morph(const struct primitive *primitive, int target_count, const float *weights,
                  size_t vertex, float position[3], float normal[3]) {
    memcpy(position, primitive->position[vertex], sizeof *primitive->position);
    memcpy(normal, primitive->normal[vertex], sizeof *primitive->normal);
    for (int t = 0; primitive->targets && t < target_count; t++) {
        const struct morph_target *target = &primitive->targets[t];
        for (int c = 0; c < 3; c++) {
            position[c] += target->position ? weights[t] * target->position[vertex][c] : 0;
            normal[c] += target->normal ? weights[t] * target->normal[vertex][c] : 0;
        }
    }
}

/* The weighted mean of the joints' matrices. */
static void blend(struct placer *placer, float (*joints)[16], const uint16_t joint[4],
                  const float weights[4]) {
    for (int k = 0; k < 16; k++) {
        placer->matrix[k] = 0;
        for (int j = 0; j < 4; j++)
            placer->matrix[k] += weights[j] * joints[joint[j]][k];
    }
    set_matrix(placer);
}

/* All joints' matrices; NULL where the primitive follows none. */
static void *joint_matrices(const struct pose *pose, const struct skin *skin,
                            const struct primitive *primitive) {
    if (!skin || !primitive->joints)
        return NULL;
    float(*joints)[16] = mem_alloc((size_t)skin->joint_count, sizeof *joints);
    for (int i = 0; i < skin->joint_count; i++)
        joint_matrix(pose, skin, i, joints[i]);
    return joints;
}

bool pose_vertices(const struct pose *pose, const struct scene *scene, int node,
                   const struct primitive *primitive, float (*position)[3], float (*normal)[3]) {
    uint32_t count = (uint32_t)primitive->vertex_count;
    const float *weights = pose->weights + pose->first_weight[node];
    int target_count = node_targets(scene, node);
    float(*joints)[16] = joint_matrices(pose, node_skin(scene, node), primitive);
    if (!joints && !primitive->targets)
        return pose_rigid(pose->worlds[node], count, primitive->position, primitive->normal,
                          position, normal);
    struct placer placer;
    memcpy(placer.matrix, pose->worlds[node], sizeof placer.matrix);
    set_matrix(&placer);
    bool good = true;
    for (uint32_t i = 0; good && i < count; i++) {
        float morphed_position[3], morphed_normal[3];
        morph(primitive, target_count, weights, i, morphed_position, morphed_normal);
        if (joints)
            blend(&placer, joints, primitive->joints[i], primitive->weights[i]);
        good = place(&placer, morphed_position, morphed_normal, position[i], normal[i]);
    }
    free(joints);
    if (good && primitive->flat)
        primitive_flat_normals(position, normal, count);
    return good;
}
