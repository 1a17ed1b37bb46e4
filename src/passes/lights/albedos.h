/* Uploads the albedo and the specular lobe of each triangle, for light rays. */
#ifndef PASSES_ALBEDOS_H
#define PASSES_ALBEDOS_H

#include "gl/buffer.h"
#include "scene/material.h"
#include "scene/mesh/geometry.h"

struct albedos_desc {
    const struct scene *scene;
    enum materials materials;
    bool smooth_black; /* glass and mirrors have albedo 0, because caustics carry their light */
};

struct albedos {
    struct albedos_desc desc;
    struct buffer buffer; /* two texels a triangle: UNIT_TRIANGLE_ALBEDOS */
    unsigned painted;     /* value of geometry->painted for `buffer` */
};

/* Error: driver, memory. */
bool albedos_init(struct albedos *albedos, const struct albedos_desc *desc,
                  const struct geometry *geometry);
void albedos_free(struct albedos *albedos);

/* Follows a change of the geometry's triangles. If memory for grown metaballs is lacking, triangles
 * without an albedo are black. */
void albedos_follow(struct albedos *albedos, const struct geometry *geometry);

#endif
