/* Nearest partners in bins of directions, for both methods of making links (links.h). */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_PARTNER_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_PARTNER_H

#include "techniques/implicit-visibility/bins.h"
#include "techniques/implicit-visibility/tree.h"

/* A partner is a node's number, with PARTNER_BACK if its back is visible. */
#define PARTNER_BACK 0x80000000U
#define PARTNER_NONE UINT32_MAX

/* Least distance over an element's radius; nearer partners belong to its own surface. */
#define PARTNER_LEAST_DISTANCE .25F

/* Factor on a back's distance: a back hides light, but a front at equal distance wins. */
#define PARTNER_BACK_DISTANCE 1.02F

/* Least length of a node's mean normal; nodes with a shorter one are opened. */
#define PARTNER_LEAST_NORMAL .7F

static inline void partner_offer(float *nearest, uint32_t *partner, uint32_t node, bool front,
                                 float distance) {
    float key = front ? distance : distance * PARTNER_BACK_DISTANCE;
    uint32_t word = front ? node : node | PARTNER_BACK;
    if (key < *nearest || (key == *nearest && word < *partner)) {
        *nearest = key;
        *partner = word;
    }
}

/* True if the node is too wide for one link along `path`; `turned` is the path in the bins' axes. A
 * node of differing normals counts wider than its mean normal shows. */
static inline bool partner_opens(const struct bins *bins, const struct tree_node *node,
                                 const float path[3], const float turned[3], float distance) {
    float length2 = glm_vec3_norm2((float *)node->normal);
    if (length2 < PARTNER_LEAST_NORMAL * PARTNER_LEAST_NORMAL || distance < node->radius)
        return true;
    float cosine = fabsf(glm_vec3_dot((float *)node->normal, (float *)path)) / distance;
    float shown = cosine + .5F * sqrtf(fmaxf(1 - length2, 0));
    float solid_angle = node->area * shown / (distance * distance);
    return solid_angle > bins_solid_angle(bins, turned, distance);
}

#endif
