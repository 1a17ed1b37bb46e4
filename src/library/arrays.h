/* Makes a scene of a caller's arrays. Normals are repaired as those of files. */
#ifndef LIBRARY_ARRAYS_H
#define LIBRARY_ARRAYS_H

#include "library/manylight.h"
#include "scene/scene.h"

/* Fills a scene, for scene_open_desc.filled; free it in any case. Error: names part and member. */
bool arrays_fill(const struct manylight_scene_desc *desc, struct scene *scene);

/* Replace a part. A mesh has room for one primitive, and keeps it after an error. A material keeps
 * its pictures. Error: names the member. */
bool arrays_set_mesh(struct mesh *to, const struct manylight_mesh *mesh, int material,
                     bool has_picture);
bool arrays_set_material(struct material *to, const struct manylight_material *material);

#endif
