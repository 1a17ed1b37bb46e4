#include "reference/light_cut.h"

#include "base/memory.h"

#include <stdlib.h>

/* While the cut is made its nodes are a heap with the greatest bound on top. */

static void swap(struct light_cut_node *a, struct light_cut_node *b) {
    struct light_cut_node kept = *a;
    *a = *b;
    *b = kept;
}

static void sift_up(struct light_cut_node *nodes, int i) {
    for (; i > 0 && nodes[i].bound > nodes[(i - 1) / 2].bound; i = (i - 1) / 2)
        swap(&nodes[i], &nodes[(i - 1) / 2]);
}

static void sift_down(struct light_cut_node *nodes, int count) {
    for (int i = 0, child; (child = 2 * i + 1) < count; i = child) {
        child += child + 1 < count && nodes[child + 1].bound > nodes[child].bound;
        if (nodes[i].bound >= nodes[child].bound)
            return;
        swap(&nodes[i], &nodes[child]);
    }
}

static void push(struct light_cut *cut, struct light_cut_node node) {
    if (cut->count == cut->room) {
        cut->room = cut->room ? 2 * cut->room : 64;
        cut->nodes = mem_resize(cut->nodes, (size_t)cut->room, sizeof *cut->nodes);
    }
    cut->nodes[cut->count++] = node;
    sift_up(cut->nodes, cut->count - 1);
}

/* A leaf is its representative, and a child may have its parent's, whose term is known. */
static struct light_cut_node node_of(const struct light_cut_desc *desc, int index,
                                     const struct light_cut_node *parent) {
    const struct light_node *node = &desc->tree->nodes[index];
    struct light_cut_node made = {.node = index};
    float most = light_node_bound(node, &desc->receiver, &desc->term);
    if (most == 0)
        return made;
    made.bound = light_node_is_leaf(node) ? 0 : most * node->power;
    bool known = parent && desc->tree->nodes[parent->node].representative == node->representative;
    made.term = known ? parent->term : desc->evaluate(desc->context, node->representative);
    return made;
}

static float light_of(const struct light_cut_desc *desc, const struct light_cut_node *node) {
    return node->term * desc->tree->nodes[node->node].power;
}

struct order {
    int representative;
    struct light_cut_node node;
};

static int compare(const void *a, const void *b) {
    return ((const struct order *)a)->representative - ((const struct order *)b)->representative;
}

/* As all lights would be summed: with all leaves the sum is the same to the last bit. */
static void sort(struct light_cut *cut, const struct light_tree *tree) {
    struct order *order = mem_alloc((size_t)cut->count, sizeof *order);
    for (int i = 0; i < cut->count; i++)
        order[i] = (struct order){tree->nodes[cut->nodes[i].node].representative, cut->nodes[i]};
    qsort(order, (size_t)cut->count, sizeof *order, compare);
    for (int i = 0; i < cut->count; i++)
        cut->nodes[i] = order[i].node;
    free(order);
}

void light_cut_find(struct light_cut *cut, const struct light_cut_desc *desc) {
    cut->count = 0;
    if (desc->tree->count == 0)
        return;
    push(cut, node_of(desc, 0, NULL));
    double sum = (double)light_of(desc, &cut->nodes[0]);
    while ((double)cut->nodes[0].bound > (double)desc->tolerance * sum) {
        struct light_cut_node parent = cut->nodes[0];
        const int *children = desc->tree->nodes[parent.node].children;
        struct light_cut_node a = node_of(desc, children[0], &parent),
                              b = node_of(desc, children[1], &parent);
        sum += (double)light_of(desc, &a) + (double)light_of(desc, &b) -
               (double)light_of(desc, &parent);
        cut->nodes[0] = a;
        sift_down(cut->nodes, cut->count);
        push(cut, b);
    }
    sort(cut, desc->tree);
}

void light_cut_free(struct light_cut *cut) {
    free(cut->nodes);
    *cut = (struct light_cut){0};
}
