#include "techniques/implicit-visibility/show.h"

#include "base/memory.h"
#include "techniques/implicit-visibility/partner.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int nearest_element(const struct elements *elements, const float position[3],
                           const float normal[3]) {
    int nearest = -1;
    float least = INFINITY;
    for (int i = 0; i < elements->count; i++) {
        const struct element *element = &elements->items[i];
        float distance2 = glm_vec3_distance2((float *)element->position.raw, (float *)position);
        if (glm_vec3_dot((float *)element->normal.raw, (float *)normal) > 0 && distance2 < least) {
            least = distance2;
            nearest = i;
        }
    }
    return nearest;
}

/* Axes of the cube: above is the one along which the normal leads most. */
static void unfold(vec3s normal, vec3s axes[3]) {
    int up = 0;
    for (int c = 1; c < 3; c++)
        if (fabsf(normal.raw[c]) > fabsf(normal.raw[up]))
            up = c;
    memset(axes, 0, 3 * sizeof *axes);
    axes[1].raw[up] = normal.raw[up] < 0 ? -1 : 1;
    axes[2].raw[(up + 1) % 3] = 1; /* towards the front */
    axes[0] = glms_vec3_cross(axes[1], axes[2]);
}

/* Of a face's column and row. */
static vec3s direction_of(const vec3s axes[3], int face, float x, float y) {
    const vec3s right = axes[0], up = axes[1], front = axes[2];
    const vec3s left = glms_vec3_negate(right), rear = glms_vec3_negate(front),
                down = glms_vec3_negate(up);
    const vec3s frames[ELEMENT_FACES][3] = {
        [ELEMENT_LEFT] = {left, front, up},  [ELEMENT_FRONT] = {front, right, up},
        [ELEMENT_RIGHT] = {right, rear, up}, [ELEMENT_REAR] = {rear, left, up},
        [ELEMENT_ABOVE] = {up, right, rear}, [ELEMENT_BELOW] = {down, right, front},
    };
    vec3s direction = glms_vec3_muladds(frames[face][1], x, frames[face][0]);
    return glms_vec3_muladds(frames[face][2], y, direction);
}

static int level_of(const struct tree *tree, uint32_t node) {
    int level = 0;
    for (; node >= (uint32_t)tree->leaf_count; level++)
        node = tree->nodes[node].children[0];
    return level;
}

static struct element_bin bin_of(const struct tree *tree, const struct element_light *light,
                                 uint32_t partner, float cosine) {
    struct element_bin bin = {.cosine = cosine, .level = -1};
    if (!(cosine > 0))
        return bin;
    bin.kind = partner == PARTNER_NONE  ? ELEMENT_BIN_OPEN
               : partner & PARTNER_BACK ? ELEMENT_BIN_BACK
                                        : ELEMENT_BIN_LINKED;
    if (bin.kind == ELEMENT_BIN_OPEN)
        return bin;
    uint32_t node = partner & ~PARTNER_BACK;
    bin.level = level_of(tree, node);
    memcpy(bin.partner, tree->nodes[node].position, sizeof bin.partner);
    if (bin.kind == ELEMENT_BIN_LINKED)
        memcpy(bin.radiance, light->radiance[node], sizeof bin.radiance);
    return bin;
}

void show_element(struct element_view *view, const struct elements *elements,
                  const struct tree *tree, const struct links *links,
                  const struct element_light *light, const float position[3],
                  const float normal[3]) {
    int leaf = nearest_element(elements, position, normal);
    vec3s axes[3];
    if (leaf < 0)
        return;
    const struct bins *bins = &links->bins;
    const int side = bins->side;
    uint32_t *partners = mem_alloc((size_t)bins->count, sizeof *partners);
    vec3s above = links_partners(links, tree, leaf, partners);
    unfold(above, axes);
    view->side = side;
    view->bins = mem_alloc((size_t)bins->count, sizeof *view->bins);
    memcpy(view->position, elements->items[leaf].position.raw, sizeof view->position);
    memcpy(view->irradiance, light->irradiance[leaf], sizeof view->irradiance);
    for (int i = 0; i < bins->count; i++) {
        float x = (2 * (float)(i % side) + 1) / (float)side - 1;
        float y = 1 - (2 * (float)(i / side % side) + 1) / (float)side;
        vec3s direction = direction_of(axes, i / (side * side), x, y);
        int b = bins_find(bins, direction.raw);
        view->bins[i] = bin_of(tree, light, partners[b], bin_cosine(&bins->items[b], above));
    }
    free(partners);
}
