/* The node tree: finding nodes, and the frames of what hangs on them. World matrices:
 * scene_node_worlds of scene/scene.h. */
#ifndef SCENE_NODE_H
#define SCENE_NODE_H

#include "scene/scene.h"

/* What a node may carry. */
enum node_kind { NODE_MESH, NODE_LIGHT, NODE_CAMERA };

int node_count_carrying(const struct scene *scene, enum node_kind kind);

/* The n-th node that carries one, in node order. Asserts that there is one. */
int node_carrying(const struct scene *scene, enum node_kind kind, int n);

/* The name of the n-th such node, or where it has none that of what it carries. Asserts that there is one. */
const char *node_name_carrying(const struct scene *scene, enum node_kind kind, int n);

/* The n of the node whose own name, or that of the light or camera on it, is the text, or n itself
 * in digits; -1 and an error that lists the names when there is none such. */
int node_find_carrying(const struct scene *scene, enum node_kind kind, const char *text);

/* The orthonormal axes of a thing that looks along -Z with +Y up. Scale, shear and mirroring are
 * dropped, as glTF asks for cameras and lights. */
void node_frame(const float world[16], float right[3], float up[3], float forward[3]);

/* Refuses worlds of scene_node_worlds that are not finite: finite nodes may multiply up to infinite
 * ones. */
bool node_check_worlds(const struct scene *scene, float (*worlds)[16]);

/* World matrix of one node. */
void node_world(const struct scene *scene, int node, double time, float world[16]);

#endif
