/* Writes tiny glTF files for tests: a quad in the xy plane unless a part is replaced. */
#ifndef TEST_GLTF_PARTS_H
#define TEST_GLTF_PARTS_H

#include "support.h"

#include "scene/scene.h"

/* What the buffer holds: positions at 0, indices at 48, a place for the test's own bytes at 64. */
enum { PARTS_EXTRA = 64, PARTS_BIN = 64 + 256 };

/* The accessors of the quad: positions, indices. */
#define PARTS_QUAD                                                                                 \
    "{bufferView: 0, componentType: 5126, count: 4, type: VEC3}, {bufferView: 0, byteOffset: 48, " \
    "componentType: 5123, count: 6, type: SCALAR}"

/* Accessors of the quad whose normals, accessor 2, are four vectors of the test's own. */
#define PARTS_OWN_NORMALS                                                                          \
    "[" PARTS_QUAD ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 4, type: VEC3}]"

/* Values of the top-level members, by quote_words; NULL = the quad's. */
struct gltf_parts {
    const char *asset, *buffers, *views, *accessors, *materials, *meshes, *nodes;
    const char *more; /* other members: "\"cameras\": [...], " */
    const void *extra;
    size_t extra_size; /* at most 256 */
};

#define PARTS(...) ((struct gltf_parts){__VA_ARGS__})
#define EXTRA(value) .extra = &(value), .extra_size = sizeof(value)

/* Accessors of a quad with texture coordinates, which are in `extra`. */
#define PARTS_TEXTURED                                                                             \
    "[" PARTS_QUAD ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 4, type: VEC2}]"

static inline const char *parts_or(const char *part, const char *quad) {
    return part ? part : quad;
}

static inline size_t parts_json(const struct gltf_parts *parts, char *json, size_t size) {
    static char text[16384];
    int printed = snprintf(
        text, sizeof text,
        "{asset: %s, %s buffers: %s, bufferViews: %s, accessors: %s, materials: %s, meshes: %s, "
        "nodes: %s}",
        parts_or(parts->asset, "{version: '2.0'}"), parts_or(parts->more, ""),
        parts_or(parts->buffers, "[{byteLength: 320}]"),
        parts_or(parts->views, "[{buffer: 0, byteLength: 320}]"),
        parts_or(parts->accessors, "[" PARTS_QUAD "]"),
        parts_or(parts->materials, "[{pbrMetallicRoughness: {metallicFactor: 0}}]"),
        parts_or(
            parts->meshes,
            "[{name: quad, primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}]"),
        parts_or(parts->nodes, "[{name: one, mesh: 0}]"));
    assert_true(printed > 0 && (size_t)printed < sizeof text);
    size_t length = quote_words(text, json, size - 4);
    while (length % 4)
        json[length++] = ' ';
    json[length] = '\0';
    return length;
}

static inline void parts_bin(const struct gltf_parts *parts, unsigned char bin[PARTS_BIN]) {
    static const float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    static const uint16_t indices[6] = {0, 1, 2, 0, 2, 3};
    assert_true(parts->extra_size <= PARTS_BIN - PARTS_EXTRA);
    memset(bin, 0, PARTS_BIN);
    memcpy(bin, positions, sizeof positions);
    memcpy(bin + 48, indices, sizeof indices);
    if (parts->extra)
        memcpy(bin + PARTS_EXTRA, parts->extra, parts->extra_size);
}

/* The whole .glb in memory; its size. */
static inline size_t parts_glb(const struct gltf_parts *parts, unsigned char *glb, size_t size) {
    static char json[16384];
    unsigned char bin[PARTS_BIN];
    size_t json_size = parts_json(parts, json, sizeof json);
    parts_bin(parts, bin);
    uint32_t head[5] = {0x46546C67, 2, (uint32_t)(28 + json_size + PARTS_BIN), (uint32_t)json_size,
                        0x4E4F534A};
    uint32_t chunk[2] = {PARTS_BIN, 0x004E4942};
    assert_true(head[2] <= size);
    memcpy(glb, head, 20);
    memcpy(glb + 20, json, json_size);
    memcpy(glb + 20 + json_size, chunk, 8);
    memcpy(glb + 28 + json_size, bin, PARTS_BIN);
    return head[2];
}

/* A new file each time: some file systems wait for the disk when an old one is truncated. */
static inline void write_bytes(const char *path, const void *bytes, size_t size) {
    remove(path);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_true(fwrite(bytes, 1, size, file) == size);
    assert_true(fclose(file) == 0);
}

/* Writes the parts as scratch file NAME; its path. */
static inline const char *write_parts(const char *name, const struct gltf_parts *parts) {
    static unsigned char glb[32768];
    const char *path = scratch(name);
    write_bytes(path, glb, parts_glb(parts, glb, sizeof glb));
    return path;
}

/* Writes and loads it. */
static inline bool load_parts(struct scene *scene, const char *name,
                              const struct gltf_parts *parts) {
    return scene_load(scene, write_parts(name, parts));
}

#endif
