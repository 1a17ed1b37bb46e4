/* Where everything of a scene stands at one time, and how that places vertices. */
#ifndef SCENE_POSE_H
#define SCENE_POSE_H

#include "scene/scene.h"

struct pose {
    double time;
    float (*worlds)[16]; /* of the nodes */
    bool *shown;         /* the same */
    float *weights;      /* of the morph targets of all nodes' meshes, node after node */
    int *first_weight;   /* of each node */
    int weight_count;
};

void pose_init(struct pose *pose, const struct scene *scene);
void pose_free(struct pose *pose);

/* Error: a node at infinity. */
bool pose_set(struct pose *pose, const struct scene *scene, double time);

/* Whether a node's mesh is placed differently in the two poses. */
bool pose_differs(const struct pose *a, const struct pose *b, const struct scene *scene, int node);

/* Whether the node's mesh is turned into its mirror image: left becomes right. */
bool pose_mirrors(const struct pose *pose, const struct scene *scene, int node);

/* Places the vertices of a primitive of the node's mesh in the world: morph targets, then the skin
 * or the node's own world; normals are unit. Error: a vertex ends up too far away. */
bool pose_vertices(const struct pose *pose, const struct scene *scene, int node,
                   const struct primitive *primitive, float (*position)[3], float (*normal)[3]);

/* Places vertices of the node that neither have morph targets nor a skin. */
bool pose_rigid(const float world[16], uint32_t count, float (*from_position)[3],
                float (*from_normal)[3], float (*position)[3], float (*normal)[3]);

#endif
