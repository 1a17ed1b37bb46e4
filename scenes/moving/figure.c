#include "moving/figure.h"

#include "shapes/decimate.h"
#include "shapes/shapes.h"
#include "shapes/soft_body.h"

#include "base/memory.h"

#include <assert.h>
#include <cglm/cglm.h>
#include <float.h>
#include <stdlib.h>

enum { KEYS_A_CYCLE = 8 };

static void shape(const struct figure *figure, struct surface *surface) {
    static const struct soft_frame frame = {
        {0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    struct soft_body *body = mem_alloc(1, sizeof *body);
    struct marching_cubes cubes;
    for (int i = 0; i < figure->bone_count; i++) {
        const struct figure_bone *from = &figure->bones[i];
        struct bone bone = {.from_radius = from->from_radius,
                            .to_radius = from->to_radius,
                            .blend = i ? from->blend : 0.0f};
        glm_vec3_copy((float *)from->from, bone.from);
        glm_vec3_copy((float *)from->to, bone.to);
        soft_add_bone(body, &frame, &bone, SOFT_ONE);
    }
    struct implicit implicit = soft_implicit(body);
    struct marching_grid grid = soft_grid(body, figure->cell);
    marching_cubes_init(&cubes);
    marching_cubes_polygonise(&cubes, &implicit, &grid, surface);
    decimate(surface, (uint32_t)figure->faces);
    smooth_normals(surface, 0);
    marching_cubes_free(&cubes);
    free(body);
}

/* --- the skin --------------------------------------------------------------------------------- */

/* How near a point is to a bone: its distance from the cone's surface, at least a little. */
static float distance(const struct figure_bone *bone, const float point[3]) {
    vec3 along, offset;
    glm_vec3_sub((float *)bone->to, (float *)bone->from, along);
    glm_vec3_sub((float *)point, (float *)bone->from, offset);
    float t = glm_clamp(glm_vec3_dot(offset, along) / glm_vec3_norm2(along), 0.0f, 1.0f);
    glm_vec3_muladds(along, -t, offset);
    float radius = glm_lerp(bone->from_radius, bone->to_radius, t);
    return fmaxf(glm_vec3_norm(offset) - radius, 0.0f) + 0.1f * radius;
}

/* The four nearest bones, by the inverse fourth power of their distances. */
static void weigh(const struct figure *figure, const float point[3], uint8_t joints[4],
                  float weights[4]) {
    float nearest[4] = {FLT_MAX, FLT_MAX, FLT_MAX, FLT_MAX}, sum = 0.0f;
    for (int i = 0; i < figure->bone_count; i++) {
        float d = distance(&figure->bones[i], point);
        for (int j = 0; j < 4; j++)
            if (d < nearest[j]) {
                for (int k = 3; k > j; k--) {
                    nearest[k] = nearest[k - 1];
                    joints[k] = joints[k - 1];
                }
                nearest[j] = d;
                joints[j] = (uint8_t)i;
                break;
            }
    }
    for (int j = 0; j < 4; j++)
        sum += weights[j] = powf(nearest[0] / nearest[j], 4.0f);
    for (int j = 0; j < 4; j++)
        weights[j] /= sum;
}

/* --- the motion ------------------------------------------------------------------------------- */

static void turn_about(char axis, float degrees, float quaternion[4]) {
    vec3 about = {axis == 'x', axis == 'y', axis == 'z'};
    glm_quatv(quaternion, glm_rad(degrees), about);
}

static void swing(struct glb *glb, int node, const struct figure_bone *bone, float cycle,
                  float seconds) {
    int keys = (int)ceilf(seconds / cycle * KEYS_A_CYCLE) + 1;
    float *times = mem_alloc((size_t)keys, sizeof *times);
    float(*turns)[4] = mem_alloc((size_t)keys, sizeof *turns);
    for (int k = 0; k < keys; k++) {
        float cycles = (float)k / KEYS_A_CYCLE;
        times[k] = cycles * cycle;
        turn_about(bone->axis,
                   bone->rest + bone->swing * sinf(2.0f * GLM_PIf * (cycles - bone->phase)),
                   turns[k]);
    }
    glb_animate_rotation(glb, node, keys, times, (const float(*)[4])turns);
    free(times);
    free(turns);
}

/* The node that everything hangs on goes along the path. */
static void walk(struct glb *glb, int node, const struct figure_path *path) {
    float(*turns)[4] = mem_alloc((size_t)path->keys, sizeof *turns);
    for (int k = 0; k < path->keys; k++)
        turn_about('y', path->headings[k], turns[k]);
    glb_animate_translation(glb, node, path->keys, path->times, path->places);
    glb_animate_rotation(glb, node, path->keys, path->times, (const float(*)[4])turns);
    free(turns);
}

static void scale_figure(struct figure_bone bones[FIGURE_BONES_MAX], const struct figure *figure,
                         float scale) {
    for (int i = 0; i < figure->bone_count; i++) {
        bones[i] = figure->bones[i];
        glm_vec3_scale(bones[i].from, scale, bones[i].from);
        glm_vec3_scale(bones[i].to, scale, bones[i].to);
        bones[i].from_radius *= scale;
        bones[i].to_radius *= scale;
        bones[i].blend *= scale;
    }
}

void add_figure(struct glb *glb, const struct figure *unscaled, int material, float scale,
                const struct figure_path *path, float seconds) {
    struct figure_bone bones[FIGURE_BONES_MAX];
    struct figure figure = *unscaled;
    assert(figure.bone_count <= FIGURE_BONES_MAX);
    scale_figure(bones, unscaled, scale);
    figure.bones = bones;
    figure.cell *= scale;
    figure.cycle *= sqrtf(scale);

    struct surface surface = {0};
    shape(&figure, &surface);
    int joints[FIGURE_BONES_MAX];
    float rest[FIGURE_BONES_MAX][3];
    int root = glb_add_joint(glb, figure.name, -1, path->places[0]);
    walk(glb, root, path);
    for (int i = 0; i < figure.bone_count; i++) {
        int parent = bones[i].parent;
        vec3 offset;
        glm_vec3_copy(bones[i].from, rest[i]);
        glm_vec3_copy(rest[i], offset);
        if (parent >= 0)
            glm_vec3_sub(rest[i], rest[parent], offset);
        joints[i] = glb_add_joint(glb, bones[i].name, parent >= 0 ? joints[parent] : root, offset);
        swing(glb, joints[i], &bones[i], figure.cycle, seconds);
    }
    uint8_t(*vertex_joints)[4] = mem_alloc(surface.vertex_count, sizeof *vertex_joints);
    float(*weights)[4] = mem_alloc(surface.vertex_count, sizeof *weights);
    for (uint32_t i = 0; i < surface.vertex_count; i++)
        weigh(&figure, surface.position[i], vertex_joints[i], weights[i]);
    glb_add_skinned_mesh(glb, figure.name, &surface, material,
                         &(struct glb_skin){.joints = joints,
                                            .rest = (const float(*)[3])rest,
                                            .joint_count = figure.bone_count,
                                            .vertex_joints = (const uint8_t(*)[4])vertex_joints,
                                            .vertex_weights = (const float(*)[4])weights});
    free(vertex_joints);
    free(weights);
    surface_free(&surface);
}
