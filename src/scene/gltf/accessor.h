/* One array of a glTF file: typed, strided and optionally sparse elements in a buffer.
 *
 * Pointers may be unaligned. The code that fills the struct checks that all elements are inside
 * their buffers, so only a sparse index can fail here. */
#ifndef SCENE_GLTF_ACCESSOR_H
#define SCENE_GLTF_ACCESSOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum component_type { /* glTF's numbers, equal to OpenGL's */
                      COMPONENT_BYTE = 5120,
                      COMPONENT_UBYTE = 5121,
                      COMPONENT_SHORT = 5122,
                      COMPONENT_USHORT = 5123,
                      COMPONENT_UINT = 5125,
                      COMPONENT_FLOAT = 5126,
};

struct accessor {
    const unsigned char *bytes; /* first element; NULL: all elements are zero */
    size_t count, stride;       /* stride in bytes */
    int components;             /* 1 to 4, or the 16 floats of a matrix */
    int component_type;
    bool normalized; /* integers map to [0, 1] or [-1, 1] */

    /* Replaced elements: tightly packed indices and values. */
    size_t sparse_count;
    const unsigned char *sparse_indices, *sparse_values;
    int sparse_index_type;
};

/* Returns the size of a component, bytes; 0: unknown type. */
size_t component_size(int component_type);

/* Writes count x width floats. Missing components of an element stay unchanged in `out`. Error: a
 * sparse index out of range. */
bool accessor_read_floats(const struct accessor *accessor, int width, float *out);

/* Writes `count` indices. The accessor must have unsigned scalars. */
bool accessor_read_indices(const struct accessor *accessor, uint32_t *out);

#endif
