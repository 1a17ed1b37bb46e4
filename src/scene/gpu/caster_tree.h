/* The scene's triangles as rays of shaders meet them: a buffer texture for UNIT_TRIANGLE_TREE, as
 * scene/mesh/threaded_tree.h lays it out. All triangles hide light, from both sides, but where
 * an alpha mask has a hole. */
#ifndef SCENE_GPU_CASTER_TREE_H
#define SCENE_GPU_CASTER_TREE_H

#include "gl/buffer.h"
#include "scene/mesh/geometry.h"

struct caster_tree {
    struct buffer buffer;
    GLuint texels;
    unsigned pose; /* of the geometry, that it is of */
};

/* Makes it of where the geometry is now; zeroed before the first time. Error: out of GPU memory, or more triangles than a
 * buffer texture has room for; the tree must then be freed. */
bool caster_tree_update(struct caster_tree *tree, const struct scene *scene,
                        const struct geometry *geometry);
void caster_tree_free(struct caster_tree *tree);

#endif
