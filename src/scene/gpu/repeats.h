/* Stores the indices of parts with equal triangles (geometry_part.twin) once. A draw adds the
 * distance of their vertices to each index. */
#ifndef SCENE_GPU_REPEATS_H
#define SCENE_GPU_REPEATS_H

#include "gl/buffer.h"
#include "scene/mesh/geometry.h"

struct repeats {
    struct repeat *items; /* in the order of the geometry's indices; the last has none */
    int count;            /* without the last */
};

/* A consecutive range of stored indices. */
struct stored {
    uint32_t first, count;
    int32_t base; /* added to each index; 0: the part's own indices */
};

void repeats_init(struct repeats *repeats, const struct geometry *geometry);
void repeats_free(struct repeats *repeats);

/* Returns the number of the geometry's indices that are not stored. */
uint32_t repeats_missing(const struct repeats *repeats);

/* Returns where the geometry's indices from `at` on are stored, up to `end` at most. */
struct stored repeats_next(const struct repeats *repeats, uint32_t at, uint32_t end);

/* Writes what is stored of a range of the geometry's indices. */
void repeats_write(const struct repeats *repeats, const struct geometry *geometry, uint32_t first,
                   uint32_t count, const struct buffer *indices);

#endif
