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

int main(void) {
    log_set_level(LOG_QUIET);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_meshopt),
        cmocka_unit_test(test_bad_meshopt),
        cmocka_unit_test(test_endless),
    };
    return cmocka_run_group_tests_name("packed", tests, NULL, NULL);
}
