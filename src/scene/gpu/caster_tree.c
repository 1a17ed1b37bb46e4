#include "scene/gpu/caster_tree.h"

#include "base/clock.h"
#include "base/error.h"
#include "base/phases.h"
#include "base/memory.h"
#include "scene/mesh/corners.h"
#include "scene/mesh/opacity.h"
#include "scene/mesh/threaded_tree.h"

#include <math.h>
#include <string.h>

static void add_opaque(struct opaque_triangles *list, const struct geometry *geometry,
                       const struct geometry_batch *batch) {
    for (uint32_t i = 0; i < batch->index_count; i += 3) {
        const uint32_t *index = &geometry->indices[batch->first_index + i];
        struct tree_triangle triangle = {.opaque = {~0U, ~0U},
                                         .number = (batch->first_index + i) / 3};
        triangle.corner = corners_edges(geometry, index, triangle.edges);
        opaque_triangles_add(list, &triangle);
    }
}

static void plant(struct triangle_tree *tree, const struct scene *scene,
                  const struct geometry *geometry) {
    struct opaque_triangles list = {0};
    for (int b = 0; b < geometry->batch_count; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        if (scene->materials[batch->material].alpha_mask)
            opaque_triangles_add_masked(&list, scene, geometry, batch);
        else
            add_opaque(&list, geometry, batch);
    }
    triangle_tree_init(tree, list.items, list.count);
}

static bool upload(struct caster_tree *tree, const struct threaded_tree *threaded) {
    GLint most;
    size_t size = threaded->count * sizeof *threaded->texels;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (threaded->count > (uint32_t)most)
        return error_set("rays through triangles: the scene needs a buffer texture of %u texels, "
                         "and this OpenGL has %d",
                         threaded->count, most);
    if (tree->buffer.size >= size) { /* what is left over lies past the last box */
        buffer_write(&tree->buffer, 0, size, threaded->texels);
        return true;
    }
    caster_tree_free(tree);
    if (!buffer_init(&tree->buffer, "tree of casters", size, threaded->texels))
        return false;
    gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &tree->texels);
    gl.TextureBuffer(tree->texels, GL_RGBA32UI, tree->buffer.id);
    return true;
}

void caster_tree_free(struct caster_tree *tree) {
    if (tree->texels)
        gl.DeleteTextures(1, &tree->texels);
    buffer_free(&tree->buffer);
    *tree = (struct caster_tree){0};
}

/* Since the tree was planted. */
static bool has_moved(const struct caster_tree *tree, const struct geometry *geometry) {
    for (int i = 0; i < geometry->part_count; i++)
        if (geometry->parts[i].moved > tree->pose || geometry->parts[i].rewound > tree->pose)
            return true;
    return false;
}

bool caster_tree_update(struct caster_tree *tree, const struct scene *scene,
                        const struct geometry *geometry) {
    struct triangle_tree planted;
    struct threaded_tree threaded;
    struct threaded_tree_desc desc = {.clearance = geometry_clearance(geometry)};
    if (tree->texels && !has_moved(tree, geometry)) {
        tree->pose = geometry->pose_count;
        return true;
    }
    memcpy(desc.low, geometry->bounds_min, sizeof desc.low);
    memcpy(desc.high, geometry->bounds_max, sizeof desc.high);
    double start = clock_ms();
    plant(&planted, scene, geometry);
    threaded_tree_init(&threaded, &planted, &desc);
    phase_add(PHASE_TREE, start);
    bool ok = upload(tree, &threaded);
    tree->pose = geometry->pose_count;
    threaded_tree_free(&threaded);
    triangle_tree_free(&planted);
    return ok;
}
