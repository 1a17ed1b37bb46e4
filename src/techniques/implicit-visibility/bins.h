/* Bins of directions: texels of a cube map of 6 x n x n, fixed in the world [Dong 2011 §4.3.2]. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_BINS_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_BINS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/unit.h"

enum {
    BINS_SIDE_MAX = 32,
    BINS_MAX = 6 * BINS_SIDE_MAX * BINS_SIDE_MAX,
    BIN_NEIGHBOURS = 8,
    BIN_PARTS = 4
};

struct bin {
    vec3s parts[BIN_PARTS]; /* its quarters: direction times solid angle, sr */
    uint16_t neighbours[BIN_NEIGHBOURS];
};

struct bins {
    int side, count; /* n, 6 n^2 */
    struct bin *items;
    vec3s *directions; /* unit directions of the bins' centres */
};

void bins_init(struct bins *bins, int side);
void bins_free(struct bins *bins);

/* Returns the bin of a direction of any length. */
int bins_find(const struct bins *bins, const float direction[3]);

/* Returns the face that the direction leads through: 2 axis + (1 if negative). */
int bins_face(const float direction[3]);

/* Returns the solid angle of the direction's bin, sr. length: of `direction`. */
float bins_solid_angle(const struct bins *bins, const float direction[3], float length);

/* Bins of a face that a box may cover, by its centre and half extents. Columns and rows are along
 * the axes (axis + 1) % 3 and (axis + 2) % 3. bins_window_of returns false if it covers none. */
struct bins_window {
    int first[2], end[2];
    bool inside; /* the box covers no other face */
};
bool bins_window_of(const struct bins *bins, int face, const float center[3],
                    const float extents[3], struct bins_window *window);

/* Returns the integral of max(cosine to the normal, 0) over a bin, sr, by its quarters. */
float bin_cosine(const struct bin *bin, vec3s normal);

#endif
