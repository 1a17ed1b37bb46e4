#include "scene/gpu/caster_bvh.h"

#include "base/clock.h"
#include "base/error.h"
#include "base/phases.h"
#include "scene/mesh/opacity.h"
#include "scene/mesh/pane_triangles.h"
#include "scene/mesh/stackless_bvh.h"

#include <string.h>

static void plant(struct bvh *tree, bool of_panes, const struct scene *scene,
                  const struct geometry *geometry) {
    struct triangle_parts list =
        of_panes ? pane_triangles_of(scene, geometry) : opaque_triangles_of(scene, geometry);
    bvh_init(tree, list.items, list.count);
}

static bool upload(struct caster_bvh *tree, const struct stackless_bvh *stackless) {
    GLint most;
    size_t size = stackless->count * sizeof *stackless->texels;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (stackless->count > (uint32_t)most)
        return error_set("rays through triangles: the scene needs a buffer texture of %u texels, "
                         "and this OpenGL has %d",
                         stackless->count, most);
    if (tree->buffer.size >= size) { /* what is left over lies past the last box */
        buffer_write(&tree->buffer, 0, size, stackless->texels);
        return true;
    }
    caster_bvh_free(tree);
    return buffer_init_texels(&tree->buffer, GL_RGBA32UI, "caster BVH", size, stackless->texels);
}

void caster_bvh_free(struct caster_bvh *tree) {
    buffer_free(&tree->buffer);
    bvh_free(&tree->built);
    *tree = (struct caster_bvh){.of_panes = tree->of_panes};
}

/* Since the tree was built. */
static bool has_moved(const struct caster_bvh *tree, const struct geometry *geometry) {
    for (int i = 0; i < geometry->part_count; i++)
        if (geometry->parts[i].moved > tree->pose || geometry->parts[i].rewound > tree->pose)
            return true;
    return false;
}

bool caster_bvh_update(struct caster_bvh *tree, const struct scene *scene,
                       const struct geometry *geometry) {
    struct bvh built;
    struct stackless_bvh stackless;
    struct stackless_bvh_desc desc = {.clearance = geometry_clearance(geometry)};
    if (tree->buffer.id && !has_moved(tree, geometry)) {
        tree->pose = geometry->pose_count;
        return true;
    }
    bool moves = tree->buffer.id && !tree->of_panes; /* only that of all triangles is lent */
    memcpy(desc.low, geometry->bounds_min, sizeof desc.low);
    memcpy(desc.high, geometry->bounds_max, sizeof desc.high);
    double start = clock_ms();
    plant(&built, tree->of_panes, scene, geometry);
    stackless_bvh_init(&stackless, &built, &desc);
    phase_add(PHASE_TREE, start);
    bool ok = upload(tree, &stackless);
    tree->pose = geometry->pose_count;
    stackless_bvh_free(&stackless);
    bvh_free(moves ? &tree->built : &built);
    if (moves)
        tree->built = built;
    return ok;
}
