/* Shares one copy of indices between parts of the geometry with equal triangles, its twins. Draws
 * add the number of vertices between the two parts to each index. */
#ifndef SCENE_GPU_REPEATS_H
#define SCENE_GPU_REPEATS_H

#include "gl/buffer.h"
#include "scene/mesh/geometry.h"

struct repeats {
    struct repeat *items; /* in the order of the geometry's indices; the last has none */
    int count;            /* without the last */
};

/* Indices that are stored together. */
struct stored {
    uint32_t first, count;
    int32_t base; /* to be added to each; 0: they are no repeat */
};

void repeats_init(struct repeats *repeats, const struct geometry *geometry);
void repeats_free(struct repeats *repeats);

/* Returns how many of the geometry's indices are not stored. */
uint32_t repeats_missing(const struct repeats *repeats);

/* Returns where the geometry's indices from `at` on are stored, up to `end` at most. */
struct stored repeats_next(const struct repeats *repeats, uint32_t at, uint32_t end);

/* Writes the indices that are no repeats. */
void repeats_write(const struct repeats *repeats, const struct geometry *geometry,
                   const struct buffer *indices);

#endif
