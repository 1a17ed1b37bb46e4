#include "scene/scene.h"

#include "base/error.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "scene/animated.h"
#include "scene/animation.h"
#include "scene/gltf/gltf.h"
#include "scene/lights/emissive.h"
#include "scene/lights/environment.h"
#include "scene/lights/slide.h"
#include "scene/mesh/primitive.h"
#include "scene/node.h"

#include <stdlib.h>

static bool check_worlds(const struct scene *scene) {
    float(*worlds)[16] = mem_alloc((size_t)scene->node_count, sizeof *worlds);
    scene_node_worlds(scene, 0, worlds);
    bool good = node_check_worlds(scene, worlds) || error_prefix("%s", scene->path);
    free(worlds);
    return good;
}

static void add_lights(struct scene *scene) {
    animated_keep_materials(scene);
    emissive_add_lights(scene);
    animated_follow_materials(scene);
}

bool scene_load(struct scene *scene, const char *path) {
    return scene_load_choice(scene, path, &(struct scene_choice){0});
}

static bool finish(struct scene *scene, bool is_filled) {
    if (is_filled)
        add_lights(scene);
    if (is_filled && check_worlds(scene))
        return true;
    scene_free(scene);
    return false;
}

bool scene_load_choice(struct scene *scene, const char *path, const struct scene_choice *choice) {
    *scene = (struct scene){0};
    return finish(scene, gltf_load(scene, path, NULL, choice));
}

bool scene_take(struct scene *scene, struct scene *filled) {
    *scene = *filled;
    *filled = (struct scene){0};
    return finish(scene, true);
}

bool scene_check_output(const struct scene *scene, const char *path) {
    const struct environment *environment = scene->environment;
    bool ok = output_file_is_not(path, scene->path) &&
              (!environment || output_file_is_not(path, environment->path));
    for (int i = 0; ok && i < scene->file_count; i++)
        ok = output_file_is_not(path, scene->files[i]);
    return ok;
}

void scene_free(struct scene *scene) {
    for (int i = 0; i < scene->mesh_count; i++) {
        for (int p = 0; p < scene->meshes[i].primitive_count; p++)
            primitive_free(&scene->meshes[i].primitives[p], scene->meshes[i].target_count);
        mem_free(scene->meshes[i].primitives, scene->meshes[i].weights);
    }
    for (int i = 0; i < scene->texture_count; i++)
        bitmap_free(&scene->textures[i].bitmap);
    for (int i = 0; i < scene->node_count; i++)
        free(scene->nodes[i].weights);
    for (int i = 0; i < scene->skin_count; i++) {
        mem_free(scene->skins[i].joints, scene->skins[i].inverse_bind);
    }
    for (int i = 0; i < scene->clip_count; i++)
        clip_free(&scene->clips[i]);
    for (int i = 0; i < scene->file_count; i++)
        free(scene->files[i]);
    free(scene->files);
    for (int i = 0; i < scene->slide_count; i++)
        slide_free(&scene->slides[i]);
    free(scene->slides);
    choice_free(&scene->scenes);
    choice_free(&scene->variants);
    environment_free(scene->environment);
    mem_free(scene->path, scene->skins, scene->metaballs, scene->clips, scene->playing,
             scene->nodes, scene->meshes, scene->materials, scene->still_materials, scene->textures,
             scene->lights, scene->surfaces, scene->cameras);
    *scene = (struct scene){0};
}
