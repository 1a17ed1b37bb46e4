#include "techniques/implicit-visibility/pairs.h"

#include "base/memory.h"

#include <math.h>

struct pairing {
    struct pairs *pairs;
    const struct tree *tree;
    const struct bins *bins;
};

static bool is_leaf(const struct pairing *pairing, uint32_t node) {
    return node < (uint32_t)pairing->tree->leaf_count;
}

/* --- pairs ------------------------------------------------------------------------------------ */

/* The path leads from the receiver to the node. */
static void offer(const struct pairing *pairing, uint32_t receiver, uint32_t node,
                  const float path[3], float distance) {
    const struct tree_node *nodes = pairing->tree->nodes;
    if (!(glm_vec3_dot((float *)nodes[receiver].normal, (float *)path) > 0))
        return;
    bool front = glm_vec3_dot((float *)nodes[node].normal, (float *)path) < 0;
    size_t at = (size_t)receiver * (size_t)pairing->pairs->bin_count +
                (size_t)bins_find(pairing->bins, path);
    partner_offer(&pairing->pairs->distances[at], &pairing->pairs->partners[at], node, front,
                  distance);
}

static void link_pair(const struct pairing *pairing, uint32_t a, uint32_t b);

/* Each child of the opened node with the other. */
static void link_children(const struct pairing *pairing, uint32_t opened, uint32_t other) {
    const uint32_t *children = pairing->tree->nodes[opened].children;
    for (int k = 0; k < TREE_CHILDREN && children[k] != TREE_NONE; k++)
        link_pair(pairing, children[k], other);
}

/* All pairs below a node. */
static void link_within(const struct pairing *pairing, uint32_t node) {
    const uint32_t *children = pairing->tree->nodes[node].children;
    if (is_leaf(pairing, node))
        return;
    for (int k = 0; k < TREE_CHILDREN && children[k] != TREE_NONE; k++) {
        link_within(pairing, children[k]);
        for (int i = 0; i < k; i++)
            link_pair(pairing, children[i], children[k]);
    }
}

/* Of disjoint parts of the tree. The larger of two nodes that are too wide is opened. */
static void link_pair(const struct pairing *pairing, uint32_t a, uint32_t b) {
    const struct tree_node *from = &pairing->tree->nodes[a], *to = &pairing->tree->nodes[b];
    float path[3], back[3];
    glm_vec3_sub((float *)to->position, (float *)from->position, path);
    glm_vec3_negate_to(path, back);
    float distance = glm_vec3_norm(path);
    bool opens_a = !is_leaf(pairing, a) && partner_opens(pairing->bins, from, back, back, distance);
    bool opens_b = !is_leaf(pairing, b) && partner_opens(pairing->bins, to, path, path, distance);
    if (opens_a && (!opens_b || from->area > to->area)) {
        link_children(pairing, a, b);
    } else if (opens_b) {
        link_children(pairing, b, a);
    } else {
        if (distance > PARTNER_LEAST_DISTANCE * from->radius)
            offer(pairing, a, b, path, distance);
        if (distance > PARTNER_LEAST_DISTANCE * to->radius)
            offer(pairing, b, a, back, distance);
    }
}

/* --- refinement and push ---------------------------------------------------------------------- */

/* Each bin of a node: a child without a shorter link takes the node's. */
static void push_to(const struct pairs *pairs, uint32_t node, uint32_t child) {
    const size_t count = (size_t)pairs->bin_count, from = node * count, to = child * count;
    for (size_t b = 0; b < count; b++) {
        uint32_t partner = pairs->partners[from + b];
        float distance = pairs->distances[from + b];
        if (partner != PARTNER_NONE && distance < pairs->distances[to + b]) {
            pairs->distances[to + b] = distance;
            pairs->partners[to + b] = partner;
        }
    }
}

static void push_links(const struct pairing *pairing) {
    for (int i = pairing->tree->count - 1; i >= pairing->tree->leaf_count; i--) {
        const uint32_t *children = pairing->tree->nodes[i].children;
        for (int k = 0; k < TREE_CHILDREN && children[k] != TREE_NONE; k++)
            push_to(pairing->pairs, (uint32_t)i, children[k]);
    }
}

size_t pairs_bytes(size_t nodes, int bin_count) {
    return nodes * (size_t)bin_count * (sizeof(float) + sizeof(uint32_t));
}

void pairs_make(struct pairs *pairs, const struct tree *tree, const struct bins *bins) {
    const size_t count = (size_t)tree->count * (size_t)bins->count;
    const struct pairing pairing = {pairs, tree, bins};
    *pairs = (struct pairs){.bin_count = bins->count};
    pairs->distances = mem_alloc(count, sizeof *pairs->distances);
    pairs->partners = mem_alloc(count, sizeof *pairs->partners);
    for (size_t i = 0; i < count; i++) {
        pairs->distances[i] = INFINITY;
        pairs->partners[i] = PARTNER_NONE;
    }
    link_within(&pairing, (uint32_t)tree->count - 1);
    for (size_t i = 0; i < count; i++)
        pairs->linked += pairs->partners[i] != PARTNER_NONE;
    push_links(&pairing);
}

void pairs_free(struct pairs *pairs) {
    mem_free(pairs->distances, pairs->partners);
    *pairs = (struct pairs){0};
}
