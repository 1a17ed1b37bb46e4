/* Decompresses data of glTF files, by bridges to other libraries. */
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

/* A buffer view with EXT_meshopt_compression or KHR_meshopt_compression. */
struct packed_view {
    const unsigned char *bytes;
    size_t size;
    size_t count, stride; /* of the unpacked elements; stride in bytes */
    enum packed_mode mode;
    enum packed_filter filter;
};

/* Writes count x stride bytes. Error: invalid sizes for mode or filter, or invalid data. */
bool unpack_meshopt(const struct packed_view *view, unsigned char *to);

/* Unpacks attributes with a stream of version 1, without the filter. */
enum { MESHOPT_V1 = 0xa1 }; /* first byte of the stream */
bool unpack_meshopt_v1(const struct packed_view *view, unsigned char *to);

/* Undoes the colour filter in place. */
void unpack_meshopt_color(const struct packed_view *view, unsigned char *to);

/* A mesh with KHR_draco_mesh_compression. */
struct packed_mesh;

/* Reads the triangle count from the header, before memory is allocated. Error: invalid data. */
bool unpack_draco_size(const unsigned char *bytes, size_t size, size_t *triangles);

/* Unpacks a mesh. The caller calls packed_mesh_free. Error, NULL: invalid data, or another number
 * of triangles. */
struct packed_mesh *unpack_draco(const unsigned char *bytes, size_t size, size_t triangles);

/* Accepts NULL. */
void packed_mesh_free(struct packed_mesh *packed);

size_t packed_mesh_points(const struct packed_mesh *packed);

/* Writes the attribute of all points. component_type: of scene/gltf/accessor.h. Error: unknown
 * attribute. */
bool packed_mesh_attribute(const struct packed_mesh *packed, int id, int component_type,
                           int components, void *to);

/* Writes three indices a triangle. Error: more points than the type can index. */
bool packed_mesh_indices(const struct packed_mesh *packed, int component_type, void *to);

#endif
