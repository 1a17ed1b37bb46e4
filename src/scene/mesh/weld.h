/* Which vertices of the geometry lie at the same place: files give the corners of neighbouring
 * triangles apart wherever normals or texture coordinates differ. */
#ifndef SCENE_MESH_WELD_H
#define SCENE_MESH_WELD_H

#include "scene/mesh/geometry.h"

struct weld {
    uint32_t *first; /* for each vertex the first one of its part at its place */
    bool *shared;    /* whether another part has a vertex there too */
};

void weld_init(struct weld *weld, const struct geometry *geometry);
void weld_free(struct weld *weld);

#endif
