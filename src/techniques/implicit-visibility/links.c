#include "techniques/implicit-visibility/links.h"

#include "base/error.h"
#include "base/halton.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "scene/mesh/pane_triangles.h"
#include "techniques/implicit-visibility/pairs.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* Disks around the elements leave gaps: area of a disk that has none, over its element's. */
static const float disk_area = 1.5F;

/* Disks of less of a bin's solid angle are less than a bin wide. */
static const float disk_share = .5F;

/* An empty bin with so many filled neighbours is a leak. */
enum { FILLED_NEIGHBOURS = 5 };

enum { STACK_MAX = 256, LEAVES_TOGETHER = 8 };

struct walk {
    const struct links *links;
    const struct tree *tree;
    const struct tree_node *leaf;
    uint32_t own;
    mat3s turn; /* from the world to the leaf's bins */
    float distances[BINS_MAX];
    uint32_t nodes[BINS_MAX]; /* with PARTNER_BACK; PARTNER_NONE: empty */
};

/* --- partners --------------------------------------------------------------------------------- */

static void offer(struct walk *walk, int bin, uint32_t node, bool front, float distance) {
    partner_offer(&walk->distances[bin], &walk->nodes[bin], node, front, distance);
}

struct disk {
    uint32_t node;
    float center[3], normal[3]; /* from the leaf; unit */
    float along;                /* center . normal */
    float radius2;
};

static void offer_bin(struct walk *walk, const struct disk *disk, int b) {
    const float *ray = walk->links->bins.directions[b].raw;
    float cosine = glm_vec3_dot((float *)ray, (float *)disk->normal);
    float distance = disk->along / cosine, from2 = 0;
    if (!(distance > 0) || !(distance < walk->distances[b]))
        return;
    for (int c = 0; c < 3; c++) {
        float from = distance * ray[c] - disk->center[c];
        from2 += from * from;
    }
    if (from2 <= disk->radius2)
        offer(walk, b, disk->node, cosine < 0, distance);
}

static void offer_window(struct walk *walk, const struct disk *disk, int face,
                         const struct bins_window *window) {
    const int side = walk->links->bins.side;
    for (int row = window->first[1]; row < window->end[1]; row++)
        for (int column = window->first[0]; column < window->end[0]; column++)
            offer_bin(walk, disk, (face * side + row) * side + column);
}

static void offer_windows(struct walk *walk, const struct disk *disk) {
    const struct bins *bins = &walk->links->bins;
    const int major = bins_face(disk->center);
    struct bins_window window;
    float extents[3];
    for (int c = 0; c < 3; c++) {
        float across2 = 1 - disk->normal[c] * disk->normal[c];
        extents[c] = sqrtf(disk->radius2 * (across2 > 0 ? across2 : 0));
    }
    bins_window_of(bins, major, disk->center, extents, &window);
    offer_window(walk, disk, major, &window);
    for (int face = 0; face < 6 && !window.inside; face++)
        if (face != major && bins_window_of(bins, face, disk->center, extents, &window)) {
            offer_window(walk, disk, face, &window);
            window.inside = false;
        }
}

/* In all bins whose middle rays meet the disk. A small one reaches no middle but that of its own
 * bin. */
static void offer_disk(struct walk *walk, uint32_t j, vec3s path, bool small) {
    const struct tree_node *node = &walk->tree->nodes[j];
    struct disk disk = {.node = j, .radius2 = disk_area * node->area / GLM_PIf};
    vec3s normal = {{node->normal[0], node->normal[1], node->normal[2]}};
    normal = vec3s_unit(glms_mat3_mulv(walk->turn, normal));
    memcpy(disk.center, path.raw, sizeof disk.center);
    memcpy(disk.normal, normal.raw, sizeof disk.normal);
    disk.along = glm_vec3_dot(disk.center, disk.normal);
    if (small)
        offer_bin(walk, &disk, bins_find(&walk->links->bins, disk.center));
    else
        offer_windows(walk, &disk);
}

/* turned: the path, in the leaf's bins. */
static void offer_node(struct walk *walk, uint32_t j, const float path[3], vec3s turned,
                       float distance) {
    const struct tree_node *node = &walk->tree->nodes[j];
    const struct bins *bins = &walk->links->bins;
    float facing = -glm_vec3_dot((float *)node->normal, (float *)path) / distance;
    bool above = glm_vec3_dot((float *)walk->leaf->normal, (float *)path) > 0;
    float solid_angle = node->area * fabsf(facing) / (distance * distance);
    bool small = solid_angle < disk_share * bins_solid_angle(bins, turned.raw, distance);
    if (walk->links->desc.cover == LINKS_COVER_CENTER) {
        if (above)
            offer(walk, bins_find(bins, turned.raw), j, facing > 0, distance);
    } else if (facing > 0 || above) /* disks reach beyond their surface's edge: backs behind the
                                       leaf hide nothing */
        offer_disk(walk, j, turned, small);
}

/* All nodes that reach above the leaf's horizon. */
static void walk_tree(struct walk *walk) {
    const struct tree *tree = walk->tree;
    const struct tree_node *leaf = walk->leaf;
    const float near2 = glm_pow2(PARTNER_LEAST_DISTANCE * leaf->radius);
    uint32_t stack[STACK_MAX] = {(uint32_t)tree->count - 1};
    for (int size = 1; size > 0;) {
        uint32_t j = stack[--size];
        const struct tree_node *node = &tree->nodes[j];
        float path[3];
        for (int c = 0; c < 3; c++)
            path[c] = node->position[c] - leaf->position[c];
        float height = glm_vec3_dot(path, (float *)leaf->normal);
        if (j == walk->own || height < -node->radius)
            continue;
        float distance2 = glm_vec3_norm2(path), distance = sqrtf(distance2);
        vec3s turned = glms_mat3_mulv(walk->turn, (vec3s){{path[0], path[1], path[2]}});
        if (j >= (uint32_t)tree->leaf_count &&
            partner_opens(&walk->links->bins, node, path, turned.raw, distance) &&
            size + TREE_CHILDREN <= STACK_MAX) {
            for (int k = 0; k < TREE_CHILDREN && node->children[k] != TREE_NONE; k++)
                stack[size++] = node->children[k];
            continue;
        }
        if (distance2 > near2)
            offer_node(walk, j, path, turned, distance);
    }
}

/* --- links ------------------------------------------------------------------------------------ */

/* The nearest partner of the neighbours of an empty bin among filled ones, which thus is a leak; or
 * nothing. */
static uint32_t close_leak(const struct walk *walk, int b) {
    const struct bin *bin = &walk->links->bins.items[b];
    int filled = 0, nearest = -1;
    for (int k = 0; k < BIN_NEIGHBOURS; k++) {
        int other = bin->neighbours[k];
        if (walk->nodes[other] == PARTNER_NONE)
            continue;
        filled++;
        if (nearest < 0 || walk->distances[other] < walk->distances[nearest])
            nearest = other;
    }
    return filled >= FILLED_NEIGHBOURS ? walk->nodes[nearest] : PARTNER_NONE;
}

/* [Dong 2011 eq. 4.5] */
static float element_weight(const struct walk *walk, uint32_t j) {
    const struct tree_node *node = &walk->tree->nodes[j], *leaf = walk->leaf;
    vec3 path;
    glm_vec3_sub((float *)node->position, (float *)leaf->position, path);
    float distance2 = glm_vec3_norm2(path);
    float here = glm_vec3_dot(path, (float *)leaf->normal);
    float there = -glm_vec3_dot(path, (float *)node->normal);
    return fmaxf(here, 0) * fmaxf(there, 0) * node->area / (distance2 * distance2);
}

/* Of a bin, in the world. */
static vec3s direction_of(const struct walk *walk, int b) {
    vec3s direction = walk->links->bins.directions[b];
    return walk->links->desc.turned ? glms_mat3_mulv(glms_mat3_transpose(walk->turn), direction)
                                    : direction;
}

/* What panes let pass along a bin's direction. */
static vec3s panes_pass(const struct walk *walk, vec3s direction, float distance) {
    const struct links *links = walk->links;
    vec3s from;
    glm_vec3_copy((float *)walk->leaf->position, from.raw);
    glm_vec3_muladds((float *)walk->leaf->normal, links->clearance, from.raw);
    return pane_triangles_pass(links->panes, from, direction, distance);
}

/* Of a link. */
static vec3s link_passes(const struct walk *walk, int b, uint32_t node) {
    vec3s direction = direction_of(walk, b), path;
    glm_vec3_sub((float *)walk->tree->nodes[node].position, (float *)walk->leaf->position,
                 path.raw);
    return panes_pass(walk, direction, glms_vec3_dot(path, direction));
}

/* The radiance of the bin of the world that the leaf's leads to. */
static void add_sky(const struct walk *walk, int b, float weight, const float (*sky)[3],
                    float sum[3]) {
    if (!sky)
        return;
    vec3s direction = direction_of(walk, b), passes = panes_pass(walk, direction, INFINITY);
    const float *radiance = sky[bins_find(&walk->links->bins, direction.raw)];
    for (int c = 0; c < 3; c++)
        sum[c] += weight * radiance[c] * passes.raw[c];
}

/* In the leaf's bins. */
static vec3s normal_of(const struct walk *walk) {
    const float *normal = walk->leaf->normal;
    return glms_mat3_mulv(walk->turn, (vec3s){{normal[0], normal[1], normal[2]}});
}

static void take_links(const struct walk *walk, struct links *links, const float (*sky)[3]) {
    const uint32_t own = walk->own;
    struct link *items = links->items + (size_t)own * (size_t)links->stride;
    const vec3s normal = normal_of(walk);
    float all = 0, filled = 0, buried = 0, open[3] = {0};
    int count = 0, open_count = 0;
    for (int b = 0; b < links->bins.count; b++) {
        float weight = bin_cosine(&links->bins.items[b], normal);
        if (!(weight > 0))
            continue;
        uint32_t node = walk->nodes[b];
        all += weight;
        if (node == PARTNER_NONE && !links->desc.leaky)
            node = close_leak(walk, b);
        if (node == PARTNER_NONE) {
            add_sky(walk, b, weight, sky, open);
            if (count + open_count < links->stride)
                items[links->stride - ++open_count] = (struct link){.bin = (uint32_t)b};
            continue;
        }
        filled += weight;
        if (node & PARTNER_BACK) {
            buried += weight;
            continue;
        }
        if (links->desc.weight == LINKS_WEIGHT_ELEMENT)
            weight = element_weight(walk, node);
        if (count + open_count < links->stride)
            items[count++] = (struct link){node, (uint32_t)b,
                                           glms_vec3_scale(link_passes(walk, b, node), weight)};
    }
    /* The quarters' sum is pi but for their width. */
    float scale = all > 0 ? GLM_PIf / all : 0;
    for (int k = 0; k < count && links->desc.weight == LINKS_WEIGHT_BIN; k++)
        items[k].weight = glms_vec3_scale(items[k].weight, scale);
    for (int c = 0; c < 3; c++)
        links->sky[own][c] = open[c] * scale;
    links->counts[own] = count;
    links->open_counts[own] = open_count;
    links->filled[own] = filled * scale / GLM_PIf;
    links->buried[own] = buried * scale / GLM_PIf;
}

/* A random turn of the cube [Shoemake 1992]. */
static mat3s turn_of(uint32_t number) {
    float x = (float)radical_inverse(2, number),
          y = 2 * GLM_PIf * (float)radical_inverse(3, number),
          z = 2 * GLM_PIf * (float)radical_inverse(5, number);
    float a = sqrtf(1 - x), b = sqrtf(x);
    versors turn = {{a * sinf(y), a * cosf(y), b * sinf(z), b * cosf(z)}};
    return glms_quat_mat3(turn);
}

struct making {
    struct links *links;
    const struct tree *tree;
    const struct pairs *pairs; /* NULL: each leaf walks */
    const float (*sky)[3];
};

static void find_partners(struct walk *walk, const struct pairs *pairs) {
    const size_t count = (size_t)walk->links->bins.count, first = walk->own * count;
    if (pairs) {
        memcpy(walk->distances, pairs->distances + first, count * sizeof *walk->distances);
        memcpy(walk->nodes, pairs->partners + first, count * sizeof *walk->nodes);
        return;
    }
    for (size_t b = 0; b < count; b++) {
        walk->distances[b] = INFINITY;
        walk->nodes[b] = PARTNER_NONE;
    }
    walk_tree(walk);
}

static void start_walk(struct walk *walk, const struct links *links, const struct tree *tree,
                       int leaf) {
    walk->links = links;
    walk->tree = tree;
    walk->own = (uint32_t)leaf;
    walk->leaf = &tree->nodes[leaf];
    walk->turn = links->desc.turned ? turn_of((uint32_t)leaf) : glms_mat3_identity();
}

mat3s links_to_world(const struct links *links, int leaf) {
    return links->desc.turned ? glms_mat3_transpose(turn_of((uint32_t)leaf)) : glms_mat3_identity();
}

static void make_some(void *context, size_t run) {
    const struct making *making = context;
    struct walk *walk = mem_alloc(1, sizeof *walk);
    int first = (int)run * LEAVES_TOGETHER, end = first + LEAVES_TOGETHER;
    for (int i = first; i < end && i < making->tree->leaf_count; i++) {
        start_walk(walk, making->links, making->tree, i);
        find_partners(walk, making->pairs);
        take_links(walk, making->links, making->sky);
    }
    free(walk);
}

void links_make(struct links *links, const struct tree *tree, const float (*sky)[3]) {
    struct pairs pairs = {0};
    struct making making = {links, tree, links->desc.pairs ? &pairs : NULL, sky};
    size_t runs = ((size_t)tree->leaf_count + LEAVES_TOGETHER - 1) / LEAVES_TOGETHER;
    if (links->desc.pairs)
        pairs_make(&pairs, tree, &links->bins);
    links->linked = pairs.linked;
    parallel_for(runs, links->desc.threads, make_some, &making);
    pairs_free(&pairs);
}

/* Half of all bins, and those that the horizon cuts. */
int links_stride(int side) {
    return 3 * side * side + 6 * side + 8;
}

static size_t bytes_of(const struct links *links) {
    size_t each = (size_t)links->stride * sizeof *links->items + 3 * sizeof *links->counts +
                  sizeof *links->filled + sizeof *links->buried + sizeof *links->sky;
    return (size_t)links->leaf_count * each;
}

bool links_init(struct links *links, const struct links_desc *desc, int leaf_count) {
    const size_t count = (size_t)leaf_count;
    *links = (struct links){.desc = *desc, .leaf_count = leaf_count};
    links->desc.turned &= !desc->pairs; /* nodes share the world's bins */
    bins_init(&links->bins, desc->side);
    links->stride = links_stride(desc->side);
    size_t pairs = desc->pairs ? pairs_bytes(2 * count, links->bins.count) : 0;
    if (!mem_check(bytes_of(links) + pairs))
        return error_prefix("links of %d surface elements, %d bins each", leaf_count,
                            links->bins.count);
    assert(2 * count <= 1 << LINK_NODE_BITS && BINS_MAX <= 1 << LINK_BIN_BITS);
    links->items = mem_alloc(count * (size_t)links->stride, sizeof *links->items);
    links->counts = mem_alloc(count, sizeof *links->counts);
    links->open_counts = mem_alloc(count, sizeof *links->open_counts);
    links->lamp_counts = mem_alloc(count, sizeof *links->lamp_counts);
    links->filled = mem_alloc(count, sizeof *links->filled);
    links->buried = mem_alloc(count, sizeof *links->buried);
    links->sky = mem_alloc(count, sizeof *links->sky);
    return true;
}

void links_free(struct links *links) {
    bins_free(&links->bins);
    mem_free(links->items, links->counts, links->open_counts, links->lamp_counts, links->filled,
             links->buried, links->sky);
    *links = (struct links){0};
}

static bool is_lamp(const float emission[4]) {
    return emission[0] > 0 || emission[1] > 0 || emission[2] > 0;
}

void links_sort_lamps(struct links *links, const float (*emission)[4]) {
    struct link *others = mem_alloc((size_t)links->stride, sizeof *others);
    for (int i = 0; i < links->leaf_count; i++) {
        struct link *items = links->items + (size_t)i * (size_t)links->stride;
        int lamps = 0, rest = 0;
        for (int k = 0; emission && k < links->counts[i]; k++) {
            if (is_lamp(emission[items[k].node]))
                items[lamps++] = items[k];
            else
                others[rest++] = items[k];
        }
        memcpy(items + lamps, others, (size_t)rest * sizeof *items);
        links->lamp_counts[i] = lamps;
    }
    free(others);
}

static vec3s gather(const struct links *links, int leaf, int count, const float (*radiance)[4]) {
    const struct link *items = links->items + (size_t)leaf * (size_t)links->stride;
    vec3s sum = {{0}};
    for (int k = 0; k < count; k++)
        for (int c = 0; c < 3; c++)
            sum.raw[c] += items[k].weight.raw[c] * radiance[items[k].node][c];
    return sum;
}

vec3s links_gather(const struct links *links, int leaf, const float (*radiance)[4]) {
    return gather(links, leaf, links->counts[leaf], radiance);
}

vec3s links_gather_lamps(const struct links *links, int leaf, const float (*emission)[4]) {
    return gather(links, leaf, links->lamp_counts[leaf], emission);
}
