/* Renders paraboloid depth maps from VALs or VPLs [Dong 2009 §4.2, §6]: D16, map depth |q| /
 * z_far. Instanced draws render all casters, kind by kind, into all layers. With planes also
 * normals. */
#ifndef PASSES_PARABOLOID_H
#define PASSES_PARABOLOID_H

#include "passes/maps.h"
#include "scene/gpu/caster_pool.h"

struct frame;

struct paraboloid_desc {
    struct caster_pool *casters; /* must outlive the pass */
    struct caster_desc caster;   /* casters that the maps show */
    int size, count;
    bool planes; /* maps also have the casters' normals */
};

struct paraboloid_pass {
    struct paraboloid_desc desc;
    const struct caster_gpu *caster;
    GLuint opaque_programs[CASTER_KIND_COUNT];
    GLuint masked_programs[CASTER_LONG + 1]; /* solids have no masked triangles */
    struct depth_maps maps;
    struct buffer params;
};

bool paraboloid_pass_init(struct paraboloid_pass *pass, const struct paraboloid_desc *desc);
void paraboloid_pass_free(struct paraboloid_pass *pass);

/* Draws the first views->count maps. Timer "depth maps". */
void paraboloid_pass_render(const struct paraboloid_pass *pass, const struct frame *frame,
                            const struct map_views *views);

#endif
