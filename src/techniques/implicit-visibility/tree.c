#include "techniques/implicit-visibility/tree.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

enum { AXES = 6 };

struct item {
    float at[AXES]; /* position and scaled normal */
    int element;
};

struct builder {
    struct tree *tree;
    struct item *items;
};

static int compare_on(const struct item *a, const struct item *b, int axis) {
    if (a->at[axis] != b->at[axis])
        return a->at[axis] < b->at[axis] ? -1 : 1;
    return a->element < b->element ? -1 : a->element > b->element;
}

#define COMPARE(n)                                                                                 \
    static int compare_##n(const void *a, const void *b) {                                         \
        return compare_on(a, b, n);                                                                \
    }
COMPARE(0)
COMPARE(1)
COMPARE(2)
COMPARE(3)
COMPARE(4)
COMPARE(5)

static int (*const comparisons[AXES])(const void *a, const void *b) = {
    compare_0, compare_1, compare_2, compare_3, compare_4, compare_5};

/* Sorts along the longest axis. */
static void sort_items(struct item *items, int count) {
    int longest = 0;
    float extent = -1;
    for (int axis = 0; axis < AXES; axis++) {
        float low = INFINITY, high = -INFINITY;
        for (int i = 0; i < count; i++) {
            low = fminf(low, items[i].at[axis]);
            high = fmaxf(high, items[i].at[axis]);
        }
        if (high - low > extent) {
            extent = high - low;
            longest = axis;
        }
    }
    qsort(items, (size_t)count, sizeof *items, comparisons[longest]);
}

/* Two cuts make four children of nearly as many elements. */
static uint32_t build(const struct builder *builder, int first, int count) {
    if (count == 1)
        return (uint32_t)first;
    struct item *items = builder->items + first;
    struct tree_node node = {.children = {TREE_NONE, TREE_NONE, TREE_NONE, TREE_NONE}};
    int half = count / 2, children = 0;
    sort_items(items, count);
    for (int h = 0; h < 2; h++) {
        int start = h ? half : 0, size = h ? count - half : half;
        if (size > 1)
            sort_items(items + start, size);
        for (int q = 0; q < 2; q++) {
            int from = q ? start + size / 2 : start, part = q ? size - size / 2 : size / 2;
            if (part > 0)
                node.children[children++] = build(builder, first + from, part);
        }
    }
    builder->tree->nodes[builder->tree->count] = node;
    return (uint32_t)builder->tree->count++;
}

static void reorder(struct elements *elements, const struct item *items) {
    struct element *sorted = mem_alloc((size_t)elements->count, sizeof *sorted);
    for (int i = 0; i < elements->count; i++)
        sorted[i] = elements->items[items[i].element];
    free(elements->items);
    elements->items = sorted;
}

void tree_init(struct tree *tree, struct elements *elements, float size) {
    int count = elements->count;
    struct builder builder = {tree, mem_alloc((size_t)count, sizeof *builder.items)};
    *tree = (struct tree){.nodes = mem_alloc(2 * (size_t)count, sizeof *tree->nodes),
                          .leaf_count = count,
                          .count = count};
    for (int i = 0; i < count; i++) {
        const struct element *element = &elements->items[i];
        builder.items[i].element = i;
        for (int c = 0; c < 3; c++) {
            builder.items[i].at[c] = element->position.raw[c];
            builder.items[i].at[3 + c] = size * element->normal.raw[c];
        }
    }
    build(&builder, 0, count);
    reorder(elements, builder.items);
    free(builder.items);
    tree_pull_up(tree, elements);
}

void tree_free(struct tree *tree) {
    free(tree->nodes);
    *tree = (struct tree){0};
}

static void pull_up(struct tree_node *nodes, struct tree_node *node) {
    vec3s position = glms_vec3_zero(), normal = glms_vec3_zero();
    node->area = node->radius = 0;
    for (int i = 0; i < TREE_CHILDREN && node->children[i] != TREE_NONE; i++) {
        struct tree_node *child = &nodes[node->children[i]];
        node->area += child->area;
        glm_vec3_muladds(child->position, child->area, position.raw);
        glm_vec3_muladds(child->normal, child->area, normal.raw);
    }
    glm_vec3_scale(position.raw, 1 / node->area, node->position);
    glm_vec3_scale(normal.raw, 1 / node->area, node->normal);
    for (int i = 0; i < TREE_CHILDREN && node->children[i] != TREE_NONE; i++) {
        struct tree_node *child = &nodes[node->children[i]];
        float reach = glm_vec3_distance(child->position, node->position) + child->radius;
        node->radius = fmaxf(node->radius, reach);
    }
}

void tree_pull_up(struct tree *tree, const struct elements *elements) {
    for (int i = 0; i < tree->leaf_count; i++) {
        const struct element *element = &elements->items[i];
        struct tree_node *leaf = &tree->nodes[i];
        memcpy(leaf->position, element->position.raw, sizeof leaf->position);
        memcpy(leaf->normal, element->normal.raw, sizeof leaf->normal);
        leaf->area = element->area;
        leaf->radius = sqrtf(element->area / GLM_PIf);
    }
    for (int i = tree->leaf_count; i < tree->count; i++)
        pull_up(tree->nodes, &tree->nodes[i]);
}

void tree_pull_up_values(const struct tree *tree, float (*values)[4]) {
    for (int i = tree->leaf_count; i < tree->count; i++) {
        const struct tree_node *node = &tree->nodes[i];
        float sum[4] = {0};
        for (int k = 0; k < TREE_CHILDREN && node->children[k] != TREE_NONE; k++) {
            const float *value = values[node->children[k]];
            float area = tree->nodes[node->children[k]].area;
            for (int c = 0; c < 3; c++)
                sum[c] += area * value[c];
        }
        for (int c = 0; c < 3; c++)
            values[i][c] = sum[c] / node->area;
    }
}
