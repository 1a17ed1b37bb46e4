#include "scene/scene.h"

#include "scene/framing.h"
#include "scene/gltf.h"
#include "scene/primitive.h"

#include <stdlib.h>

bool scene_load(struct scene *scene, const char *path) {
    *scene = (struct scene){0};
    if (gltf_load(scene, path) && scene_frame(scene))
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
