/* Compressed data of glTF files: bridges to the libraries that unpack them. */
#ifndef SCENE_GLTF_UNPACK_H
#define SCENE_GLTF_UNPACK_H

#include <stdbool.h>
#include <stddef.h>

enum packed_mode { PACKED_ATTRIBUTES, PACKED_TRIANGLES, PACKED_INDICES };
enum packed_filter { FILTER_NONE, FILTER_OCTAHEDRAL, FILTER_QUATERNION, FILTER_EXPONENTIAL };

/* EXT_meshopt_compression, of one buffer view. */
struct packed_view {
    const unsigned char *bytes;
    size_t size;
    size_t count, stride; /* of what is in it, unpacked */
    enum packed_mode mode;
    enum packed_filter filter;
};

/* Writes count x stride bytes. Error: sizes that the mode or the filter does not have, or bytes that
 * are not such data. */
bool unpack_meshopt(const struct packed_view *view, unsigned char *to);

#endif
