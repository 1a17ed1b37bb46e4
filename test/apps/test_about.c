/* What an EXR file of render and reference tells of its making, read from the bytes of its header;
 * and that its matrices lead from points to pixels. */
#include "command_support.h"

#include "base/file/file.h"
#include "scene/camera.h"

/* The value of an attribute of that name and type, or NULL: OpenEXR File Layout, name, type, size,
 * value. */
static const unsigned char *find_attribute(const struct file_bytes *file, const char *name,
                                           const char *type, int32_t *size) {
    const unsigned char *at = file->data + 8, *end = file->data + file->size;
    while (at < end && *at) {
        const char *found = (const char *)at, *kind = found + strlen(found) + 1;
        const unsigned char *value = (const unsigned char *)kind + strlen(kind) + 1;
        memcpy(size, value, 4);
        if (strcmp(found, name) == 0 && strcmp(kind, type) == 0)
            return value + 4;
        at = value + 4 + *size;
    }
    return NULL;
}

static void check_text(const struct file_bytes *file, const char *name, const char *expected) {
    int32_t size = 0;
    const unsigned char *value = find_attribute(file, name, "string", &size);
    if (!value)
        fail_msg("there is no text %s", name);
    printf("    %-20s %.*s\n", name, size, (const char *)value);
    assert_int_equal(size, strlen(expected));
    assert_memory_equal(value, expected, size);
}

static void read_numbers(const struct file_bytes *file, const char *name, const char *type,
                         float *numbers, int count) {
    int32_t size = 0;
    const unsigned char *value = find_attribute(file, name, type, &size);
    if (!value)
        fail_msg("there is no %s %s", type, name);
    assert_int_equal(size, 4 * count);
    memcpy(numbers, value, (size_t)size);
}

/* A row vector times the matrix, divided by w. */
static void transform(const float matrix[16], const float point[3], float to[3]) {
    float result[4];
    for (int c = 0; c < 4; c++)
        result[c] = point[0] * matrix[c] + point[1] * matrix[4 + c] + point[2] * matrix[8 + c] +
                    matrix[12 + c];
    for (int c = 0; c < 3; c++)
        to[c] = result[c] / result[3];
}

TEST(texts) {
    struct file_bytes file;
    float time, colours[8];
    expect(
        0,
        "% render scenes/moving-spot.glb -o @/a.###.exr --frames 10..11 --time 1 --size 64x48 -q "
        "--camera '0 fov=1' --set vpls=64,vals=8 --direct pcss");
    check_ok("file", file_read(&file, scratch("a.010.exr")));
    check_text(&file, "software", "manylight 0.1");
    check_text(&file, "manylight:scene", "moving-spot.glb");
    check_text(&file, "manylight:camera", "0 fov=1");
    check_text(&file, "manylight:technique", "clustered");
    check_text(&file, "manylight:settings", "lights.vpls=64 clustered.vals=8");
    check_text(&file, "comments",
               "moving-spot.glb, camera 0 fov=1, at 1.4 s, by clustered with lights.vpls=64 "
               "clustered.vals=8");
    read_numbers(&file, "manylight:time", "float", &time, 1);
    check_near("time, s", (double)time, 1.4, 1e-6);
    read_numbers(&file, "chromaticities", "chromaticities", colours, 8);
    check_near("x of red", (double)colours[0], .64, 1e-6);
    check_near("y of white", (double)colours[7], .329, 1e-6);
    free(file.data);
}

/* The same file again, and in another folder. */
TEST(same_file) {
    expect(0, "mkdir -p @/else && cp scenes/cornell-box.glb @/else && sleep 1 && "
              "% reference scenes/cornell-box.glb -o @/b.exr --size 16x16 --spp 2 -q && "
              "% reference @/else/cornell-box.glb -o @/c.exr --size 16x16 --spp 2 -q");
    expect(0, "cmp @/b.exr @/c.exr");
}

/* Points on surfaces, by the depth of the picture and rays of the camera; each lies at the centre
 * of its pixel. */
TEST(pixels) {
    enum { WIDTH = 40, HEIGHT = 30 };
    struct camera camera = {.fov_y = .9F, .near = .1F};
    struct file_bytes file;
    OWNED(image) image;
    float to_camera[16], to_ndc[16];
    double worst_ndc = 0, worst_depth = 0;
    int count = 0;
    expect(0, "% reference scenes/cornell-animal.glb -o @/d.exr --size 40x30 --spp 1 --centers -q "
              "--camera '0 eye=.2,.3,2 forward=-.1,-.2,-1 fov=.9'");
    check_ok("file", file_read(&file, scratch("d.exr")));
    read_numbers(&file, "worldToCamera", "m44f", to_camera, 16);
    read_numbers(&file, "worldToNDC", "m44f", to_ndc, 16);
    check_ok("image", image_read(&image, scratch("d.exr")));
    camera_look(&camera, (float[]){.2F, .3F, 2}, (float[]){-.1F, -.2F, -1}, (float[]){0, 1, 0});
    int depth = image_find_channel(&image, "Z"), alpha = image_find_channel(&image, "A");
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const float *pixel = image_at(&image, x, y);
            float u = ((float)x + .5F) / WIDTH, v = ((float)y + .5F) / HEIGHT, origin[3], ray[3],
                  point[3], seen[3], ndc[3], along = 0;
            if (pixel[alpha] < 1)
                continue;
            camera_ray(&camera, u, v, (float)WIDTH / HEIGHT, origin, ray);
            for (int c = 0; c < 3; c++)
                along += ray[c] * camera.forward[c];
            for (int c = 0; c < 3; c++)
                point[c] = origin[c] + ray[c] * pixel[depth] / along;
            transform(to_camera, point, seen);
            transform(to_ndc, point, ndc);
            worst_depth = fmax(worst_depth, fabs((double)(seen[2] - pixel[depth])));
            worst_ndc =
                fmax(worst_ndc, fmax(fabs((double)(ndc[0] - u)), fabs((double)(ndc[1] - v))));
            count++;
        }
    printf("    %d pixels\n", count);
    assert_true(count > WIDTH * HEIGHT / 3);
    check_at_most("error of depth, m", worst_depth, 1e-5);
    check_at_most("error of a pixel's place, of the picture", worst_ndc, 1e-5);
    free(file.data);
}

/* Against the projection of the viewer, of perspective and orthographic cameras; near and far are
 * at 0 and 1. */
TEST(matrices) {
    for (int i = 0; i < 4; i++) {
        struct camera camera = {
            .orthographic = i % 2, .fov_y = .7F, .y_extent = 2, .near = .5F, .far = i < 2 ? 9 : 0};
        float view[16], ndc[16], point[3], seen[3], place[2], placed[3];
        camera_look(&camera, (float[]){1, 2, 3}, (float[]){.3F, -.2F, -1}, (float[]){0, 1, 0});
        camera_world_to_camera(&camera, view);
        camera_world_to_ndc(&camera, 1.5F, ndc);
        for (int c = 0; c < 3; c++)
            point[c] =
                camera.eye[c] + 4 * camera.forward[c] + .5F * camera.right[c] - .3F * camera.up[c];
        transform(view, point, seen);
        check_vector("in camera space", seen, .5, -.3, 4, 1e-5);
        assert_true(camera_project(&camera, point, 1.5F, place));
        transform(ndc, point, placed);
        check_near("x", (double)placed[0], (double)place[0], 1e-5);
        check_near("y", (double)placed[1], (double)place[1], 1e-5);
        for (int end = 0; camera.far > 0 && end < 2; end++) {
            for (int c = 0; c < 3; c++)
                point[c] = camera.eye[c] + (end ? camera.far : camera.near) * camera.forward[c];
            transform(ndc, point, placed);
            check_near(end ? "z at far" : "z at near", (double)placed[2], end, 1e-5);
        }
    }
}

/* Another program reads the same. */
TEST(exrheader) {
    need_command("command -v exrheader");
    expect(0, "% render scenes/cornell-box.glb -o @/e.exr --size 16x16 --quality draft -q && "
              "exrheader @/e.exr");
    expect_text("software (type string): \"manylight 0.1\"");
    expect_text("worldToCamera (type m44f)");
    expect_text("chromaticities (type chromaticities)");
    expect_text("white (0.3127 0.329)");
}

RUN_TESTS(NULL, NULL)
