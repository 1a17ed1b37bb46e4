#include "scene/mesh/triangle_tree.h"

#include "base/extremes.h"
#include "base/memory.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum {
    LEAF = 4,   /* triangles: so few are not split */
    BINS = 32,  /* of their middles, along each axis */
    DEPTH = 64, /* of the tree: deeper ones are leaves of any size */
};

/* --- boxes ------------------------------------------------------------------------------------ */

static struct tree_box empty_box(void) {
    return (struct tree_box){{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
}

static void box_add(struct tree_box *box, const struct tree_box *other) {
    for (int c = 0; c < 3; c++) {
        box->low[c] = float_min(other->low[c], box->low[c]);
        box->high[c] = float_max(other->high[c], box->high[c]);
    }
}

float tree_box_half_surface(const struct tree_box *box) {
    float x = box->high[0] - box->low[0], y = box->high[1] - box->low[1],
          z = box->high[2] - box->low[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
}

static struct tree_box box_of(const struct tree_triangle *triangle) {
    struct tree_box box;
    for (int c = 0; c < 3; c++) {
        float at = triangle->corner.raw[c], a = triangle->edges[0].raw[c],
              b = triangle->edges[1].raw[c];
        box.low[c] = at + float_min(float_min(a, b), 0);
        box.high[c] = at + float_max(float_max(a, b), 0);
    }
    return box;
}

static float middle_of(const struct tree_triangle *triangle, int axis) {
    return triangle->corner.raw[axis] +
           (triangle->edges[0].raw[axis] + triangle->edges[1].raw[axis]) / 3;
}

/* --- building --------------------------------------------------------------------------------- */

struct split {
    int axis, bin; /* the last one of the first child */
    float low, bins_per_metre, cost;
};

static int bin_of(const struct tree_triangle *triangle, const struct split *split) {
    float bin = (middle_of(triangle, split->axis) - split->low) * split->bins_per_metre;
    return (int)float_min(float_max(bin, 0), BINS - 1);
}

/* Where the children's surfaces, times how many triangles they have, are least: [Wald 2007, eq. 2]. */
static void find_bin(struct split *split, const struct tree_box boxes[BINS],
                     const uint32_t counts[BINS]) {
    float after[BINS];
    struct tree_box box = empty_box();
    uint32_t count = 0;
    for (int bin = BINS - 1; bin > 0; bin--) {
        box_add(&box, &boxes[bin]);
        count += counts[bin];
        after[bin] = count ? tree_box_half_surface(&box) * (float)count : INFINITY;
    }
    box = empty_box();
    count = 0;
    split->cost = INFINITY;
    for (int bin = 0; bin < BINS - 1; bin++) {
        box_add(&box, &boxes[bin]);
        count += counts[bin];
        float cost = count ? tree_box_half_surface(&box) * (float)count + after[bin + 1] : INFINITY;
        if (cost < split->cost) {
            split->cost = cost;
            split->bin = bin;
        }
    }
}

static struct split find_split_along(const struct tree_triangle *triangles, uint32_t count,
                                     const struct tree_box *middles, int axis) {
    struct tree_box boxes[BINS];
    uint32_t counts[BINS] = {0};
    struct split split = {.axis = axis, .low = middles->low[axis]};
    split.bins_per_metre = BINS / float_max(middles->high[axis] - split.low, FLT_MIN);
    for (int bin = 0; bin < BINS; bin++)
        boxes[bin] = empty_box();
    for (uint32_t i = 0; i < count; i++) {
        int bin = bin_of(&triangles[i], &split);
        struct tree_box box = box_of(&triangles[i]);
        box_add(&boxes[bin], &box);
        counts[bin]++;
    }
    find_bin(&split, boxes, counts);
    return split;
}

static struct split find_split(const struct tree_triangle *triangles, uint32_t count) {
    struct tree_box middles = empty_box();
    for (uint32_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++) {
            float middle = middle_of(&triangles[i], c);
            middles.low[c] = float_min(middle, middles.low[c]);
            middles.high[c] = float_max(middle, middles.high[c]);
        }
    struct split best = find_split_along(triangles, count, &middles, 0);
    for (int axis = 1; axis < 3; axis++) {
        struct split split = find_split_along(triangles, count, &middles, axis);
        if (split.cost < best.cost)
            best = split;
    }
    return best;
}

/* How many the first child has; 0: all lie at one place. */
static uint32_t divide(struct tree_triangle *triangles, uint32_t count) {
    struct split split = find_split(triangles, count);
    uint32_t first = 0;
    for (uint32_t i = 0; isfinite(split.cost) && i < count; i++)
        if (bin_of(&triangles[i], &split) <= split.bin) {
            struct tree_triangle swapped = triangles[first];
            triangles[first++] = triangles[i];
            triangles[i] = swapped;
        }
    return first;
}

static void build(struct triangle_tree *tree, uint32_t at, uint32_t first, uint32_t count,
                  int depth) {
    struct tree_triangle *triangles = tree->triangles + first;
    struct tree_box box = empty_box();
    for (uint32_t i = 0; i < count; i++) {
        struct tree_box own = box_of(&triangles[i]);
        box_add(&box, &own);
    }
    uint32_t half = count > LEAF && depth < DEPTH ? divide(triangles, count) : 0;
    uint32_t children = tree->node_count;
    tree->nodes[at] = (struct tree_node){box, half ? children : first, half ? 0 : count};
    if (half == 0)
        return;
    tree->node_count += 2;
    build(tree, children, first, half, depth + 1);
    build(tree, children + 1, first + half, count - half, depth + 1);
}

void triangle_tree_init(struct triangle_tree *tree, struct tree_triangle *triangles,
                        uint32_t count) {
    *tree = (struct triangle_tree){
        .triangles = triangles,
        .nodes = mem_alloc(2 * (size_t)count + 1, sizeof *tree->nodes),
        .count = count,
        .node_count = 1,
    };
    build(tree, 0, 0, count, 1);
}

void triangle_tree_free(struct triangle_tree *tree) {
    free(tree->triangles);
    free(tree->nodes);
    *tree = (struct triangle_tree){0};
}
