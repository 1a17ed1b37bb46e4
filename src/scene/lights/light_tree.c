#include "scene/lights/light_tree.h"

#include "base/extremes.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/unit.h"
#include "shared/light_tree.h"

#include <float.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum {
    BINS = 12,     /* along each axis, at most */
    TASKS = 16,    /* subtrees of at most this fraction of all lights are built in parallel */
    TASK_MIN = 256 /* lights of the least subtree in parallel */
};

/* Least side of a box in costs, over the longest side of its parent's: lamps may lie in a line. */
static const float least_side = .01F;

/* Greatest number below 1. */
static const float below_one = 1 - FLT_EPSILON / 2;

/* Least power of a light that shines, over the sum of all: importances stay above 0. */
static const float least_power = 1e-12F;

/* --- splits ----------------------------------------------------------------------------------- */

/* A light while the tree is built. */
struct item {
    struct light_bounds bounds;
    float middle[3]; /* of the box */
    int light;
};

struct bin {
    struct light_bounds bounds;
    int count;
};

/* Bins along one axis. */
struct binning {
    int axis, count;
    float low, bins_per_metre;
    struct bin bins[BINS];
};

struct split {
    int axis;
    float place; /* the first child has the items below */
    float cost;
};

static int bin_of(const struct binning *binning, const struct item *item) {
    float bin = (item->middle[binning->axis] - binning->low) * binning->bins_per_metre;
    return (int)float_min(bin, (float)(binning->count - 1));
}

static void bin_add(struct bin *bin, const struct bin *other) {
    bin->bounds = bin->count > 0 ? light_bounds_merge(&bin->bounds, &other->bounds) : other->bounds;
    bin->count += other->count;
}

static void binning_fill(struct binning *binning, const struct item *items, int count) {
    for (int bin = 0; bin < binning->count; bin++)
        binning->bins[bin].count = 0;
    for (int i = 0; i < count; i++) {
        const struct bin one = {items[i].bounds, 1};
        bin_add(&binning->bins[bin_of(binning, &items[i])], &one);
    }
}

/* M_A M_O Phi of a child, with half the surface for M_A. */
static float cost_of(const struct light_bounds *bounds, float longest) {
    float side[3];
    for (int c = 0; c < 3; c++)
        side[c] = float_max(bounds->high[c] - bounds->low[c], least_side * longest);
    return (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]) *
           light_bounds_orientation(bounds) * bounds->power;
}

/* Finds where the children's costs are least [Conty and Kulla 2018]. The node's own
 * cost is left out, which is the same for all splits. */
static void improve_split(struct split *best, const struct binning *binning, float longest,
                          float regular) {
    float after[BINS];
    struct bin sum = {.count = 0};
    for (int bin = binning->count - 1; bin > 0; bin--) {
        if (binning->bins[bin].count > 0)
            bin_add(&sum, &binning->bins[bin]);
        after[bin] = sum.count > 0 ? cost_of(&sum.bounds, longest) : INFINITY;
    }
    sum.count = 0;
    for (int bin = 0; bin < binning->count - 1; bin++) {
        if (binning->bins[bin].count == 0)
            continue;
        bin_add(&sum, &binning->bins[bin]);
        float cost = regular * (cost_of(&sum.bounds, longest) + after[bin + 1]);
        if (cost < best->cost)
            *best = (struct split){binning->axis, (float)(bin + 1), cost};
    }
}

/* Finds the box of the items' middles; returns its longest side. */
static float find_middles(const struct item *items, int count, float low[3], float side[3]) {
    float high[3], longest = 0;
    for (int c = 0; c < 3; c++) {
        low[c] = high[c] = items->middle[c];
        for (int i = 1; i < count; i++) {
            low[c] = float_min(items[i].middle[c], low[c]);
            high[c] = float_max(items[i].middle[c], high[c]);
        }
        side[c] = high[c] - low[c];
        longest = float_max(side[c], longest);
    }
    return longest;
}

/* Returns how many items the first child has, which come first then. */
static int divide(struct item *items, int count) {
    struct split split = {.cost = INFINITY};
    struct binning binnings[3];
    float low[3], side[3], longest = find_middles(items, count, low, side);
    for (int axis = 0; axis < 3; axis++) {
        struct binning *binning = &binnings[axis];
        int bins = count < 4 * (BINS - 2) ? 2 + count / 4 : BINS;
        *binning = (struct binning){.axis = axis, .count = bins, .low = low[axis]};
        binning->bins_per_metre = (float)bins / side[axis];
        if (!(side[axis] > 0) || !isfinite(binning->bins_per_metre))
            continue;
        binning_fill(binning, items, count);
        improve_split(&split, binning, longest, longest / side[axis]);
    }
    int first = 0;
    for (int i = 0; isfinite(split.cost) && i < count; i++)
        if ((float)bin_of(&binnings[split.axis], &items[i]) < split.place) {
            struct item swapped = items[first];
            items[first++] = items[i];
            items[i] = swapped;
        }
    return first > 0 && first < count ? first : count / 2; /* lights in one place */
}

/* --- building --------------------------------------------------------------------------------- */

/* A node to be made, with its items. */
struct task {
    int node, first, count;
};

struct builder {
    struct light_tree *tree;
    struct item *items;
    int near_count; /* lights that are not distant come first */
    _Atomic int node_count;
    int task_size; /* items */
    struct task tasks[4 * TASKS];
    int task_count;
};

static void build(struct builder *builder, struct task task, bool makes_tasks) {
    struct light_tree *tree = builder->tree;
    struct item *items = builder->items + task.first;
    if (makes_tasks && task.count <= builder->task_size && builder->task_count < 4 * TASKS) {
        builder->tasks[builder->task_count++] = task;
        return;
    }
    if (task.count == 1) {
        tree->nodes[task.node].link = -1 - items->light;
        tree->leaves[items->light] = task.node;
        return;
    }
    bool is_mixed =
        task.first < builder->near_count && builder->near_count < task.first + task.count;
    int half = is_mixed ? builder->near_count : divide(items, task.count);
    int children = atomic_fetch_add(&builder->node_count, 2);
    tree->nodes[task.node].link = children;
    tree->parents[children / 2] = task.node;
    build(builder, (struct task){children, task.first, half}, makes_tasks);
    build(builder, (struct task){children + 1, task.first + half, task.count - half}, makes_tasks);
}

static void build_task(void *context, size_t i) {
    struct builder *builder = context;
    build(builder, builder->tasks[i], false);
}

static void add_item(struct builder *builder, const struct light_bounds *bounds, int light) {
    struct item *item = &builder->items[builder->near_count++];
    *item = (struct item){.bounds = *bounds, .light = light};
    for (int c = 0; c < 3; c++)
        item->middle[c] = bounds->low[c] / 2 + bounds->high[c] / 2;
}

void light_tree_init(struct light_tree *tree, const struct light_bounds *lights, int count) {
    struct builder builder = {.tree = tree,
                              .items = mem_alloc((size_t)count, sizeof *builder.items)};
    *tree = (struct light_tree){.leaves = mem_alloc((size_t)count, sizeof *tree->leaves),
                                .light_count = count};
    int distant = 0;
    for (int i = 0; i < count; i++) {
        tree->leaves[i] = -1;
        if (lights[i].power > 0 && lights[i].reach > 0)
            add_item(&builder, &lights[i], i);
    }
    for (int i = 0; i < count; i++)
        if (lights[i].power > 0 && lights[i].reach <= 0) {
            add_item(&builder, &lights[i], i);
            distant++;
        }
    int shining = builder.near_count;
    builder.near_count -= distant;
    tree->node_count = 2 * shining;
    tree->nodes = mem_alloc((size_t)tree->node_count, sizeof *tree->nodes);
    tree->parents = mem_alloc((size_t)shining, sizeof *tree->parents);
    builder.node_count = 2;
    builder.task_size = shining / TASKS > TASK_MIN ? shining / TASKS : 0;
    if (shining > 0)
        build(&builder, (struct task){0, 0, shining}, true);
    parallel_for((size_t)builder.task_count, 0, build_task, &builder);
    free(builder.items);
    light_tree_refit(tree, lights);
}

void light_tree_free(struct light_tree *tree) {
    mem_free(tree->nodes, tree->parents, tree->leaves);
    *tree = (struct light_tree){0};
}

/* --- bounds ----------------------------------------------------------------------------------- */

static void node_set(struct light_node *node, const struct light_bounds *bounds, float all_power) {
    float diagonal2 = 0;
    for (int c = 0; c < 3; c++) {
        float side = bounds->high[c] - bounds->low[c];
        node->center[c] = bounds->low[c] / 2 + bounds->high[c] / 2;
        node->axis[c] = bounds->axis[c];
        diagonal2 += side * side;
    }
    node->radius = sqrtf(diagonal2) / 2;
    node->cos_o = bounds->theta_o >= GLM_PIf ? -1 : cosf(bounds->theta_o);
    node->cos_e = cosf(float_min(bounds->theta_e, GLM_PIf));
    node->power = bounds->power > 0 ? float_max(bounds->power / all_power, least_power) : 0;
    node->reach = float_min(bounds->reach, FLT_MAX);
}

bool light_tree_refit(struct light_tree *tree, const struct light_bounds *lights) {
    struct light_bounds *bounds = mem_alloc((size_t)tree->node_count, sizeof *bounds);
    bool fits = true;
    for (int i = 0; i < tree->light_count; i++)
        fits = fits && (tree->leaves[i] >= 0 || !(lights[i].power > 0));
    for (int i = tree->node_count - 1; i >= 0; i--) {
        int link = tree->nodes[i].link;
        if (i != 1)
            bounds[i] =
                link < 0 ? lights[-1 - link] : light_bounds_merge(&bounds[link], &bounds[link + 1]);
    }
    for (int i = 0; i < tree->node_count; i++)
        if (i != 1)
            node_set(&tree->nodes[i], &bounds[i], bounds[0].power);
    free(bounds);
    return fits;
}

/* --- sampling --------------------------------------------------------------------------------- */

float light_node_importance(const struct light_node *node, const float position[3],
                            const float normal[3]) {
    bool is_distant = node->reach <= 0;
    vec3 to;
    glm_vec3_copy((float *)node->center, to);
    if (!is_distant)
        glm_vec3_sub(to, (float *)position, to);
    float distance2 = glm_vec3_norm2(to), radius2 = node->radius * node->radius;
    float distance = sqrtf(distance2), inverse = distance > 0 ? 1 / distance : 0;
    if (!is_distant && distance - node->radius > node->reach)
        return 0;
    bool has_normal = normal[0] != 0 || normal[1] != 0 || normal[2] != 0;
    float cos_normal = has_normal ? glm_vec3_dot((float *)normal, to) * inverse : 1;
    float cos_axis = -glm_vec3_dot((float *)node->axis, to) * inverse;
    float cosines =
        light_node_cosines(distance2, radius2, cos_normal, cos_axis, node->cos_o, node->cos_e);
    float apart2 = float_max(float_max(distance2, radius2), LIGHT_DISTANCE2_MIN);
    return node->power * cosines / (is_distant ? 1 : apart2);
}

/* Writes the probability of the first of two adjacent nodes. False: no light of both arrives. */
static bool first_of_pair(const struct light_node *pair, const float position[3],
                          const float normal[3], float *probability) {
    float first = light_node_importance(&pair[0], position, normal);
    float sum = first + light_node_importance(&pair[1], position, normal);
    *probability = first / sum;
    return sum > 0;
}

/* Samples that go on from a node: their random numbers, and the probability of the node. */
struct walk {
    int node, first, end;
    float probability;
};

/* Leads the samples of a walk to both children, and leaves those of the second for later. Returns
 * how many walks there are then. */
static int split_walk(const struct light_tree *tree, struct walk *walks, int count, float first,
                      float *random) {
    struct walk *walk = &walks[count - 1], second = *walk;
    int child = tree->nodes[walk->node].link;
    float rest = 1 - first;
    for (; second.first < walk->end && random[second.first] < first; second.first++)
        random[second.first] = float_min(random[second.first] / first, below_one);
    for (int i = second.first; i < walk->end; i++)
        random[i] = float_min((random[i] - first) / rest, below_one);
    second.node = child + 1;
    second.probability *= rest;
    *walk = (struct walk){child, walk->first, second.first, walk->probability * first};
    count -= walk->first == walk->end;
    if (second.first < second.end)
        walks[count++] = second;
    return count;
}

int light_tree_sample_some(const struct light_tree *tree, const float position[3],
                           const float normal[3], float random, int count,
                           struct light_sample *samples) {
    struct walk walks[LIGHT_SAMPLES_MAX] = {{0, 0, count, 1}};
    float randoms[LIGHT_SAMPLES_MAX], first;
    int found = 0, left = tree->node_count > 0;
    for (int i = 0; i < count; i++)
        randoms[i] = float_min(((float)i + random) / (float)count, below_one);
    while (left > 0) {
        struct walk *walk = &walks[left - 1];
        int link = tree->nodes[walk->node].link;
        if (link >= 0) {
            bool arrives = first_of_pair(&tree->nodes[link], position, normal, &first);
            left = arrives ? split_walk(tree, walks, left, first, randoms) : left - 1;
            continue;
        }
        for (int i = walk->first; i < walk->end; i++)
            samples[found++] = (struct light_sample){-1 - link, walk->probability};
        left--;
    }
    return found;
}

int light_tree_sample(const struct light_tree *tree, const float position[3], const float normal[3],
                      float random, float *probability) {
    struct light_sample sample = {-1, 0};
    light_tree_sample_some(tree, position, normal, random, 1, &sample);
    *probability = sample.probability;
    return sample.light;
}

float light_tree_probability(const struct light_tree *tree, const float position[3],
                             const float normal[3], int light) {
    int node = tree->leaves[light];
    float probability = node < 0 ? 0 : 1, first;
    for (; node > 0; node = tree->parents[node / 2]) {
        if (!first_of_pair(&tree->nodes[node & ~1], position, normal, &first))
            return 0;
        probability *= node % 2 == 0 ? first : 1 - first;
    }
    return probability;
}

/* --- rays ------------------------------------------------------------------------------------- */

/* Whether a ray may meet the ball around a node's box. */
static bool may_meet(const struct light_node *node, const float origin[3],
                     const float direction[3]) {
    bool is_distant = node->reach <= 0;
    vec3 to;
    glm_vec3_sub((float *)node->center, (float *)(is_distant ? direction : origin), to);
    float radius = 1.0001F * node->radius + 1e-6F * glm_vec3_norm(to); /* with rounding */
    float along = is_distant ? 0 : fmaxf(glm_vec3_dot(to, (float *)direction), 0);
    glm_vec3_muladds((float *)direction, -along, to);
    return glm_vec3_norm2(to) <= radius * radius;
}

int light_tree_next_met(const struct light_tree *tree, int light, const float origin[3],
                        const float direction[3]) {
    int node = light < 0 ? 0 : tree->leaves[light];
    bool enters = light < 0;
    while (tree->node_count > 0) {
        int link = tree->nodes[node].link;
        if (enters && (node == 0 || may_meet(&tree->nodes[node], origin, direction))) {
            if (link < 0)
                return -1 - link;
            node = link;
            continue;
        }
        while (node % 2 == 1)
            node = tree->parents[node / 2];
        if (node == 0)
            return -1;
        node++;
        enters = true;
    }
    return -1;
}
