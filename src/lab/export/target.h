/* What manylight export writes: a scene as it is posed, into a folder. */
#ifndef LAB_EXPORT_TARGET_H
#define LAB_EXPORT_TARGET_H

#include "base/text.h"
#include "renderer/stage.h"
#include "scene/material.h"

/* Triangles of one material, all of which shine or none do. */
struct export_mesh {
    int material;
    bool shines;
    uint32_t *triangles; /* the geometry's */
    uint32_t count;
};

struct export_target {
    const struct stage *stage;
    const char *folder;
    int width, height, bounces, samples;
    enum materials materials;
    struct export_mesh *meshes;
    int mesh_count;
    struct text notes; /* of approximations, a line each */
    float srgb_to_linear[256];
};

/* folder/name, to be freed. */
char *export_path(const struct export_target *target, const char *name);

/* Writes the head, then the notes as comments between two texts, then the body. */
bool export_write(const struct export_target *target, const char *name, const char *before,
                  const char *after, const struct text *body);

/* Tells once what the format cannot say. */
void export_note(struct export_target *target, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A scene pack: scene.glb as it is, environment.exr, and scene.json, which has camera, lights and
 * picture in plain numbers (bench/schema/pack.schema.json). Error: also of a scene that is no GLB,
 * and of lamps of which some shine and some do not. */
bool export_pack(struct export_target *target);

/* scene.xml of Mitsuba 3, for its variants of RGB, with its meshes and textures.
 *
 * Exact: triangles, camera, diffuse surfaces without a mask, points, area lights, meshes that shine
 * on one side, the environment's turn. Notes name all that is not. */
bool export_mitsuba(struct export_target *target);

/* Whether the material reflects as a Lambertian surface. */
bool export_is_diffuse(const struct export_target *target, const struct material *material);

#endif
