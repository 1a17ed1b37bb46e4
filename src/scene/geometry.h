/* The scene's triangles in world space at one time: what the GPU draws and Embree traces.
 *
 * Vertices of all meshes lie in one set of arrays and all triangles in one index array, so that a
 * pass can draw everything at once. Triangles are sorted into batches of one material; batches
 * without alpha mask come first, so that depth passes draw all of them in one call.
 */
#ifndef SCENE_GEOMETRY_H
#define SCENE_GEOMETRY_H

#include "scene/scene.h"

/* Consecutive triangles of one material. */
struct geometry_batch {
    int material;
    uint32_t first_index, index_count;
};

struct geometry {
    uint32_t vertex_count, index_count;
    float (*position)[3]; /* world; one spare element, as Embree reads 16 bytes a vertex */
    float (*normal)[3];   /* world, unit */
    float (*uv)[2];
    float (*color)[4];
    uint32_t *indices;
    struct geometry_batch *batches;
    int batch_count;
    uint32_t opaque_index_count; /* indices of the batches without alpha mask: [0, this) */

    /* Bounding box and sphere of the vertices that triangles use. */
    float bounds_min[3], bounds_max[3];
    float center[3], radius; /* radius > 0 */

    /* Where each (node, primitive) lies, for updates. */
    struct geometry_part {
        int node, primitive;
        uint32_t first_vertex, vertex_count;
    } * parts;
    int part_count;
};

/* Lays out the arrays and fills them for the time. Error: a scene without a triangle. */
bool geometry_init(struct geometry *geometry, const struct scene *scene, double time);
void geometry_free(struct geometry *geometry);

#endif
