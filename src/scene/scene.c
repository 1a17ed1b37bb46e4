#include "scene/scene.h"

#include "base/error.h"
#include "base/memory.h"
#include "scene/framing.h"
#include "scene/gltf.h"
#include "scene/primitive.h"

#include <math.h>
#include <stdlib.h>

/* Finite nodes may multiply up to infinite ones. */
static bool check_worlds(const struct scene *scene) {
    float(*worlds)[16] = mem_alloc((size_t)scene->node_count, sizeof *worlds);
    scene_node_worlds(scene, 0, worlds);
    bool good = true;
    for (int i = 0; good && i < scene->node_count; i++)
        for (int k = 0; good && k < 16; k++)
            if (!isfinite(worlds[i][k]))
                good = error_set("%s: the node '%s' lies at infinity in the world", scene->path,
                                 scene->nodes[i].name);
    free(worlds);
    return good;
}

bool scene_load(struct scene *scene, const char *path) {
    *scene = (struct scene){0};
    if (gltf_load(scene, path) && check_worlds(scene) && scene_frame(scene))
        return true;
    scene_free(scene);
    return false;
}

void scene_free(struct scene *scene) {
    for (int i = 0; i < scene->mesh_count; i++) {
        for (int p = 0; p < scene->meshes[i].primitive_count; p++)
            primitive_free(&scene->meshes[i].primitives[p]);
        free(scene->meshes[i].primitives);
    }
    for (int i = 0; i < scene->texture_count; i++)
        bitmap_free(&scene->textures[i].bitmap);
    free(scene->path);
    free(scene->nodes);
    free(scene->meshes);
    free(scene->materials);
    free(scene->textures);
    free(scene->lights);
    free(scene->cameras);
    *scene = (struct scene){0};
}
