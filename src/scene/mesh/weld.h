/* Finds vertices at equal positions. Files split corners of adjacent triangles if normals or
 * texture coordinates differ. */
#ifndef SCENE_MESH_WELD_H
#define SCENE_MESH_WELD_H

#include "scene/mesh/geometry.h"

struct weld {
    uint32_t *first; /* for each vertex the first one of its part at its position */
    bool *shared;    /* another part has a vertex at this position */
};

void weld_init(struct weld *weld, const struct geometry *geometry);
void weld_free(struct weld *weld);

#endif
