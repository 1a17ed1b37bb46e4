#include "reference/light_tree.h"

#include "base/memory.h"
#include "reference/sampler.h"
#include "reference/vector.h"
#include "reference/warp.h"

#include <stdlib.h>

/* Bounds are taken so much wider than they are, for the rounding of what they bound. */
static const float rounding = 1e-5F;

/* --- building --------------------------------------------------------------------------------- */

enum { DIMENSIONS = 6 };

/* A light as a point of six dimensions: its place, and its normal in such lengths that the squared
 * distance of two adds what the angle between them costs. */
struct leaf {
    float place[DIMENSIONS];
    float key; /* its place along the dimension that is split */
    int vpl;
};

struct builder {
    struct light_tree *tree;
    const struct vpl *vpls;
    struct leaf *leaves;
    uint32_t seed;
};

static float power_of(const struct vpl *vpl) {
    return vpl->flux[0] + vpl->flux[1] + vpl->flux[2];
}

static int compare(const void *a, const void *b) {
    const struct leaf *p = a, *q = b;
    int order = (p->key > q->key) - (p->key < q->key);
    return order ? order : p->vpl - q->vpl;
}

static int widest_dimension(const struct leaf *leaves, int count) {
    int widest = 0;
    float width = -1;
    for (int d = 0; d < DIMENSIONS; d++) {
        float low = INFINITY, high = -INFINITY;
        for (int i = 0; i < count; i++) {
            low = fminf(low, leaves[i].place[d]);
            high = fmaxf(high, leaves[i].place[d]);
        }
        if (high - low > width) {
            widest = d;
            width = high - low;
        }
    }
    return widest;
}

static void find_box(const struct builder *builder, int first, int count,
                     struct light_extent *extent) {
    extent->low = vector_of(builder->vpls[builder->leaves[first].vpl].position);
    extent->high = extent->low;
    for (int i = first; i < first + count; i++) {
        vec3s place = vector_of(builder->vpls[builder->leaves[i].vpl].position);
        extent->low = glms_vec3_minv(extent->low, place);
        extent->high = glms_vec3_maxv(extent->high, place);
    }
}

static void find_cone(const struct builder *builder, int first, int count,
                      struct light_extent *extent) {
    vec3s sum = glms_vec3_zero();
    for (int i = first; i < first + count; i++)
        sum = glms_vec3_add(sum, vector_of(builder->vpls[builder->leaves[i].vpl].normal));
    extent->axis = glms_vec3_norm2(sum) > 0 ? glms_vec3_normalize(sum) : (vec3s){{0, 0, 1}};
    extent->cosine = 1;
    for (int i = first; i < first + count; i++)
        extent->cosine = fminf(
            extent->cosine,
            glms_vec3_dot(extent->axis, vector_of(builder->vpls[builder->leaves[i].vpl].normal)));
    extent->cosine = fmaxf(extent->cosine - rounding, -1);
    extent->sine = sqrtf(1 - extent->cosine * extent->cosine);
}

static int add_node(struct builder *builder, int first, int count);

static void sort_along_widest(struct leaf *leaves, int count) {
    int dimension = widest_dimension(leaves, count);
    for (int i = 0; i < count; i++)
        leaves[i].key = leaves[i].place[dimension];
    qsort(leaves, (size_t)count, sizeof *leaves, compare);
}

static void add_children(struct builder *builder, int index, int first, int count) {
    sort_along_widest(&builder->leaves[first], count);
    int half = count / 2, a = add_node(builder, first, half),
        b = add_node(builder, first + half, count - half);
    struct light_node *nodes = builder->tree->nodes, *node = &nodes[index];
    node->children[0] = a;
    node->children[1] = b;
    node->flux = glms_vec3_add(nodes[a].flux, nodes[b].flux);
    node->power = nodes[a].power + nodes[b].power;
    node->area = fminf(nodes[a].area, nodes[b].area);
    float number = (float)(sampler_hash(builder->seed, (uint32_t)index) >> 8) * 0x1p-24F;
    int from = number * node->power < nodes[a].power ? a : b;
    node->representative = nodes[from].representative;
}

static int add_node(struct builder *builder, int first, int count) {
    int index = builder->tree->count++;
    struct light_node *node = &builder->tree->nodes[index];
    find_box(builder, first, count, &node->extent);
    find_cone(builder, first, count, &node->extent);
    if (count > 1) {
        add_children(builder, index, first, count);
        return index;
    }
    const struct vpl *vpl = &builder->vpls[builder->leaves[first].vpl];
    node->flux = vector_of(vpl->flux);
    node->power = power_of(vpl);
    node->area = vpl->area;
    node->representative = builder->leaves[first].vpl;
    return index;
}

/* Returns how many there are. A right angle between normals counts as much as two lengths across all
 * lights over the square root of pi. */
static int find_leaves(struct builder *builder, int count) {
    vec3s low = glms_vec3_fill(INFINITY), high = glms_vec3_fill(-INFINITY);
    int leaves = 0;
    for (int i = 0; i < count; i++)
        if (builder->vpls[i].reach > 0 && power_of(&builder->vpls[i]) > 0) {
            low = glms_vec3_minv(low, vector_of(builder->vpls[i].position));
            high = glms_vec3_maxv(high, vector_of(builder->vpls[i].position));
            builder->leaves[leaves++].vpl = i;
        }
    float across = leaves ? glms_vec3_distance(low, high) / sqrtf(GLM_PIf) : 0;
    for (int i = 0; i < leaves; i++) {
        const struct vpl *vpl = &builder->vpls[builder->leaves[i].vpl];
        for (int c = 0; c < 3; c++) {
            builder->leaves[i].place[c] = vpl->position[c];
            builder->leaves[i].place[3 + c] = across * vpl->normal[c];
        }
    }
    return leaves;
}

void light_tree_init(struct light_tree *tree, const struct vpl *vpls, int count, uint32_t seed) {
    struct builder builder = {tree, vpls, mem_alloc((size_t)count, sizeof *builder.leaves), seed};
    int leaves = find_leaves(&builder, count);
    *tree = (struct light_tree){.nodes = mem_alloc(2 * (size_t)leaves, sizeof *tree->nodes)};
    if (leaves > 0)
        add_node(&builder, 0, leaves);
    free(builder.leaves);
}

void light_tree_free(struct light_tree *tree) {
    free(tree->nodes);
    *tree = (struct light_tree){0};
}

/* --- bounds ----------------------------------------------------------------------------------- */

struct interval {
    float low, high;
};

/* Of direction . v over a box of v. */
static struct interval project(vec3s direction, vec3s low, vec3s high) {
    struct interval sum = {0, 0};
    for (int c = 0; c < 3; c++) {
        float a = direction.raw[c] * low.raw[c], b = direction.raw[c] * high.raw[c];
        sum.low += fminf(a, b);
        sum.high += fmaxf(a, b);
    }
    return sum;
}

static float least_square(struct interval x) {
    float nearest = fmaxf(fmaxf(x.low, -x.high), 0);
    return nearest * nearest;
}

static float greatest_square(struct interval x) {
    return fmaxf(x.low * x.low, x.high * x.high);
}

/* The greatest cosine between a direction of the cone and a vector of the box. */
static float greatest_cosine(const struct light_extent *cone, vec3s low, vec3s high) {
    vec3s x_axis = warp_perpendicular(cone->axis);
    struct interval z = project(cone->axis, low, high), x = project(x_axis, low, high),
                    y = project(glms_vec3_cross(cone->axis, x_axis), low, high);
    float along = z.high + rounding * (z.high - z.low);
    float across2 =
        along >= 0 ? least_square(x) + least_square(y) : greatest_square(x) + greatest_square(y);
    float length = sqrtf(across2 + along * along);
    float cosine = length > 0 ? fminf(along / length + rounding, 1) : 1;
    if (cosine >= cone->cosine)
        return 1;
    return fmaxf(cosine * cone->cosine + sqrtf(1 - cosine * cosine) * cone->sine, 0);
}

float light_node_bound(const struct light_node *node, const struct light_extent *receiver,
                       const struct geometry_term *term) {
    vec3s low = glms_vec3_sub(node->extent.low, receiver->high),
          high = glms_vec3_sub(node->extent.high, receiver->low);
    float distance2 = 0;
    for (int c = 0; c < 3; c++)
        distance2 += least_square((struct interval){low.raw[c], high.raw[c]});
    float cosines = greatest_cosine(receiver, low, high) *
                    greatest_cosine(&node->extent, glms_vec3_negate(high), glms_vec3_negate(low));
    return cosines > 0 ? geometry_term(term, cosines * (1 + rounding), distance2, node->area) : 0;
}
