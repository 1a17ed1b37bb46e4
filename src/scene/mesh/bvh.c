#include "scene/mesh/bvh.h"

#include "base/extremes.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <float.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum {
    LEAF = 4,   /* triangles at most, where more than one place holds them */
    BINS = 32,  /* of their middles along each axis, at most */
    DEPTH = 64, /* of the tree: deeper nodes are leaves of any size */
    TASKS = 16, /* subtrees of at most this fraction of all triangles are built in parallel */
};

/* Cost of entering a node's two boxes, in tests of one triangle. */
static const float traversal_cost = 1;

/* --- boxes ------------------------------------------------------------------------------------ */

static struct bvh_box empty_box(void) {
    return (struct bvh_box){{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
}

static void box_add(struct bvh_box *box, const struct bvh_box *other) {
    for (int c = 0; c < 3; c++) {
        box->low[c] = float_min(other->low[c], box->low[c]);
        box->high[c] = float_max(other->high[c], box->high[c]);
    }
}

float bvh_box_half_surface(const struct bvh_box *box) {
    float x = box->high[0] - box->low[0], y = box->high[1] - box->low[1],
          z = box->high[2] - box->low[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
}

/* A triangle while the tree is built. */
struct item {
    struct bvh_box box;
    float middle[3]; /* of the box */
    uint32_t triangle;
};

static struct item item_of(const struct bvh_triangle *triangle, uint32_t number) {
    struct item item = {.triangle = number};
    for (int c = 0; c < 3; c++) {
        float at = triangle->corner.raw[c], a = triangle->edges[0].raw[c],
              b = triangle->edges[1].raw[c];
        item.box.low[c] = at + float_min(float_min(a, b), 0);
        item.box.high[c] = at + float_max(float_max(a, b), 0);
        item.middle[c] = (item.box.low[c] + item.box.high[c]) / 2;
    }
    return item;
}

/* --- splits ----------------------------------------------------------------------------------- */

struct bin {
    struct bvh_box box;
    uint32_t count;
};

/* Bins over the middles of items, along each axis. */
struct binning {
    struct bvh_box middles;
    int count; /* along each axis; few items need few */
    float bins_per_metre[3];
    struct bin bins[3][BINS];
};

struct split {
    int axis, bin; /* the last bin of the first child */
    float cost;    /* half surface times triangles, summed over the children */
};

static int bin_of(const struct item *item, const struct binning *binning, int axis) {
    float bin = (item->middle[axis] - binning->middles.low[axis]) * binning->bins_per_metre[axis];
    return (int)float_min(bin, (float)(binning->count - 1));
}

static void binning_init(struct binning *binning, const struct item *items, uint32_t count) {
    binning->middles = empty_box();
    binning->count = count < 4 * (BINS - 4) ? 4 + (int)count / 4 : BINS;
    for (uint32_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++) {
            binning->middles.low[c] = float_min(items[i].middle[c], binning->middles.low[c]);
            binning->middles.high[c] = float_max(items[i].middle[c], binning->middles.high[c]);
        }
    for (int c = 0; c < 3; c++) {
        float side = binning->middles.high[c] - binning->middles.low[c];
        binning->bins_per_metre[c] = side > 0 ? (float)binning->count / side : 0;
        for (int bin = 0; bin < binning->count; bin++)
            binning->bins[c][bin] = (struct bin){empty_box(), 0};
    }
    for (uint32_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++) {
            struct bin *bin = &binning->bins[c][bin_of(&items[i], binning, c)];
            box_add(&bin->box, &items[i].box);
            bin->count++;
        }
}

/* Where the children's surfaces, times how many triangles they have, are least: [Wald 2007,
 * eq. 2]. */
static void improve_split(struct split *best, const struct binning *binning, int axis) {
    const struct bin *bins = binning->bins[axis];
    float after[BINS];
    struct bin sum = {empty_box(), 0};
    for (int bin = binning->count - 1; bin > 0; bin--) {
        box_add(&sum.box, &bins[bin].box);
        sum.count += bins[bin].count;
        after[bin] = sum.count ? bvh_box_half_surface(&sum.box) * (float)sum.count : INFINITY;
    }
    sum = (struct bin){empty_box(), 0};
    for (int bin = 0; bin < binning->count - 1; bin++) {
        box_add(&sum.box, &bins[bin].box);
        sum.count += bins[bin].count;
        float cost = bvh_box_half_surface(&sum.box) * (float)sum.count + after[bin + 1];
        if (sum.count > 0 && cost < best->cost)
            *best = (struct split){axis, bin, cost};
    }
}

/* How many items the first child has, which come first then; 0 = they stay one leaf: their middles
 * lie at one place, or a split costs more than it saves. */
static uint32_t divide(struct item *items, uint32_t count, const struct bvh_box *box) {
    struct binning binning;
    struct split split = {.cost = INFINITY};
    binning_init(&binning, items, count);
    for (int axis = 0; axis < 3; axis++)
        if (binning.bins_per_metre[axis] > 0)
            improve_split(&split, &binning, axis);
    float surface = bvh_box_half_surface(box);
    bool pays = count > LEAF || traversal_cost * surface + split.cost < surface * (float)count;
    uint32_t first = 0;
    for (uint32_t i = 0; pays && isfinite(split.cost) && i < count; i++)
        if (bin_of(&items[i], &binning, split.axis) <= split.bin) {
            struct item swapped = items[first];
            items[first++] = items[i];
            items[i] = swapped;
        }
    return first;
}

/* --- building --------------------------------------------------------------------------------- */

/* A node that is to be made. */
struct task {
    uint32_t at, first, count; /* its number; its items */
    int depth;
};

struct builder {
    struct item *items;
    struct bvh_node *nodes;
    _Atomic uint32_t node_count;
    uint32_t task_size; /* items */
    struct task tasks[4 * TASKS];
    uint32_t task_count;
};

/* Subtrees that are small enough are left as tasks where there is room for them. */
static void build(struct builder *builder, struct task task, bool makes_tasks) {
    struct item *items = builder->items + task.first;
    struct bvh_box box = empty_box();
    if (makes_tasks && task.count <= builder->task_size && builder->task_count < 4 * TASKS) {
        builder->tasks[builder->task_count++] = task;
        return;
    }
    for (uint32_t i = 0; i < task.count; i++)
        box_add(&box, &items[i].box);
    uint32_t half = task.count > 1 && task.depth < DEPTH ? divide(items, task.count, &box) : 0;
    if (half == 0) {
        builder->nodes[task.at] = (struct bvh_node){box, task.first, task.count};
        return;
    }
    uint32_t children = atomic_fetch_add(&builder->node_count, 2);
    builder->nodes[task.at] = (struct bvh_node){box, children, 0};
    build(builder, (struct task){children, task.first, half, task.depth + 1}, makes_tasks);
    build(builder,
          (struct task){children + 1, task.first + half, task.count - half, task.depth + 1},
          makes_tasks);
}

static void build_task(void *context, size_t i) {
    struct builder *builder = context;
    build(builder, builder->tasks[i], false);
}

/* Leaf by leaf. */
static void order_triangles(struct bvh *tree, const struct item *items) {
    struct bvh_triangle *ordered = mem_alloc(tree->count, sizeof *ordered);
    for (uint32_t i = 0; i < tree->count; i++)
        ordered[i] = tree->triangles[items[i].triangle];
    free(tree->triangles);
    tree->triangles = ordered;
}

void bvh_init(struct bvh *tree, struct bvh_triangle *triangles, uint32_t count) {
    struct builder builder = {
        .items = mem_alloc(count, sizeof *builder.items),
        .nodes = mem_alloc(2 * (size_t)count + 1, sizeof *builder.nodes),
        .node_count = 1,
        .task_size = count / TASKS,
    };
    for (uint32_t i = 0; i < count; i++)
        builder.items[i] = item_of(&triangles[i], i);
    build(&builder, (struct task){0, 0, count, 1}, true);
    parallel_for(builder.task_count, 0, build_task, &builder);
    *tree = (struct bvh){triangles, builder.nodes, count, builder.node_count};
    order_triangles(tree, builder.items);
    free(builder.items);
}

void bvh_free(struct bvh *tree) {
    mem_free(tree->triangles, tree->nodes);
    *tree = (struct bvh){0};
}
