/* What each triangle of the scene reflects, as rays of light look it up. */
#ifndef PASSES_ALBEDOS_H
#define PASSES_ALBEDOS_H

#include "gl/buffer.h"
#include "scene/material.h"
#include "scene/mesh/geometry.h"

struct albedos_desc {
    const struct scene *scene;
    enum materials materials;
    bool smooth_black; /* glass and mirrors reflect nothing: caustics carry their light */
};

struct albedos {
    struct albedos_desc desc;
    struct buffer
        buffer;       /* struct triangle_albedo of each triangle; texels: UNIT_TRIANGLE_ALBEDOS */
    unsigned painted; /* the geometry's, that they are of */
};

/* Error: driver, memory. */
bool albedos_init(struct albedos *albedos, const struct albedos_desc *desc,
                  const struct geometry *geometry);
void albedos_free(struct albedos *albedos);

/* Follows a change of the geometry's triangles. Where memory for metaballs that have grown is lacking, triangles without an
 * albedo are black. */
void albedos_follow(struct albedos *albedos, const struct geometry *geometry);

#endif
