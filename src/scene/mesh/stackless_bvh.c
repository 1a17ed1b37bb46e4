#include "scene/mesh/stackless_bvh.h"

#include "base/extremes.h"
#include "base/memory.h"
#include "shared/bvh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a step, more than the rounding of a ray's places. */
static const float margin = .5F;

/* Of the surface of the box around it. */
static const float worth_a_box = .7F;

struct layout {
    const struct bvh *tree;
    uint32_t (*texels)[4];
    float low[3], steps[3]; /* a metre */
    uint32_t next;          /* texel of a box */
    uint32_t triangles;     /* the first one's texel */
};

static uint32_t bits(float value) {
    uint32_t same;
    memcpy(&same, &value, sizeof same);
    return same;
}

/* Whole numbers from 0 up: cutting the fraction off is rounding down. */
static uint32_t step_below(const struct layout *layout, const struct bvh_box *box, int axis) {
    float at = (box->low[axis] - layout->low[axis]) * layout->steps[axis];
    return (uint32_t)float_min(float_max(at - margin, 0), (float)STACKLESS_STEPS);
}

static uint32_t step_above(const struct layout *layout, const struct bvh_box *box, int axis) {
    float at = (box->high[axis] - layout->low[axis]) * layout->steps[axis];
    return (uint32_t)float_min(float_max(ceilf(at + margin), 0), (float)STACKLESS_STEPS);
}

static uint32_t *lay_box(struct layout *layout, const struct bvh_box *box) {
    uint32_t *texel = layout->texels[layout->next++];
    for (int c = 0; c < 3; c++)
        texel[c] = step_below(layout, box, c) | step_above(layout, box, c) << 16;
    return &texel[3];
}

/* More triangles than a number has room for, all of them at one place, are several leaves. */
static void lay_leaf(struct layout *layout, const struct bvh_node *node) {
    for (uint32_t i = 0, count; i < node->count; i += count) {
        uint32_t rest = node->count - i;
        count = rest < STACKLESS_COUNT_MOST ? rest : STACKLESS_COUNT_MOST;
        uint32_t texel = layout->triangles + (node->first + i) * STACKLESS_TRIANGLE;
        *lay_box(layout, &node->box) = STACKLESS_LEAF | count << STACKLESS_COUNT_SHIFT | texel;
    }
}

/* The larger child first: it is the likelier to block, and a blocked ray is done. A box that is
 * entered nearly whenever that around it is, of that half surface, saves less than it costs, and is
 * left out. */
static void lay_node(struct layout *layout, uint32_t number, float around) {
    const struct bvh_node *node = &layout->tree->nodes[number];
    if (node->count > 0) {
        lay_leaf(layout, node);
        return;
    }
    float surface = bvh_box_half_surface(&node->box);
    bool is_laid = surface < worth_a_box * around;
    uint32_t *past = is_laid ? lay_box(layout, &node->box) : NULL;
    const struct bvh_node *children = &layout->tree->nodes[node->first];
    uint32_t larger =
        bvh_box_half_surface(&children[1].box) > bvh_box_half_surface(&children[0].box);
    lay_node(layout, node->first + larger, is_laid ? surface : around);
    lay_node(layout, node->first + 1 - larger, is_laid ? surface : around);
    if (is_laid)
        *past = layout->next;
}

static void lay_triangle(struct layout *layout, uint32_t number) {
    const struct bvh_triangle *triangle = &layout->tree->triangles[number];
    uint32_t(*texels)[4] = layout->texels + layout->triangles + number * STACKLESS_TRIANGLE;
    for (int c = 0; c < 3; c++) {
        texels[0][c] = bits(triangle->corner.raw[c]);
        texels[1][c] = bits(triangle->edges[0].raw[c]);
        texels[2][c] = bits(triangle->edges[1].raw[c]);
    }
    for (int i = 0; i < 2; i++)
        texels[i][3] = triangle->opaque[i];
    texels[2][3] = triangle->number;
}

/* At most so many. */
static uint32_t count_boxes(const struct bvh *tree) {
    uint32_t count = tree->node_count;
    for (uint32_t i = 0; i < tree->node_count; i++)
        if (tree->nodes[i].count > 0)
            count += (tree->nodes[i].count - 1) / STACKLESS_COUNT_MOST;
    return count;
}

static void lay_header(struct layout *layout, float clearance) {
    for (int c = 0; c < 3; c++) {
        layout->texels[0][c] = bits(layout->low[c]);
        layout->texels[1][c] = bits(layout->steps[c]);
    }
    layout->texels[0][3] = layout->next;
    layout->texels[1][3] = bits(clearance);
}

void stackless_bvh_init(struct stackless_bvh *stackless, const struct bvh *tree,
                        const struct stackless_bvh_desc *desc) {
    uint32_t first_triangle = STACKLESS_HEADER + count_boxes(tree);
    stackless->count = first_triangle + tree->count * STACKLESS_TRIANGLE;
    stackless->texels = mem_alloc(stackless->count, sizeof *stackless->texels);
    struct layout layout = {
        .tree = tree,
        .texels = stackless->texels,
        .next = STACKLESS_HEADER,
        .triangles = first_triangle,
    };
    for (int c = 0; c < 3; c++) {
        float side = desc->high[c] - desc->low[c];
        layout.low[c] = desc->low[c];
        layout.steps[c] = (float)STACKLESS_STEPS / fmaxf(side, desc->clearance);
    }
    if (tree->count > 0)
        lay_node(&layout, 0, INFINITY);
    for (uint32_t i = 0; i < tree->count; i++)
        lay_triangle(&layout, i);
    lay_header(&layout, desc->clearance);
}

void stackless_bvh_free(struct stackless_bvh *stackless) {
    free(stackless->texels);
    *stackless = (struct stackless_bvh){0};
}
