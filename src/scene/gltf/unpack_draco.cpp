/* The bridge to Draco. No exception leaves it. */
extern "C" {
#include "scene/gltf/unpack.h"

#include "base/error.h"
#include "scene/gltf/accessor.h"
}

#include <draco/compression/decode.h>

#include <cstring>

struct packed_mesh {
    std::unique_ptr<draco::Mesh> mesh;
};

namespace {

/* Seven bits a byte, the lowest first. */
bool read_number(const unsigned char *&at, const unsigned char *end, uint64_t &number) {
    number = 0;
    for (int shift = 0; at < end && shift < 35; shift += 7) {
        number |= uint64_t(*at & 127) << shift;
        if (!(*at++ & 128))
            return true;
    }
    return false;
}

bool skip_bytes(const unsigned char *&at, const unsigned char *end, uint64_t count) {
    if (count > uint64_t(end - at))
        return false;
    at += count;
    return true;
}

bool skip_name(const unsigned char *&at, const unsigned char *end) {
    return at < end && skip_bytes(at, end, uint64_t(*at) + 1);
}

/* Entries of a name and bytes each, then others of the kind with a name each. */
bool skip_metadata(const unsigned char *&at, const unsigned char *end, int depth) {
    uint64_t count, size;
    if (depth > 8 || !read_number(at, end, count))
        return false;
    for (uint64_t i = 0; i < count; i++)
        if (!skip_name(at, end) || !read_number(at, end, size) || !skip_bytes(at, end, size))
            return false;
    if (!read_number(at, end, count))
        return false;
    for (uint64_t i = 0; i < count; i++)
        if (!skip_name(at, end) || !skip_metadata(at, end, depth + 1))
            return false;
    return true;
}

/* Those of attributes, each after a number, then those of the mesh. */
bool skip_all_metadata(const unsigned char *&at, const unsigned char *end) {
    uint64_t count, number;
    if (!read_number(at, end, count))
        return false;
    for (uint64_t i = 0; i < count; i++)
        if (!read_number(at, end, number) || !skip_metadata(at, end, 0))
            return false;
    return skip_metadata(at, end, 0);
}

/* The library takes memory for as many triangles and vertices as a header says, so that is read
 * first: magic, version, kind, method, flags, metadata; then, of one method after a byte, two
 * numbers. */
bool read_header(const unsigned char *bytes, size_t size, uint64_t &triangles) {
    enum { MESH = 1, SEQUENTIAL = 0, METADATA = 0x80 };
    if (size < 12 || memcmp(bytes, "DRACO", 5) != 0 || bytes[5] != 2 || bytes[6] != 2 ||
        bytes[7] != MESH)
        return error_set("it is no mesh of Draco 2.2");
    bool sequential = bytes[8] == SEQUENTIAL;
    const unsigned char *at = bytes + 11, *end = bytes + size;
    uint64_t first, second;
    if (((bytes[10] & METADATA) && !skip_all_metadata(at, end)) ||
        !skip_bytes(at, end, sequential ? 0 : 1) || !read_number(at, end, first) ||
        !read_number(at, end, second))
        return error_set("it is truncated");
    uint64_t vertices = sequential ? second : first;
    triangles = sequential ? first : second;
    return vertices <= 3 * triangles ||
           error_set("%llu triangles of %llu vertices", (unsigned long long)triangles,
                     (unsigned long long)vertices);
}

template <typename T>
bool convert(const draco::Mesh &mesh, const draco::PointAttribute &from, int components, void *to) {
    T *out = static_cast<T *>(to);
    for (draco::PointIndex i(0); i < mesh.num_points(); i++, out += components)
        if (!from.ConvertValue<T>(from.mapped_index(i), int8_t(components), out))
            return error_set("point %u cannot be converted", i.value());
    return true;
}

template <typename T> void copy_indices(const draco::Mesh &mesh, void *to) {
    T *out = static_cast<T *>(to);
    for (draco::FaceIndex f(0); f < mesh.num_faces(); f++)
        for (int k = 0; k < 3; k++)
            *out++ = T(mesh.face(f)[size_t(k)].value());
}

} // namespace

extern "C" bool unpack_draco_size(const unsigned char *bytes, size_t size, size_t *triangles) {
    uint64_t count;
    if (!read_header(bytes, size, count))
        return false;
    *triangles = size_t(count);
    return true;
}

extern "C" struct packed_mesh *unpack_draco(const unsigned char *bytes, size_t size,
                                            size_t triangles) try {
    uint64_t count;
    if (!read_header(bytes, size, count))
        return nullptr;
    if (count != triangles) {
        error_set("%llu triangles, not %zu", (unsigned long long)count, triangles);
        return nullptr;
    }
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char *>(bytes), size);
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok() || decoded.value()->num_faces() != triangles) {
        error_set("%.100s",
                  decoded.ok() ? "other triangles than it says" : decoded.status().error_msg());
        return nullptr;
    }
    return new packed_mesh{std::move(decoded).value()};
} catch (const std::exception &error) {
    error_set("%s", error.what());
    return nullptr;
}

extern "C" size_t packed_mesh_points(const struct packed_mesh *packed) {
    return packed->mesh->num_points();
}

extern "C" bool packed_mesh_attribute(const struct packed_mesh *packed, int id, int component_type,
                                      int components, void *to) {
    const draco::Mesh &mesh = *packed->mesh;
    const draco::PointAttribute *from =
        id < 0 ? nullptr : mesh.GetAttributeByUniqueId(uint32_t(id));
    if (!from)
        return error_set("there is no attribute %d", id);
    switch (component_type) {
    case COMPONENT_BYTE:
        return convert<int8_t>(mesh, *from, components, to);
    case COMPONENT_UBYTE:
        return convert<uint8_t>(mesh, *from, components, to);
    case COMPONENT_SHORT:
        return convert<int16_t>(mesh, *from, components, to);
    case COMPONENT_USHORT:
        return convert<uint16_t>(mesh, *from, components, to);
    case COMPONENT_UINT:
        return convert<uint32_t>(mesh, *from, components, to);
    default:
        return convert<float>(mesh, *from, components, to);
    }
}

extern "C" bool packed_mesh_indices(const struct packed_mesh *packed, int component_type,
                                    void *to) {
    size_t size = component_size(component_type);
    if (component_type == COMPONENT_FLOAT || packed->mesh->num_points() > uint64_t(1) << 8 * size)
        return error_set("%zu points, which its indices cannot count", packed_mesh_points(packed));
    if (size == 1)
        copy_indices<uint8_t>(*packed->mesh, to);
    else if (size == 2)
        copy_indices<uint16_t>(*packed->mesh, to);
    else
        copy_indices<uint32_t>(*packed->mesh, to);
    return true;
}

extern "C" void packed_mesh_free(struct packed_mesh *packed) {
    delete packed;
}
