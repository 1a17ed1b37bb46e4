/* One array of a glTF file: typed, strided and perhaps sparse elements in a buffer.
 *
 * The pointers need no alignment. Whoever fills the struct has checked that all elements lie in
 * their buffers; here nothing can fail but a sparse index.
 */
#ifndef SCENE_GLTF_ACCESSOR_H
#define SCENE_GLTF_ACCESSOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum component_type { /* glTF's numbers, which are OpenGL's */
                      COMPONENT_BYTE = 5120,
                      COMPONENT_UBYTE = 5121,
                      COMPONENT_SHORT = 5122,
                      COMPONENT_USHORT = 5123,
                      COMPONENT_UINT = 5125,
                      COMPONENT_FLOAT = 5126,
};

struct accessor {
    const unsigned char *bytes; /* the first element; NULL = all elements are zero */
    size_t count, stride;       /* stride in bytes */
    int components;             /* 1 to 4, or the 16 floats of a matrix */
    int component_type;
    bool normalized; /* integers stand for [0, 1] or [-1, 1] */

    /* Elements that are replaced: tightly packed indices and values. */
    size_t sparse_count;
    const unsigned char *sparse_indices, *sparse_values;
    int sparse_index_type;
};

/* Bytes of a component; 0 for a number that names no type. */
size_t component_size(int component_type);

/* Writes count x width floats. Components beyond the accessor's own stay as they are in out.
 * Error: a sparse index out of range. */
bool accessor_read_floats(const struct accessor *accessor, int width, float *out);

/* Writes count numbers. The accessor holds unsigned scalars. */
bool accessor_read_indices(const struct accessor *accessor, uint32_t *out);

#endif
