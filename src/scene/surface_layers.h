/* Layers of the surfaces at pixel centres, from the triangle that each pixel shows. Centres are not
 * mixed at edges. All layers are 0 where nothing is seen, which panes never are.
 *
 * id.node, id.mesh, id.material: index in the scene + 1. position: world, metres. depth: distance
 * along the pixel's ray, metres. uv: of the base colour, transformed, v down; 0 for materials
 * without textures. motion.next, motion.previous: from a pixel to where its point of the surface is
 * seen at another time, pixels, y down; 0 if it is behind the camera then. crypto.node,
 * crypto.mesh, crypto.material: ids and coverage, of several samples of a pixel
 * (scene/cryptomatte.h). */
#ifndef SCENE_SURFACE_LAYERS_H
#define SCENE_SURFACE_LAYERS_H

#include "scene/camera.h"
#include "scene/mesh/geometry.h"

/* The next frame and the one before. */
struct surface_motion {
    struct camera cameras[2];
    float (*positions[2])[3]; /* of the geometry's vertices, owned */
};

void surface_motion_free(struct surface_motion *motion);

/* Returns true if a list of names, "uv,motion.next" or NULL, has a layer that needs the motion. */
bool surface_layers_move(const char *names);

/* Surfaces that a camera shows. */
struct surface_view {
    const struct scene *scene;
    const struct geometry *geometry;
    const struct camera *camera;
    /* Triangle of each pixel, row 0 at the top: its first index is 3 x (number - 1). 0: none. */
    const uint32_t *triangles;
    const struct surface_motion *motion; /* for layers of motion */
    /* For mattes: samples of each pixel, and a function that returns the triangles of one, to be
     * freed; NULL: error. */
    int samples;
    uint32_t *(*look)(void *user, int sample);
    void *user;
};

/* Returns the index of a layer; -1: none is called so. Names of all, null-terminated. */
int surface_layer_find(const char *name);
extern const char *const surface_layer_names[];

/* Returns true for a Cryptomatte layer, which counts the samples of a pixel. */
bool surface_layer_is_matte(const char *name);

/* Returns the name of part i of the scene: of its nodes (0), meshes (1) or materials (2); NULL:
 * there is none. */
const char *surface_layer_id_name(const struct scene *scene, int layer, int i);

/* Returns the number of the part that each triangle is of, from 1 on; the caller frees it. */
uint32_t *surface_layer_numbers(const struct surface_view *view, int layer);

/* Appends the layers of surfaces among `names` that the image lacks. Error: that of view->look. Ids
 * add an attribute with the names of those that are seen, as JSON: manylight:id.node =
 * {"1":"floor"}. */
bool surface_layers_append(const struct surface_view *view, const char *names, struct image *image);

#endif
