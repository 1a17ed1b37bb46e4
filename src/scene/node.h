/* The node tree: finding nodes, and frames of lights and cameras. World matrices: scene_node_worlds
 * of scene/scene.h. */
#ifndef SCENE_NODE_H
#define SCENE_NODE_H

#include "scene/scene.h"

/* Returns a root without contents, at the origin. */
struct node node_new(void);

/* Contents of a node. */
enum node_kind { NODE_MESH, NODE_LIGHT, NODE_CAMERA };

int node_count_carrying(const struct scene *scene, enum node_kind kind);

/* Returns the n-th node with the contents, in node order, which must exist. */
int node_carrying(const struct scene *scene, enum node_kind kind, int n);

/* Returns the name of the node, or else the name of its contents of that kind. */
const char *node_shown_name(const struct scene *scene, enum node_kind kind, int node);

/* Returns the name of the n-th node with the contents, or else the name of its contents. It must
 * exist. */
const char *node_name_carrying(const struct scene *scene, enum node_kind kind, int n);

/* Returns n of the node whose name, or whose light's or camera's name, is `text`, or n in digits.
 * Error, -1: unknown; lists the names. */
int node_find_carrying(const struct scene *scene, enum node_kind kind, const char *text);

/* Writes the orthonormal axes of an object that looks along -Z with +Y up. Scale, shear and
 * mirroring are dropped, as glTF requires for cameras and lights. */
void node_frame(const float world[16], float right[3], float up[3], float forward[3]);

/* Error: a world matrix that is not finite, because finite nodes may multiply to infinite ones. */
bool node_check_worlds(const struct scene *scene, float (*worlds)[16]);

/* Writes the world matrix of one node, column-major. time: seconds. */
void node_world(const struct scene *scene, int node, double time, float world[16]);

#endif
