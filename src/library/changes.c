/* Changes to parts of a scene. They are checked when they are made, and followed by the scene's
 * next user. */
#include "base/error.h"
#include "base/memory.h"
#include "library/arrays.h"
#include "library/desc.h"
#include "library/door.h"
#include "library/scene.h"
#include "scene/material.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- the lists of before ---------------------------------------------------------------------- */

static void copy_lists(const struct scene *from, struct scene *to) {
    to->nodes = mem_copy(from->nodes, (size_t)from->node_count, sizeof *from->nodes);
    to->lights = mem_copy(from->lights, (size_t)from->light_count, sizeof *from->lights);
    to->cameras = mem_copy(from->cameras, (size_t)from->camera_count, sizeof *from->cameras);
    to->node_count = from->node_count;
    to->light_count = from->light_count;
    to->camera_count = from->camera_count;
}

void original_keep(struct original *original, const struct scene *scene) {
    const struct environment *sky = scene->environment;
    copy_lists(scene, &original->lists);
    original->turn = sky ? sky->turn : 0;
    original->strength = sky ? sky->strength : 1;
}

void original_free(struct original *original) {
    mem_free(original->lists.nodes, original->lists.lights, original->lists.cameras);
}

/* --- following -------------------------------------------------------------------------------- */

/* Makes the scene ready as its opening did. Users have its triangles of before. */
static bool follow(struct manylight_scene *scene) {
    struct scene changed = scene->stage.scene;
    struct stage stage;
    mem_free(changed.nodes, changed.lights, changed.cameras, changed.surfaces);
    copy_lists(&scene->original.lists, &changed);
    changed.surfaces = NULL;
    changed.surface_count = 0;
    memset(changed.origin, 0, sizeof changed.origin);
    const struct stage_desc desc = {.path = changed.path,
                                    .filled = &changed,
                                    .light = scene->light,
                                    .punctual_scale = changed.punctual_given};
    scene->is_marked = false;
    emitters_free(&scene->stage.emitters);
    scene->is_broken = !stage_init(&stage, &desc);
    if (!scene->is_lent)
        geometry_free(&scene->stage.geometry);
    scene->stage = stage;
    scene->is_lent = false;
    scene->edition++;
    if (scene->is_reshaped)
        scene->reshaped = scene->edition;
    scene->is_reshaped = false;
    if (!scene->is_broken)
        scene_describe(scene);
    return !scene->is_broken;
}

static bool check(const struct manylight_scene *scene) {
    return !scene->is_broken ||
           error_set("the scene ended with a change that failed: open it again");
}

bool scene_use(const struct manylight_scene *shared) {
    struct manylight_scene *scene = (struct manylight_scene *)(uintptr_t)shared;
    pthread_mutex_lock(&scene->mutex);
    bool ok = (!scene->is_marked || follow(scene)) && check(scene);
    scene->calls++;
    pthread_mutex_unlock(&scene->mutex);
    return ok || door_blame(MANYLIGHT_BAD_SCENE);
}

void scene_leave(const struct manylight_scene *shared) {
    struct manylight_scene *scene = (struct manylight_scene *)(uintptr_t)shared;
    pthread_mutex_lock(&scene->mutex);
    scene->calls--;
    pthread_mutex_unlock(&scene->mutex);
}

/* --- changes ---------------------------------------------------------------------------------- */

/* One change. id: from 1 on, as in the layers of ids. */
struct change {
    struct manylight_scene *scene;
    uint32_t id;
    const void *to;
    const char *path;
    float turn, strength;
};

/* Tells renderers to start anew. */
static bool reshape(const struct change *change) {
    return change->scene->is_reshaped = true;
}

static bool refuse_id(const char *part, uint32_t id, int last) {
    error_set("%s %u: the scene has 1 to %d", part, id, last);
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool may_change(const struct manylight_scene *scene) {
    if (scene->calls > 0) {
        error_set("the scene is in use by another call: change it between calls");
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    return check(scene) &&
           (scene->stage.scene.clip_count == 0 ||
            error_set("the scene has clips: only parts of scenes without clips can change"));
}

/* Other calls are not waited for: a callback of theirs may be the caller. */
static enum manylight_status change(bool (*make)(const struct change *change),
                                    const struct change *change) {
    struct manylight_scene *scene = change->scene;
    struct door door;
    door_enter(&door);
    pthread_mutex_lock(&scene->mutex);
    bool ok = may_change(scene) && make(change);
    scene->is_marked |= ok;
    pthread_mutex_unlock(&scene->mutex);
    return door_leave(&door, ok, MANYLIGHT_BAD_SCENE);
}

static bool set_node(const struct change *change) {
    const struct scene *lists = &change->scene->original.lists;
    const double *matrix = change->to;
    if (change->id - 1 >= (uint32_t)lists->node_count)
        return refuse_id("node", change->id, lists->node_count);
    struct node node = lists->nodes[change->id - 1];
    bool is_affine =
        matrix && matrix[12] == 0 && matrix[13] == 0 && matrix[14] == 0 && matrix[15] == 1;
    node.has_matrix = true;
    for (int i = 0; is_affine && i < 16; i++) {
        node.matrix[i % 4 * 4 + i / 4] = (float)matrix[i];
        is_affine = isfinite(node.matrix[i % 4 * 4 + i / 4]);
    }
    if (!is_affine)
        return error_set("node %u: its matrix is not finite, or its last row not 0 0 0 1",
                         change->id);
    lists->nodes[change->id - 1] = node;
    return true;
}

enum manylight_status manylight_scene_set_node(struct manylight_scene *scene, uint32_t id,
                                               const double matrix[16]) {
    return change(set_node, &(struct change){.scene = scene, .id = id, .to = matrix});
}

/* Meshes of files may have parts and attributes that arrays lack. */
static bool is_simple(const struct mesh *mesh) {
    const struct primitive *primitive = mesh->primitives;
    return mesh->primitive_count <= 1 && mesh->target_count == 0 &&
           (mesh->primitive_count == 0 || (!primitive->joints && !primitive->uv[1]));
}

static bool set_mesh(const struct change *change) {
    struct scene *scene = &change->scene->stage.scene;
    struct manylight_mesh to;
    if (change->id - 1 >= (uint32_t)scene->mesh_count)
        return refuse_id("mesh", change->id, scene->mesh_count);
    struct mesh *mesh = &scene->meshes[change->id - 1];
    if (!desc_take(&to, sizeof to, change->to, "manylight_mesh"))
        return false;
    if (!is_simple(mesh))
        return error_set("mesh %u: it has several materials, joints, morph targets or mappings",
                         change->id);
    int material = mesh->primitives->material;
    if (to.material != 0 && to.material != material)
        return error_set("mesh %u: material: it keeps its material, %d", change->id, material);
    bool has_picture =
        mesh->primitives->uv[0] || scene->materials[material].base_color_texture >= 0;
    return arrays_set_mesh(mesh, &to, material, has_picture) || error_prefix("mesh %u", change->id);
}

enum manylight_status manylight_scene_set_mesh(struct manylight_scene *scene, uint32_t id,
                                               const struct manylight_mesh *mesh) {
    return change(set_mesh, &(struct change){.scene = scene, .id = id, .to = mesh});
}

/* Renderers follow other colours without starting anew, as long as no light passes. */
static bool differ_by_color(const struct material *a, const struct material *b) {
    struct material colored = *a;
    memcpy(colored.base_color, b->base_color, 3 * sizeof *b->base_color);
    return memcmp(&colored, b, sizeof colored) == 0 && !material_is_pane(a);
}

static bool set_material(const struct change *change) {
    struct scene *scene = &change->scene->stage.scene;
    struct manylight_material to;
    if (change->id - 1 >= (uint32_t)scene->material_count)
        return refuse_id("material", change->id, scene->material_count);
    if (!desc_take(&to, sizeof to, change->to, "manylight_material"))
        return false;
    struct material *material = &scene->materials[change->id - 1], before = *material;
    if ((to.picture && !error_set("picture: a material keeps its pictures")) ||
        !arrays_set_material(material, &to))
        return error_prefix("material %u", change->id);
    return differ_by_color(&before, material) || reshape(change);
}

enum manylight_status manylight_scene_set_material(struct manylight_scene *scene, uint32_t id,
                                                   const struct manylight_material *material) {
    return change(set_material, &(struct change){.scene = scene, .id = id, .to = material});
}

static bool set_sky(const struct change *change) {
    struct original *original = &change->scene->original;
    struct environment **sky = &change->scene->stage.scene.environment;
    if (!desc_check("turn", (double)change->turn, -INFINITY, INFINITY) ||
        !(change->strength == 0 || desc_check("strength", (double)change->strength, 1e-9, 1e9)) ||
        (change->path && !environment_follow(sky, &(struct environment_desc){change->path, 0, 1})))
        return false;
    if (!*sky)
        return error_set("there is no environment to be turned or made stronger");
    if (change->path) {
        original->turn = 0;
        original->strength = 1;
        reshape(change);
    }
    (*sky)->turn = original->turn + change->turn;
    (*sky)->strength = original->strength * (change->strength == 0 ? 1 : change->strength);
    return true;
}

enum manylight_status manylight_scene_set_sky(struct manylight_scene *scene, const char *path,
                                              float turn, float strength) {
    return change(set_sky, &(struct change){
                               .scene = scene, .path = path, .turn = turn, .strength = strength});
}
