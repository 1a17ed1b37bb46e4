/* The highlight of a smooth ball under a sun has its whole energy in pictures of all sizes. */
#include "render_support.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>

enum { RINGS = 48, SECTORS = 96, VERTICES = (RINGS + 1) * (SECTORS + 1) };

/* Radius .4 m: positions, then normals, then triangles. */
static struct ball {
    float position[VERTICES][3], normal[VERTICES][3];
    uint16_t indices[6 * RINGS * SECTORS];
} ball;

static void make_ball(void) {
    uint16_t *index = ball.indices;
    for (int i = 0; i < VERTICES; i++) {
        float down = GLM_PIf * (float)(i / (SECTORS + 1)) / RINGS;
        float round = 2 * GLM_PIf * (float)(i % (SECTORS + 1)) / SECTORS;
        float normal[3] = {sinf(down) * cosf(round), cosf(down), -sinf(down) * sinf(round)};
        for (int c = 0; c < 3; c++) {
            ball.normal[i][c] = normal[c];
            ball.position[i][c] = .4F * normal[c];
        }
    }
    for (int ring = 0; ring < RINGS; ring++)
        for (int sector = 0; sector < SECTORS; sector++) {
            int a = ring * (SECTORS + 1) + sector, b = a + SECTORS + 1;
            const int corners[6] = {a, b, b + 1, a, b + 1, a + 1};
            for (int k = 0; k < 6; k++)
                *index++ = (uint16_t)corners[k];
        }
}

static void write_file(const char *name, const void *bytes, size_t size) {
    FILE *file = fopen(scratch(name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

/* A white metal under a sun of pi W/m2, seen by an orthographic camera of 1 x 1 m. */
static const char *write_ball(double roughness) {
    char text[2048];
    int size = snprintf(
        text, sizeof text,
        "{\"asset\": {\"version\": \"2.0\"}, \"scenes\": [{\"nodes\": [0, 1, 2]}],"
        " \"buffers\": [{\"uri\": \"ball.bin\", \"byteLength\": %zu}],"
        " \"bufferViews\": [{\"buffer\": 0, \"byteLength\": %zu}, {\"buffer\": 0, \"byteOffset\": "
        "%zu,"
        " \"byteLength\": %zu}], \"accessors\": [{\"bufferView\": 0, \"componentType\": 5126,"
        " \"count\": %d, \"type\": \"VEC3\", \"min\": [-0.4, -0.4, -0.4], \"max\": [0.4, 0.4, "
        "0.4]},"
        " {\"bufferView\": 0, \"byteOffset\": %zu, \"componentType\": 5126, \"count\": %d, "
        "\"type\":"
        " \"VEC3\"}, {\"bufferView\": 1, \"componentType\": 5123, \"count\": %d, \"type\": "
        "\"SCALAR\"}],"
        " \"materials\": [{\"pbrMetallicRoughness\": {\"roughnessFactor\": %g}}], \"meshes\":"
        " [{\"primitives\": [{\"attributes\": {\"POSITION\": 0, \"NORMAL\": 1}, \"indices\": 2,"
        " \"material\": 0}]}], \"cameras\": [{\"type\": \"orthographic\", \"orthographic\": "
        "{\"xmag\": 0.5,"
        " \"ymag\": 0.5, \"znear\": 0.1, \"zfar\": 10}}], \"extensionsUsed\": "
        "[\"KHR_lights_punctual\"],"
        " \"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"directional\","
        " \"intensity\": 3.14159265}]}}, \"nodes\": [{\"mesh\": 0}, {\"camera\": 0, "
        "\"translation\":"
        " [0, 0, 3]}, {\"rotation\": [-0.2588190451, 0, 0, 0.9659258263], \"extensions\":"
        " {\"KHR_lights_punctual\": {\"light\": 0}}}]}",
        sizeof ball, offsetof(struct ball, indices), offsetof(struct ball, indices),
        sizeof ball.indices, VERTICES, offsetof(struct ball, normal), VERTICES, 6 * RINGS * SECTORS,
        roughness);
    write_file("ball.bin", &ball, sizeof ball);
    write_file("ball.gltf", text, (size_t)size);
    return scratch("ball.gltf");
}

/* Over the whole picture. */
static double mean_of(const struct image *image, const char *channel) {
    int number = image_find_channel(image, channel);
    double sum = 0;
    assert_true(number >= 0);
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            sum += (double)image_at(image, x, y)[number];
    return sum / image->width / image->height;
}

/* A mirror ball of radius r reflects E pi r^2 evenly to all sides, so that it looks as bright as E r^2 / 4 W/sr.
 * Without the spread of a pixel 3 to 50 % of that are drawn at roughness 0. */
static void test_ball(void **state) {
    (void)state;
    static const double roughness[] = {0, .1, .2};
    static const int sizes[] = {64, 65, 128};
    make_ball();
    for (int i = 0; i < 9; i++) {
        struct stage stage;
        char what[64];
        if (!is_tried_here(i, 3))
            continue;
        open_stage(&stage, write_ball(roughness[i / 3]));
        struct image drawn = render_stage(&stage, "clustered", "", sizes[i % 3]);
        snprintf(what, sizeof what, "roughness %g, %d pixels", roughness[i / 3], sizes[i % 3]);
        check_near(what, mean_of(&drawn, "direct.specular.G"), GLM_PI * .4 * .4 / 4,
                   .05 * GLM_PI * .4 * .4 / 4);
        image_free(&drawn);
        stage_free(&stage);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_ball)};
    return cmocka_run_group_tests_name("highlights", tests, open_group_context,
                                       close_group_context);
}
