/* Compressed glTF files, packed here by the libraries' own encoders, and what is wrong with some. */
#include "gltf_parts.h"

#include "base/error.h"
#include "base/log.h"

#include <meshoptimizer.h>

/* Where the packed vertices and triangles lie in the test's own bytes. */
enum { PACKED_INDICES_AT = 192 };

static const float corners[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}};
static const unsigned triangles[6] = {0, 1, 2, 0, 2, 3};

struct packed_quad {
    unsigned char bytes[256];
    size_t vertices, indices; /* sizes */
};

static struct packed_quad pack_quad(void) {
    struct packed_quad quad = {{0}, 0, 0};
    quad.vertices =
        meshopt_encodeVertexBuffer(quad.bytes, PACKED_INDICES_AT, corners, 4, sizeof *corners);
    meshopt_encodeIndexVersion(1);
    quad.indices = meshopt_encodeIndexBuffer(quad.bytes + PACKED_INDICES_AT,
                                             sizeof quad.bytes - PACKED_INDICES_AT, triangles, 6);
    assert_true(quad.vertices > 0 && quad.indices > 0);
    return quad;
}

/* Its views lie in a buffer that is not there; `count` vertices are said to be packed. */
static bool load_quad(struct scene *scene, const struct packed_quad *quad, int count) {
    char views[1024];
    snprintf(
        views, sizeof views,
        "[{\"buffer\": 1, \"byteLength\": 48, \"extensions\": {\"EXT_meshopt_compression\":"
        " {\"buffer\": 0, \"byteOffset\": 64, \"byteLength\": %zu, \"byteStride\": 12, \"count\":"
        " %d, \"mode\": \"ATTRIBUTES\"}}},"
        " {\"buffer\": 1, \"byteOffset\": 48, \"byteLength\": 12, \"extensions\":"
        " {\"EXT_meshopt_compression\": {\"buffer\": 0, \"byteOffset\": %d, \"byteLength\": %zu,"
        " \"byteStride\": 2, \"count\": 6, \"mode\": \"TRIANGLES\"}}}]",
        quad->vertices, count, 64 + PACKED_INDICES_AT, quad->indices);
    return load_parts(
        scene, "meshopt.glb",
        &(struct gltf_parts){
            .buffers = "[{\"byteLength\": 320}, {\"byteLength\": 60, \"extensions\":"
                       " {\"EXT_meshopt_compression\": {\"fallback\": true}}}]",
            .views = views,
            .accessors =
                "[{\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"VEC3\"},"
                " {\"bufferView\": 1, \"componentType\": 5123, \"count\": 6, \"type\":"
                " \"SCALAR\"}]",
            .more = "\"extensionsRequired\": [\"EXT_meshopt_compression\"],",
            .extra = quad->bytes,
            .extra_size = sizeof quad->bytes});
}

static void check_quad(const struct primitive *quad) {
    assert_int_equal(quad->index_count, 6);
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 3; c++)
            check_near("corner", (double)quad->position[quad->indices[i]][c],
                       (double)corners[triangles[i]][c], 1e-4);
}

static void test_meshopt(void **state) {
    (void)state;
    struct packed_quad quad = pack_quad();
    struct scene scene;
    check_ok("load", load_quad(&scene, &quad, 4));
    check_quad(&scene.meshes[0].primitives[0]);
    assert_int_equal(scene.file_count, 0);
    scene_free(&scene);
}

static void check_refused(bool loaded, const char *message) {
    assert_false(loaded);
    printf("    %s\n", error_get());
    assert_non_null(strstr(error_get(), message));
}

static void test_bad_meshopt(void **state) {
    (void)state;
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

/* Room for what a file says it unpacks to counts against what the scene may take. */
static void test_endless(void **state) {
    (void)state;
    struct scene scene;
    bool loaded =
        load_parts(&scene, "endless.glb",
                   &(struct gltf_parts){
                       .buffers = "[{\"byteLength\": 320}, {\"byteLength\": 100000000000,"
                                  " \"extensions\": {\"EXT_meshopt_compression\": {\"fallback\":"
                                  " true}}}]"});
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
    char views[128], accessors[256];
    snprintf(views, sizeof views, "[{\"buffer\": 0, \"byteOffset\": 64, \"byteLength\": %zu}]",
             size);
    snprintf(accessors, sizeof accessors,
             "[{\"componentType\": 5126, \"count\": 4, \"type\": \"VEC3\"},"
             " {\"componentType\": 5121, \"count\": %d, \"type\": \"SCALAR\"}]",
             indices);
    return load_parts(
        scene, "draco.glb",
        &(struct gltf_parts){
            .views = views,
            .accessors = accessors,
            .meshes = "[{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"indices\": 1,"
                      " \"extensions\": {\"KHR_draco_mesh_compression\": {\"bufferView\": 0,"
                      " \"attributes\": {\"POSITION\": 0}}}}]}]",
            .more = "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"],",
            .extra = bytes,
            .extra_size = size});
}

/* The two triangles may begin at any of their corners. */
static void check_draco(const char *what, const unsigned char *bytes, size_t size) {
    struct scene scene;
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
    scene_free(&scene);
}

static void test_draco(void **state) {
    (void)state;
    check_draco("edgebreaker", edgebreaker, sizeof edgebreaker);
    check_draco("sequential", sequential, sizeof sequential);
}

static void test_bad_draco(void **state) {
    (void)state;
    struct scene scene;
    check_refused(
        load_draco(&scene, edgebreaker, sizeof edgebreaker, 9),
        "mesh 0: primitive 0: KHR_draco_mesh_compression: 2 triangles of 4 vertices, not 3");
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

int main(void) {
    log_set_level(LOG_QUIET);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_meshopt),   cmocka_unit_test(test_bad_meshopt),
        cmocka_unit_test(test_endless),   cmocka_unit_test(test_draco),
        cmocka_unit_test(test_bad_draco),
    };
    return cmocka_run_group_tests_name("packed", tests, NULL, NULL);
}
