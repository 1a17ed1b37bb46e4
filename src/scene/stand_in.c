#include "scene/stand_in.h"

#include "base/memory.h"
#include "scene/node.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* --- materials --- */

/* Which of the scene's materials meshes have; how many they are. */
static int find_used(const struct scene *scene, bool *used) {
    int count = 0;
    for (int m = 0; m < scene->mesh_count; m++)
        for (int p = 0; p < scene->meshes[m].primitive_count; p++)
            used[scene->meshes[m].primitives[p].material] = true;
    for (int i = 0; i < scene->material_count; i++)
        count += used[i];
    return count;
}

/* Software OpenGL compiles sampling anew for sizes that are no power of two. */
static int few_texels(int size) {
    return (size & (size - 1)) == 0 ? 2 : 3;
}

static void make_textures(struct scene *scene, const struct scene *like) {
    scene->texture_count = like->texture_count;
    scene->textures = mem_alloc((size_t)like->texture_count, sizeof *scene->textures);
    for (int i = 0; i < like->texture_count; i++) {
        const struct bitmap *bitmap = &like->textures[i].bitmap;
        struct scene_texture *texture = &scene->textures[i];
        *texture = like->textures[i];
        texture->bitmap = (struct bitmap){.width = few_texels(bitmap->width),
                                          .height = few_texels(bitmap->height)};
        size_t size = 4 * (size_t)texture->bitmap.width * (size_t)texture->bitmap.height;
        texture->bitmap.rgba = mem_alloc(size, 1);
        memset(texture->bitmap.rgba, 255, size);
    }
}

/* --- triangles --- */

/* A square as wide as half of the scene, in its middle. */
static void make_primitive(struct primitive *primitive, int material,
                           const struct geometry *geometry) {
    enum { CORNERS = 4, INDICES = 6 };
    static const float corners[CORNERS][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static const uint32_t indices[INDICES] = {0, 1, 2, 0, 2, 3};
    *primitive = (struct primitive){.vertex_count = CORNERS,
                                    .index_count = INDICES,
                                    .position = mem_alloc(CORNERS, sizeof *primitive->position),
                                    .normal = mem_alloc(CORNERS, sizeof *primitive->normal),
                                    .uv = {mem_alloc(CORNERS, sizeof *primitive->uv[0])},
                                    .indices = mem_alloc(INDICES, sizeof *primitive->indices),
                                    .material = material};
    for (int i = 0; i < CORNERS; i++) {
        for (int c = 0; c < 3; c++)
            primitive->position[i][c] =
                geometry->center[c] + (c < 2 ? geometry->radius * (corners[i][c] - .5F) : 0);
        primitive->normal[i][2] = 1;
        memcpy(primitive->uv[0][i], corners[i], sizeof *primitive->uv[0]);
    }
    memcpy(primitive->indices, indices, sizeof indices);
}

static void make_mesh(struct scene *scene, const struct scene *like,
                      const struct geometry *geometry) {
    bool *used = mem_alloc((size_t)like->material_count, sizeof *used);
    int count = find_used(like, used);
    struct mesh *mesh = scene->meshes = mem_alloc(1, sizeof *mesh);
    scene->mesh_count = 1;
    mesh->primitives = mem_alloc((size_t)count, sizeof *mesh->primitives);
    for (int i = 0; i < like->material_count; i++)
        if (used[i])
            make_primitive(&mesh->primitives[mesh->primitive_count++], i, geometry);
    free(used);
    scene->node_count = 1;
    scene->nodes = mem_alloc(1, sizeof *scene->nodes);
    *scene->nodes = node_new();
    scene->nodes->mesh = 0;
}

void stand_in_init(struct stand_in *stand_in, const struct scene *scene,
                   const struct geometry *geometry) {
    struct scene *own = &stand_in->scene;
    *stand_in = (struct stand_in){0};
    if (scene->environment) {
        stand_in->sky = *scene->environment;
        own->environment = &stand_in->sky;
    }
    own->material_count = scene->material_count;
    own->materials =
        mem_copy(scene->materials, (size_t)scene->material_count, sizeof *own->materials);
    make_textures(own, scene);
    make_mesh(own, scene, geometry);
    if (scene->surface_count > 0) { /* whether anything shines is known when programs are made */
        own->surface_count = 1;
        own->surfaces = mem_alloc(1, sizeof *own->surfaces);
    }
    bool ok = geometry_init(&stand_in->geometry, own, 0);
    assert(ok);
    (void)ok;
}

void stand_in_free(struct stand_in *stand_in) {
    stand_in->scene.environment = NULL; /* another's */
    geometry_free(&stand_in->geometry);
    scene_free(&stand_in->scene);
}
