/* The portable program has no libraries that unpack: such files are refused. */
#include "scene/gltf/unpack.h"

#include "base/error.h"

bool unpack_meshopt(const struct packed_view *view, unsigned char *to) {
    (void)view, (void)to;
    return error_set("EXT_meshopt_compression is not read by this build");
}

bool unpack_draco_size(const unsigned char *bytes, size_t size, size_t *triangles) {
    (void)bytes, (void)size, (void)triangles;
    return error_set("KHR_draco_mesh_compression is not read by this build");
}

struct packed_mesh *unpack_draco(const unsigned char *bytes, size_t size, size_t triangles) {
    (void)bytes, (void)size, (void)triangles;
    error_set("KHR_draco_mesh_compression is not read by this build");
    return 0;
}

/* Of what there is none. */
void packed_mesh_free(struct packed_mesh *packed) {
    (void)packed;
}

size_t packed_mesh_points(const struct packed_mesh *packed) {
    (void)packed;
    return 0;
}

bool packed_mesh_attribute(const struct packed_mesh *packed, int id, int component_type,
                           int components, void *to) {
    (void)packed, (void)id, (void)component_type, (void)components, (void)to;
    return false;
}

bool packed_mesh_indices(const struct packed_mesh *packed, int component_type, void *to) {
    (void)packed, (void)component_type, (void)to;
    return false;
}
