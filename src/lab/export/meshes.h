/* The scene's triangles as binary PLY files: position, normal, u v where the mesh has a texture. */
#ifndef LAB_EXPORT_MESHES_H
#define LAB_EXPORT_MESHES_H

#include "base/unit.h"
#include "lab/export/target.h"

/* Sorts the stage's triangles into target->meshes; points and lines are left out. */
void export_meshes_find(struct export_target *target);

/* Accepts a zeroed target. */
void export_meshes_free(struct export_target *target);

/* The mapping of the mesh's texture: the base colour's, else the emission's; -1 = it has none. */
int export_mapping(const struct export_target *target, const struct export_mesh *mesh);

/* Mode of the texture for both directions, as the formats have one. Where the directions differ,
 * one whose coordinates all lie from 0 to 1 follows the other; else v follows u, with a note. */
enum texture_wrap export_wrap(struct export_target *target, int n, int texture);

/* Writes mesh-N.ply; or mesh-N-back.ply, the other side: a little behind, with all turned round. */
bool export_ply(const struct export_target *target, int n, bool back);

/* Means over the mesh, by area: of the vertices' colours, and of what it emits, W/(sr m2). */
vec3s export_vertex_color(const struct export_target *target, const struct export_mesh *mesh);
vec3s export_emission(const struct export_target *target, const struct export_mesh *mesh);

/* Notes of what neither format has of the mesh's material. */
void export_note_mesh(struct export_target *target, const struct export_mesh *mesh);

#endif
