/* Positions of all parts of a scene at one time, and the placing of vertices. */
#ifndef SCENE_POSE_H
#define SCENE_POSE_H

#include "scene/scene.h"

struct pose {
    double time;
    float (*worlds)[16]; /* world matrix of each node */
    bool *shown;         /* visibility of each node */
    float *weights;      /* morph weights of all nodes' meshes, node after node */
    int *first_weight;   /* first weight of each node */
    int weight_count;
};

void pose_init(struct pose *pose, const struct scene *scene);
void pose_free(struct pose *pose);

/* Error: a node's world matrix is not finite. */
bool pose_set(struct pose *pose, const struct scene *scene, double time);

/* True if the node's mesh is placed differently in the two poses. */
bool pose_differs(const struct pose *a, const struct pose *b, const struct scene *scene, int node);

/* True if the node's mesh is mirrored. */
bool pose_mirrors(const struct pose *pose, const struct scene *scene, int node);

/* Places vertices of a primitive of the node's mesh in the world: morph targets, then the skin or
 * the node's matrix. Normals are unit. Error: a vertex is too far away. */
bool pose_vertices(const struct pose *pose, const struct scene *scene, int node,
                   const struct primitive *primitive, float (*position)[3], float (*normal)[3]);

/* Places vertices without morph targets and skin. */
bool pose_rigid(const float world[16], uint32_t count, float (*from_position)[3],
                float (*from_normal)[3], float (*position)[3], float (*normal)[3]);

#endif
