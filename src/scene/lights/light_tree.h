/* A binary tree over lights, to sample one in proportion to an estimate of its light at a point
 * [Conty and Kulla 2018]. The estimate is unshadowed.
 *
 * Distant lights form a subtree of their own, below the root: boxes of theirs hold directions.
 * Every light that can reach a point has a probability above 0 there. Dark lights are not in the
 * tree. Deviation: power is the intensity on the axis, so that a leaf's importance is its
 * irradiance. Cost: building n log n, sampling log n. */
#ifndef SCENE_LIGHTS_LIGHT_TREE_H
#define SCENE_LIGHTS_LIGHT_TREE_H

#include "scene/lights/light_bounds.h"

struct light_node;

struct light_tree {
    struct light_node *nodes; /* glsl/shared/light_tree.h; one array, ready for a GPU */
    int *parents;             /* parents of nodes 2 i and 2 i + 1 */
    int *leaves;              /* node of each light; -1: dark */
    int node_count;           /* even; 0: no light */
    int light_count;
};

/* Builds the tree on all cores. */
void light_tree_init(struct light_tree *tree, const struct light_bounds *lights, int count);

/* Accepts a zeroed object. */
void light_tree_free(struct light_tree *tree);

/* Moves the lights of an equal number, and keeps the tree's shape. False: a light that was dark
 * shines, so the tree needs building. */
bool light_tree_refit(struct light_tree *tree, const struct light_bounds *lights);

/* Returns the importance of a node other than the root at a point, over the power of all lights,
 * 1/m2. normal: unit; zero: a point of a medium. 0: no light arrives. */
float light_node_importance(const struct light_node *node, const float position[3],
                            const float normal[3]);

/* Samples a light by a number in [0, 1); writes its probability. -1: none, which has the rest of
 * the probability. */
int light_tree_sample(const struct light_tree *tree, const float position[3], const float normal[3],
                      float random, float *probability);

/* A light, and the probability of one sample of it. */
struct light_sample {
    int light;
    float probability;
};
enum { LIGHT_SAMPLES_MAX = 64 };

/* Samples several lights at once, stratified, and faster than one by one: sample i of count, at
 * most LIGHT_SAMPLES_MAX, is light_tree_sample's by (i + random) / count. Returns how many have a
 * light. */
int light_tree_sample_some(const struct light_tree *tree, const float position[3],
                           const float normal[3], float random, int count,
                           struct light_sample *samples);

/* Returns the probability with which light_tree_sample returns the light. */
float light_tree_probability(const struct light_tree *tree, const float position[3],
                             const float normal[3], int light);

/* Returns the next light after `light` (-1: the first), in the tree's order, whose box a ray with a
 * unit direction may meet; -1: none. */
int light_tree_next_met(const struct light_tree *tree, int light, const float origin[3],
                        const float direction[3]);

#endif
