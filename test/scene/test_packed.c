/* Compressed glTF files, packed here by the libraries' own encoders, and what is wrong with some */
#include "gltf_parts.h"

#include "scene/gltf/accessor.h"
#include "scene/gltf/unpack.h"
#include "scene/read_rules.h"

#include <meshoptimizer.h>

/* Where the packed vertices and triangles lie in the test's own bytes. */
enum { PACKED_INDICES_AT = 192 };

static const float corners[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}};
static const unsigned triangles[6] = {0, 1, 2, 0, 2, 3};

struct packed_quad {
    unsigned char bytes[256];
    size_t vertices, indices; /* sizes */
    const char *extension;    /* NULL: EXT_meshopt_compression */
};

static struct packed_quad pack_quad(void) {
    struct packed_quad quad = {{0}, 0, 0, NULL};
    quad.vertices =
        meshopt_encodeVertexBuffer(quad.bytes, PACKED_INDICES_AT, corners, 4, sizeof *corners);
    meshopt_encodeIndexVersion(1);
    quad.indices = meshopt_encodeIndexBuffer(quad.bytes + PACKED_INDICES_AT,
                                             sizeof quad.bytes - PACKED_INDICES_AT, triangles, 6);
    assert_true(quad.vertices > 0 && quad.indices > 0);
    return quad;
}

#define MARK ", extensions: {EXT_meshopt_compression: {fallback: true}}"

/* Its views lie in a buffer that is not there, with the mark of that or without; `count` vertices
 * are said to be packed. */
static bool load_marked(struct scene *scene, const struct packed_quad *quad, int count,
                        const char *mark) {
    const char *extension = quad->extension ? quad->extension : "EXT_meshopt_compression";
    char required[64];
    const char *buffers = form("[{byteLength: 320}, {byteLength: 60%s}]", mark);
    char views[1024];
    snprintf(views, sizeof views,
             "[{buffer: 1, byteLength: 48, extensions: {'%s': {buffer: 0, byteOffset: 64, "
             "byteLength: %zu, byteStride: 12, count: %d, mode: ATTRIBUTES}}}, {buffer: 1, "
             "byteOffset: 48, byteLength: 12, extensions: {'%s': {buffer: 0, byteOffset: %d, "
             "byteLength: %zu, byteStride: 2, count: 6, mode: TRIANGLES}}}]",
             extension, quad->vertices, count, extension, 64 + PACKED_INDICES_AT, quad->indices);
    snprintf(required, sizeof required, "extensionsRequired: ['%s'],", extension);
    return load_parts(
        scene, "meshopt.glb",
        &PARTS(.buffers = buffers, .views = views,
               .accessors = "[{bufferView: 0, componentType: 5126, count: 4, type: VEC3}, "
                            "{bufferView: 1, componentType: 5123, count: 6, type: SCALAR}]",
               .more = required, .extra = quad->bytes, .extra_size = sizeof quad->bytes));
}

static bool load_quad(struct scene *scene, const struct packed_quad *quad, int count) {
    return load_marked(scene, quad, count, MARK);
}

static void check_quad(const struct primitive *quad) {
    assert_int_equal(quad->index_count, 6);
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 3; c++)
            check_near("corner", (double)quad->position[quad->indices[i]][c],
                       (double)corners[triangles[i]][c], 1e-4);
}

TEST(meshopt) {
    struct packed_quad quad = pack_quad();
    struct scene scene;
    check_ok("load", load_quad(&scene, &quad, 4));
    check_quad(&scene.meshes[0].primitives[0]);
    assert_int_equal(scene.file_count, 0);
    scene_free(&scene);
    /* The mark is optional. */
    static const char *const marks[] = {"", ", extensions: {EXT_meshopt_compression: {}}",
                                        ", extras: 1"};
    for (int i = 0; i < 3; i++) {
        check_ok(marks[i], load_marked(&scene, &quad, 4, marks[i]));
        check_quad(&scene.meshes[0].primitives[0]);
        scene_free(&scene);
    }
}

TEST(bad_meshopt) {
    struct scene scene;
    struct packed_quad quad = pack_quad();
    check_refused(load_quad(&scene, &quad, 5),
                  "buffer view 0: EXT_meshopt_compression: 5 elements");
    quad.bytes[0] ^= 0x55;
    check_refused(load_quad(&scene, &quad, 4), "buffer view 0: EXT_meshopt_compression: ");
    quad = pack_quad();
    quad.indices = 3;
    check_refused(load_quad(&scene, &quad, 4), "buffer view 1: EXT_meshopt_compression: 3 bytes");
    quad.indices = 3000;
    check_refused(load_quad(&scene, &quad, 4), "3000 bytes at 256 are outside buffer 0 of 320");
}

/* What the library's own filter makes of the same bytes. */
static void check_filter(const char *what, enum packed_filter filter, size_t stride,
                         void (*decode)(void *, size_t, size_t)) {
    enum { COUNT = 8 };
    unsigned char plain[COUNT * 16], packed[512], got[COUNT * 16];
    for (size_t i = 0; i < sizeof plain; i++)
        plain[i] = (unsigned char)(i * 29 % 127);
    size_t size = meshopt_encodeVertexBuffer(packed, sizeof packed, plain, COUNT, stride);
    const struct packed_view view = {
        .bytes = packed, .size = size, .count = COUNT, .stride = stride, .filter = filter};
    check_ok(what, unpack_meshopt(&view, got));
    if (decode)
        decode(plain, COUNT, stride);
    assert_memory_equal(got, plain, COUNT * stride);
}

TEST(filters) {
    check_filter("as they are", FILTER_NONE, 12, NULL);
    check_filter("octahedral, bytes", FILTER_OCTAHEDRAL, 4, meshopt_decodeFilterOct);
    check_filter("octahedral, words", FILTER_OCTAHEDRAL, 8, meshopt_decodeFilterOct);
    check_filter("quaternions", FILTER_QUATERNION, 8, meshopt_decodeFilterQuat);
    check_filter("exponents", FILTER_EXPONENTIAL, 12, meshopt_decodeFilterExp);
}

/* --- version 1, by hand from the appendices of KHR_meshopt_compression --- */

/* The corners: bytes as they are and one bit each; x as differences of bytes, y as XOR turned by 8
 * bits, z still. */
static const unsigned char corners_v1[] = {
    0xa1, 0xea, 0x6b, 0xaa, 0x00, 0x80, 0x00, 0x7f, 0x00, 0x00, 0x40, 0x00, 0x00, 0x04,
    0x00, 0x40, 0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,
    0,    0,    0,    0,    0,    0,    0,    0,    0,    0x00, 0x82, 0x00};

/* The standard's example of four bits each, for the first byte of 16 elements of four. */
static const unsigned char four_bits[] = {
    0xa1, 0xa8, 0x03, 0x17, 0x5f, 0xf0, 0xbc, 0x77, 0xa9, 0x21, 0x00, 0x34, 0xb5, 0, 0, 0, 0, 0, 0,
    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0, 0, 0, 0, 0};

/* Two elements of two words: 1 + 299 and 300 - 1; 0 and 0. */
static const unsigned char words[] = {0xa1, 0xaf, 0x56, 0x01, 0x02, 0x00, 0, 0, 0, 0,
                                      0,    0,    0,    0,    0,    0,    0, 0, 0, 0,
                                      0,    0,    0,    0,    0,    1,    0, 0, 0, 1};

TEST(meshopt_v1) {
    static const int steps[16] = {-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0};
    unsigned char got[64], value = 0;
    struct packed_view view = {
        .bytes = four_bits, .size = sizeof four_bits, .count = 16, .stride = 4};
    check_ok("four bits", unpack_meshopt(&view, got));
    for (int i = 0; i < 16; i++) {
        value = (unsigned char)(value + steps[i]);
        assert_int_equal(got[4 * i], value);
        assert_int_equal(got[4 * i + 3], 0);
    }
    view = (struct packed_view){.bytes = words, .size = sizeof words, .count = 2, .stride = 4};
    check_ok("words", unpack_meshopt(&view, got));
    assert_memory_equal(got, ((const uint16_t[]){300, 0, 299, 0}), 8);
    struct packed_quad quad = pack_quad();
    OWNED(scene) scene;
    memcpy(quad.bytes, corners_v1, quad.vertices = sizeof corners_v1);
    quad.extension = "KHR_meshopt_compression";
    check_ok("quad", load_quad(&scene, &quad, 4));
    check_quad(&scene.meshes[0].primitives[0]);
}

/* Cut, too long, or of a mode that there is not. */
TEST(bad_meshopt_v1) {
    unsigned char bytes[sizeof corners_v1 + 1] = {0}, got[48];
    for (size_t size = 1; size <= sizeof bytes; size++) {
        struct packed_view view = {.bytes = bytes, .size = size, .count = 4, .stride = 12};
        memset(bytes, 0, sizeof bytes);
        memcpy(bytes, corners_v1, size < 16 ? size : 16); /* then the tail */
        if (size > 24)
            bytes[size - 2] = 0x82;
        assert_int_equal(unpack_meshopt(&view, got), size == sizeof corners_v1);
    }
    static const unsigned char modes[] = {0x03, 0x10, 0x11};
    for (int i = 0; i < 3; i++) {
        struct packed_view view = {
            .bytes = bytes, .size = sizeof corners_v1, .count = 4, .stride = 12};
        memcpy(bytes, corners_v1, sizeof corners_v1);
        bytes[sizeof corners_v1 - 1] = modes[i];
        check_refused(unpack_meshopt(&view, got), "40 bytes are no 4 packed elements");
    }
}

/* R = Y + Co - Cg, G = Y + Cg, B = Y - Co - Cg. Bytes hold 8 bits, words hold 4. */
TEST(colors) {
    unsigned char bytes[4] = {110, 80, (unsigned char)-10, 255};
    int16_t numbers[4] = {7, 3, -2, 13};
    unpack_meshopt_color(&(struct packed_view){.count = 1, .stride = 4}, bytes);
    unpack_meshopt_color(&(struct packed_view){.count = 1, .stride = 8}, (unsigned char *)numbers);
    assert_memory_equal(bytes, ((const unsigned char[]){200, 100, 40, 255}), 4);
    assert_memory_equal(numbers, ((const uint16_t[]){52428, 21845, 26214, 48059}), 8);
}

/* A list of indices that are no triangles, of two bytes and of four. */
TEST(sequence) {
    static const unsigned expected[] = {3, 1, 4, 1, 5};
    unsigned char packed[64];
    uint16_t shorts[5];
    uint32_t words[5];
    meshopt_encodeIndexVersion(1);
    size_t size = meshopt_encodeIndexSequence(packed, sizeof packed, expected, 5);
    struct packed_view view = {
        .bytes = packed, .size = size, .count = 5, .stride = 2, .mode = PACKED_INDICES};
    check_ok("of two bytes", unpack_meshopt(&view, (unsigned char *)shorts));
    view.stride = 4;
    check_ok("of four", unpack_meshopt(&view, (unsigned char *)words));
    for (int i = 0; i < 5; i++)
        assert_true(shorts[i] == expected[i] && words[i] == expected[i]);
}

/* Sizes that a mode or a filter does not have are refused before anything is unpacked. */
TEST(sizes) {
    static const struct {
        struct packed_view view;
        const char *message;
    } bad[] = {
        {{.count = 1, .stride = 0}, "elements of 0 bytes"},
        {{.count = 1, .stride = 6}, "elements of 6 bytes"},
        {{.count = 1, .stride = 260}, "elements of 260 bytes"},
        {{.count = 3, .stride = 3, .mode = PACKED_TRIANGLES}, "elements of 3 bytes"},
        {{.count = 4, .stride = 2, .mode = PACKED_TRIANGLES}, "4 indices make no whole triangles"},
        {{.count = 3, .stride = 8, .mode = PACKED_INDICES}, "elements of 8 bytes"},
        {{.count = 1, .stride = 12, .filter = FILTER_OCTAHEDRAL}, "elements of 12 bytes"},
        {{.count = 1, .stride = 4, .filter = FILTER_QUATERNION}, "elements of 4 bytes"},
        {{.count = 3, .stride = 4, .mode = PACKED_INDICES, .filter = FILTER_EXPONENTIAL},
         "a filter of indices"},
        {{.count = 3, .stride = 4, .mode = PACKED_TRIANGLES, .filter = FILTER_OCTAHEDRAL},
         "a filter of indices"},
    };
    unsigned char to[1024];
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        check_refused(unpack_meshopt(&bad[i].view, to), bad[i].message);
}

/* Room for what a file says it unpacks to counts against what the scene may take. */
TEST(endless) {
    struct scene scene;
    bool loaded = load_parts(
        &scene, "endless.glb",
        &PARTS(.buffers = "[{byteLength: 320}, {byteLength: 100000000000}]",
               .views =
                   "[{buffer: 1, byteLength: 48, extensions: {EXT_meshopt_compression: {buffer: 0, "
                   "byteLength: 64, byteStride: 12, count: 4, mode: ATTRIBUTES}}}]"));
    check_refused(loaded, "buffer 1: 95367.4 MiB of memory are wanted");
}

/* The same quad by Draco's two methods, of positions of 14 bits. */
static const unsigned char edgebreaker[] = {
    0x44, 0x52, 0x41, 0x43, 0x4f, 0x02, 0x02, 0x01, 0x01, 0x00, 0x00, 0x00, 0x04, 0x02, 0x00,
    0x02, 0x00, 0x00, 0x01, 0x1f, 0xff, 0x01, 0x11, 0x01, 0xff, 0x00, 0x00, 0x01, 0x00, 0x09,
    0x03, 0x00, 0x00, 0x02, 0x01, 0x01, 0x01, 0x00, 0x0f, 0x03, 0x01, 0x20, 0x2f, 0x01, 0x20,
    0x03, 0x00, 0xf0, 0x83, 0x58, 0x55, 0x03, 0x00, 0x00, 0x80, 0x55, 0x05, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0xff, 0x3f, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x40, 0x0e};
static const unsigned char sequential[] = {
    0x44, 0x52, 0x41, 0x43, 0x4f, 0x02, 0x02, 0x01, 0x00, 0x00, 0x00, 0x02, 0x04, 0x01, 0x00, 0x01,
    0x02, 0x00, 0x02, 0x03, 0x01, 0x01, 0x00, 0x09, 0x03, 0x00, 0x00, 0x02, 0x00, 0x01, 0x01, 0x00,
    0x0f, 0x03, 0x01, 0x20, 0x2f, 0x01, 0x20, 0x03, 0x00, 0x10, 0x84, 0x58, 0x55, 0x01, 0x00, 0x00,
    0x40, 0xac, 0x2a, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xff, 0x3f, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x40, 0x0e};

static bool load_draco(struct scene *scene, const unsigned char *bytes, size_t size, int indices) {
    const char *views = form("[{buffer: 0, byteOffset: 64, byteLength: %zu}]", size);
    const char *accessors = form("[{componentType: 5126, count: 4, type: VEC3}, {componentType: "
                                 "5121, count: %d, type: SCALAR}]",
                                 indices);
    return load_parts(
        scene, "draco.glb",
        &PARTS(.views = views, .accessors = accessors,
               .meshes =
                   "[{primitives: [{attributes: {POSITION: 0}, indices: 1, extensions: "
                   "{KHR_draco_mesh_compression: {bufferView: 0, attributes: {POSITION: 0}}}}]}]",
               .more = "extensionsRequired: [KHR_draco_mesh_compression],", .extra = bytes,
               .extra_size = size));
}

/* The two triangles may begin at any of their corners. */
static void check_draco(const char *what, const unsigned char *bytes, size_t size) {
    OWNED(scene) scene;
    check_ok(what, load_draco(&scene, bytes, size, 6));
    const struct primitive *quad = &scene.meshes[0].primitives[0];
    assert_int_equal(quad->index_count, 6);
    double area = 0;
    for (int t = 0; t < 2; t++) {
        const float *a = quad->position[quad->indices[t * 3]],
                    *b = quad->position[quad->indices[t * 3 + 1]],
                    *c = quad->position[quad->indices[t * 3 + 2]];
        area += (double)((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
        check_near("z", (double)a[2], 0, 1e-6);
    }
    check_near("area, counter-clockwise", area, 6, 1e-3);
}

TEST(draco) {
    check_draco("edgebreaker", edgebreaker, sizeof edgebreaker);
    check_draco("sequential", sequential, sizeof sequential);
}

#define CHECK_POINTS(type, name)                                                                   \
    do {                                                                                           \
        type numbers[12];                                                                          \
        check_ok("points as " #type, packed_mesh_attribute(mesh, 0, name, 3, numbers));            \
        double sum = 0;                                                                            \
        for (int i = 0; i < 12; i++)                                                               \
            sum += (double)numbers[i];                                                             \
        check_near("sum of the corners", sum, 10, 2.1); /* whole numbers cut what is 2.9999 */     \
    } while (0)

/* Points and triangles as each type of a glTF file. */
TEST(draco_types) {
    struct packed_mesh *mesh = unpack_draco(edgebreaker, sizeof edgebreaker, 2);
    assert_non_null(mesh);
    CHECK_POINTS(int8_t, COMPONENT_BYTE);
    CHECK_POINTS(uint8_t, COMPONENT_UBYTE);
    CHECK_POINTS(int16_t, COMPONENT_SHORT);
    CHECK_POINTS(uint16_t, COMPONENT_USHORT);
    CHECK_POINTS(uint32_t, COMPONENT_UINT);
    CHECK_POINTS(float, COMPONENT_FLOAT);
    uint8_t bytes[6];
    uint16_t shorts[6];
    uint32_t words[6];
    check_ok("bytes", packed_mesh_indices(mesh, COMPONENT_UBYTE, bytes));
    check_ok("shorts", packed_mesh_indices(mesh, COMPONENT_USHORT, shorts));
    check_ok("words", packed_mesh_indices(mesh, COMPONENT_UINT, words));
    for (int i = 0; i < 6; i++)
        assert_true(bytes[i] < 4 && bytes[i] == shorts[i] && bytes[i] == words[i]);
    check_refused(packed_mesh_indices(mesh, COMPONENT_FLOAT, words), "4 points, which its");
    check_refused(packed_mesh_attribute(mesh, 5, COMPONENT_FLOAT, 3, words), "no attribute 5");
    check_refused(packed_mesh_attribute(mesh, -1, COMPONENT_FLOAT, 3, words), "no attribute -1");
    packed_mesh_free(mesh);
}

/* What the bytes before the mesh say. */
TEST(draco_header) {
    unsigned char bytes[sizeof edgebreaker];
    static const struct {
        int at;
        unsigned char byte;
        const char *message;
    } bad[] = {{0, 'd', "it is no mesh"},    {5, 1, "it is no mesh"},       {6, 1, "it is no mesh"},
               {7, 0, "it is no mesh"},      {10, 0x80, "it is truncated"}, {12, 0xff, "triangles"},
               {13, 3, "3 triangles, not 2"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        memcpy(bytes, edgebreaker, sizeof bytes);
        bytes[bad[i].at] = bad[i].byte;
        check_refused(unpack_draco(bytes, sizeof bytes, 2) != NULL, bad[i].message);
    }
    memset(bytes + 12, 0xff, 12);
    check_refused(unpack_draco(bytes, 24, 2) != NULL, "it is truncated");
    check_refused(unpack_draco(bytes, 12, 2) != NULL, "it is truncated");
    check_refused(unpack_draco(bytes, 11, 2) != NULL, "it is no mesh");
}

static bool load_draco_with(struct scene *scene, const char *accessors, const char *primitive) {
    const char *views = form("[{buffer: 0, byteOffset: 64, byteLength: %zu}]", sizeof edgebreaker);
    return load_parts(scene, "draco.glb",
                      &PARTS(.views = views, .accessors = accessors, .meshes = primitive,
                             .more = "extensionsRequired: [KHR_draco_mesh_compression],",
                             EXTRA(edgebreaker)));
}

#define DRACO(names)                                                                               \
    "extensions: {KHR_draco_mesh_compression: {bufferView: 0, attributes: {" names "}}}"
#define CORNERS "{componentType: 5126, count: 4, type: VEC3}"

static void check_opens(const char *what, bool opened, struct scene *scene) {
    check_ok(what, opened);
    check_near(what, scene->meshes[0].primitives[0].index_count, 6, 0);
    scene_free(scene);
}

/* What the data hold counts, whatever the accessors say; there need be no indices. */
TEST(draco_and_file) {
    static const char accessors[] = "[" CORNERS ", {componentType: 5121, count: 6, type: SCALAR}]";
    static const char fewer[] = "[{componentType: 5126, count: 3, type: VEC3}, {componentType: "
                                "5121, count: 300, type: SCALAR}]";
    static const char plain[] =
        "[{primitives: [{attributes: {POSITION: 0}, indices: 1, " DRACO("POSITION: 0") "}]}]";
    OWNED(scene) scene;
    check_opens(
        "no indices",
        load_draco_with(&scene, accessors,
                        "[{primitives: [{attributes: {POSITION: 0}, " DRACO("POSITION: 0") "}]}]"),
        &scene);
    check_opens("other counts", load_draco_with(&scene, fewer, plain), &scene);
    check_ok("strict", read_rules_set(true, NULL));
    check_refused(load_draco_with(&scene, fewer, plain),
                  "mesh 0: primitive 0: POSITION: 4, not 3 (accessors of another count");
    check_ok("not strict", read_rules_set(false, NULL));
    check_refused(load_draco_with(&scene, accessors,
                                  "[{primitives: [{mode: 5, attributes: {POSITION: 0}, " DRACO(
                                      "POSITION: 0") "}]}]"),
                  "it has no triangles");
    check_refused(load_draco_with(&scene, accessors,
                                  "[{primitives: [{attributes: {POSITION: 0}, indices: 1, " DRACO(
                                      "POSITION: 7") "}]}]"),
                  "POSITION: there is no attribute 7");
    /* A name that the primitive does not have is nobody's. */
    check_ok("another name",
             load_draco_with(&scene, accessors,
                             "[{primitives: [{attributes: {POSITION: 0}, indices: 1, " DRACO(
                                 "POSITION: 0, NORMAL: 0") "}]}]"));
}

TEST(bad_draco) {
    struct scene scene;
    check_opens("too many indices", load_draco(&scene, edgebreaker, sizeof edgebreaker, 9), &scene);
    /* Metadata of no attribute and without entries: a flag and three zeros before the data. */
    unsigned char with[sizeof edgebreaker + 3] = {0};
    memcpy(with, edgebreaker, 11);
    with[10] = 0x80;
    memcpy(with + 14, edgebreaker + 11, sizeof edgebreaker - 11);
    check_opens("metadata", load_draco(&scene, with, sizeof with, 6), &scene);
    with[11] = 200;
    check_refused(load_draco(&scene, with, sizeof with, 6), "it is truncated");
    check_refused(load_draco(&scene, edgebreaker, 60, 6), "KHR_draco_mesh_compression: ");
    check_refused(load_draco(&scene, (const unsigned char *)"DRACO", 5, 6),
                  "it is no mesh of Draco 2.2");
    /* Whatever else they say, loading ends. */
    unsigned char bytes[sizeof edgebreaker];
    int loaded = 0;
    for (size_t i = 0; i < 8 * sizeof bytes; i++) {
        memcpy(bytes, edgebreaker, sizeof bytes);
        bytes[i / 8] ^= (unsigned char)(1 << i % 8);
        bool good = load_draco(&scene, bytes, sizeof bytes, 6);
        loaded += good;
        if (good)
            scene_free(&scene);
        else
            assert_non_null(strstr(error_get(), "draco.glb"));
    }
    printf("    %d of %zu files with another bit loaded\n", loaded, 8 * sizeof bytes);
    assert_true(loaded > 0);
}

RUN_TESTS(be_quiet, NULL)
