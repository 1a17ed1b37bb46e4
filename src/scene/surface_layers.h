/* Layers of the surfaces at pixel centres, from the triangle that each pixel shows. Centres are not
 * mixed at edges. All layers are 0 where nothing is seen, which panes never are.
 *
 * id.node, id.mesh, id.material: index in the scene + 1. position: world, metres. depth: distance
 * along the pixel's ray, metres. uv: of the base colour, transformed, v down; 0 for materials
 * without textures. */
#ifndef SCENE_SURFACE_LAYERS_H
#define SCENE_SURFACE_LAYERS_H

#include "scene/camera.h"
#include "scene/mesh/geometry.h"

/* Surfaces that a camera shows. */
struct surface_view {
    const struct scene *scene;
    const struct geometry *geometry;
    const struct camera *camera;
    /* Triangle of each pixel, row 0 at the top: its first index is 3 x (number - 1). 0: none. */
    const uint32_t *triangles;
};

/* Returns the index of a layer; -1: none is called so. Names of all, null-terminated. */
int surface_layer_find(const char *name);
extern const char *const surface_layer_names[];

/* Returns the name of part i of the scene: of its nodes (0), meshes (1) or materials (2); NULL:
 * there is none. */
const char *surface_layer_id_name(const struct scene *scene, int layer, int i);

/* Appends a layer, unless the image has it. Ids add an attribute with the names of those that are
 * seen, as JSON: manylight:id.node = {"1":"floor"}. */
void surface_layer_append(const struct surface_view *view, int layer, struct image *image);

#endif
