/* Compressed data of glTF files: bridges to the libraries that unpack them. */
#ifndef SCENE_GLTF_UNPACK_H
#define SCENE_GLTF_UNPACK_H

#include <stdbool.h>
#include <stddef.h>

enum packed_mode { PACKED_ATTRIBUTES, PACKED_TRIANGLES, PACKED_INDICES };
enum packed_filter {
    FILTER_NONE,
    FILTER_OCTAHEDRAL,
    FILTER_QUATERNION,
    FILTER_EXPONENTIAL,
    FILTER_COLOR
};

/* EXT_meshopt_compression and KHR_meshopt_compression, of one buffer view. */
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

/* The same of attributes whose stream is of version 1, without the filter. */
enum { MESHOPT_V1 = 0xa1 }; /* the first byte */
bool unpack_meshopt_v1(const struct packed_view *view, unsigned char *to);

/* Undoes the colour filter in place. */
void unpack_meshopt_color(const struct packed_view *view, unsigned char *to);

/* A mesh of KHR_draco_mesh_compression. */
struct packed_mesh;

/* How many triangles the data say that they have, before any memory is taken for them. Error: these are
 * no such data. */
bool unpack_draco_size(const unsigned char *bytes, size_t size, size_t *triangles);

/* NULL and an error: these are no such data, or others than so many triangles. */
struct packed_mesh *unpack_draco(const unsigned char *bytes, size_t size, size_t triangles);

/* Accepts NULL. */
void packed_mesh_free(struct packed_mesh *packed);

size_t packed_mesh_points(const struct packed_mesh *packed);

/* Writes the numbers of all points, of a type of scene/gltf/accessor.h. Error: there is no such
 * attribute. */
bool packed_mesh_attribute(const struct packed_mesh *packed, int id, int component_type,
                           int components, void *to);

/* Writes three a triangle. Error: there are more points than the type counts. */
bool packed_mesh_indices(const struct packed_mesh *packed, int component_type, void *to);

#endif
