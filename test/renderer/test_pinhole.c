/* Cameras by intrinsics and a pose: projection by the matrix, and pictures as crops of larger ones
 * of a camera without a shifted lens. */
#include "render_support.h"

#include "library/manylight.h"
#include "library_support.h"
#include "reference/path_tracer.h"
#include "reference/primary.h"
#include "scene/placing.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define BOX "scenes/cornell-box.glb"

/* --- projection --- */

static double number(double least, double most) {
    return least + (most - least) * rand() / RAND_MAX;
}

/* A rigid matrix, row by row. */
static void random_pose(double pose[16]) {
    mat4 turn;
    vec3 axis = {(float)number(-1, 1), (float)number(-1, 1), (float)number(.1, 1)};
    glm_rotate_make(turn, (float)number(0, 6), axis);
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++)
            pose[4 * row + column] = column == 3 ? number(-3, 3) : (double)turn[column][row];
    for (int column = 0; column < 4; column++)
        pose[12 + column] = column == 3;
}

/* The pixel of a point by the textbook's K [R|t], with OpenCV's axes. */
static void project(const double k[4], const double pose[16], bool opencv, const double point[3],
                    double pixel[2]) {
    double local[3] = {0};
    for (int c = 0; c < 3; c++)
        for (int row = 0; row < 3; row++)
            local[c] += pose[4 * row + c] * (point[row] - pose[4 * row + 3]);
    double y = opencv ? local[1] : -local[1], z = opencv ? local[2] : -local[2];
    pixel[0] = k[0] * local[0] / z + k[2];
    pixel[1] = k[1] * y / z + k[3];
}

static void check_pixel(const char *what, const float place[2], const int size[2],
                        const double expected[2]) {
    double x = (double)place[0] * size[0], y = (double)place[1] * size[1];
    if (fabs(x - expected[0]) > .01 || fabs(y - expected[1]) > .01)
        fail_msg("%s: %g, %g, expected %g, %g", what, x, y, expected[0], expected[1]);
}

/* By the library, by text, by the OpenEXR matrix, and back along the ray. */
static void test_projection(void **state) {
    (void)state;
    const int size[2] = {640, 360};
    const float aspect = 640 / 360.F;
    struct scene scene;
    check_ok("scene", scene_load(&scene, BOX));
    srand(1);
    for (int i = 0; i < 40; i++) {
        struct manylight_pinhole pinhole = {.size = sizeof pinhole,
                                            .width = size[0],
                                            .height = size[1],
                                            .fx = number(200, 900),
                                            .fy = number(200, 900),
                                            .cx = number(-50, 700),
                                            .cy = number(-50, 400),
                                            .axes = i % 2};
        const double k[4] = {pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy};
        struct manylight_camera made = {.size = sizeof made};
        struct camera camera = {.near = 0};
        random_pose(pinhole.pose);
        char text[1000];
        int used = snprintf(text, sizeof text, "intrinsics=%.9g,%.9g,%.9g,%.9g,640,360 %s=", k[0],
                            k[1], k[2], k[3], i % 2 ? "opencv" : "opengl");
        for (int n = 0; n < 16; n++)
            used += snprintf(text + used, sizeof text - (size_t)used, "%s%.9g", n ? "," : "",
                             pinhole.pose[n]);
        check_ok("text", camera_from_text(&camera, &scene, text, 0, NULL));
        assert_int_equal(manylight_camera_pinhole(&pinhole, &made), MANYLIGHT_OK);
        for (int c = 0; c < 3; c++)
            if (fabsf(made.right[c] - camera.right[c]) > 1e-5F)
                fail_msg("text and library differ");
        for (int n = 0; n < 10; n++) {
            float origin[3], direction[3], place[2], ndc[16];
            const float x = (float)number(0, 1), y = (float)number(0, 1);
            double point[3], pixel[2];
            camera_ray(&camera, x, y, aspect, origin, direction);
            for (int c = 0; c < 3; c++)
                point[c] = (double)origin[c] + 5 * (double)direction[c];
            project(k, pinhole.pose, i % 2, point, pixel);
            check_pixel("ray", (float[]){x, y}, size, pixel);
            const float at[3] = {(float)point[0], (float)point[1], (float)point[2]};
            assert_true(camera_project(&camera, at, aspect, place));
            check_pixel("project", place, size, pixel);
            camera_world_to_ndc(&camera, aspect, ndc);
            float column[4] = {0};
            for (int c = 0; c < 4; c++)
                for (int row = 0; row < 4; row++)
                    column[c] += ndc[4 * row + c] * (row < 3 ? at[row] : 1);
            check_pixel("world to NDC", (float[]){column[0] / column[3], column[1] / column[3]},
                        size, pixel);
        }
    }
    scene_free(&scene);
}

/* --- pictures --- */

enum { SIZE = 96, WIDTH = 60, HEIGHT = 40, LEFT = 7, TOP = 31 };

/* The camera of `stage` for the part from LEFT, TOP on of its square picture; columns: three for
 * each pixel's width. */
static struct camera part_camera(const struct stage *stage, int columns) {
    const double f = SIZE / 2. / tan((double)stage->camera.fov_y / 2);
    struct camera camera = stage->camera;
    check_ok("part",
             camera_set_intrinsics(
                 &camera, (double[]){columns * f, f, columns * (SIZE / 2. - LEFT), SIZE / 2. - TOP},
                 (int[]){columns * WIDTH, HEIGHT}));
    return camera;
}

/* Greatest difference of a channel, and the part of pixels where it is above `most`, of a part and
 * the whole. */
static double part_off(const struct image *part, const struct image *whole, const char *name,
                       int columns, float most) {
    int a = image_find_channel(part, name), b = image_find_channel(whole, name), off = 0;
    assert_true(a >= 0 && b >= 0);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            float of_part = image_at(part, columns * x + columns / 2, y)[a];
            float of_whole = image_at(whole, LEFT + x, TOP + y)[b];
            off += !(fabsf(of_part - of_whole) <= most);
        }
    return (double)off / (WIDTH * HEIGHT);
}

static void check_part(const char *what, const struct image *part, const struct image *whole,
                       int columns) {
    printf("    %s, %d columns\n", what, columns);
    check_at_most("pixels with another Z", part_off(part, whole, "Z", columns, 2e-4F), .002);
    check_at_most("pixels with another normal", part_off(part, whole, "normal.X", columns, 2e-3F),
                  .002);
    check_at_most("pixels with other direct light",
                  part_off(part, whole, "direct.G", columns, .01F), .02);
}

/* A frame of a shifted lens and of pixels that are not square is a part of a larger frame. The
 * indirect light of both has noise, and the same mean. */
static void test_frame(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, BOX);
    struct renderer_desc desc = desc_of(&stage, "clustered", "", SIZE, SIZE);
    struct image whole = render_layers(&desc);
    for (int columns = 1; columns <= 3; columns += 2) {
        desc.camera = part_camera(&stage, columns);
        desc.width = columns * WIDTH;
        desc.height = HEIGHT;
        struct image part = render_layers(&desc);
        check_part("frame", &part, &whole, columns);
        double sum = 0, of_whole = 0;
        int a = image_find_channel(&part, "indirect.G"),
            b = image_find_channel(&whole, "indirect.G");
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                sum += (double)image_at(&part, columns * x + columns / 2, y)[a];
                of_whole += (double)image_at(&whole, LEFT + x, TOP + y)[b];
            }
        check_near("indirect light over the whole's", sum / of_whole, 1, .03);
        image_free(&part);
    }
    image_free(&whole);
    stage_free(&stage);
}

/* Spots of light have the size that a pixel shows of a surface there. */
static void test_caustics(void **state) {
    (void)state;
    struct stage stage;
    double off = 0, sum = 0;
    open_stage(&stage, "scenes/ring.glb");
    struct renderer_desc desc =
        desc_of(&stage, "unshadowed", "caustics.surface=points", SIZE, SIZE);
    struct image whole = render_layers(&desc);
    desc.camera = part_camera(&stage, 1);
    desc.width = WIDTH;
    desc.height = HEIGHT;
    struct image part = render_layers(&desc);
    int a = image_find_channel(&part, "caustic.G"), b = image_find_channel(&whole, "caustic.G");
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            double of_whole = (double)image_at(&whole, LEFT + x, TOP + y)[b];
            off += fabs((double)image_at(&part, x, y)[a] - of_whole);
            sum += of_whole;
        }
    assert_true(sum > 0);
    check_at_most("difference of caustics over the mean", off / sum, .01);
    images_free(&part, &whole);
    stage_free(&stage);
}

static struct image trace(const struct stage *stage, const struct camera *camera, int width,
                          int height) {
    struct image image;
    check_ok("trace", path_tracer_render(&(struct path_tracer_desc){.scene = &stage->scene,
                                                                    .geometry = &stage->geometry,
                                                                    .camera = camera,
                                                                    .emitters = stage->emitters,
                                                                    .width = width,
                                                                    .height = height,
                                                                    .samples = 1,
                                                                    .centers = true},
                                         &image, NULL));
    return image;
}

static void test_reference(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, BOX);
    struct image whole = trace(&stage, &stage.camera, SIZE, SIZE);
    for (int columns = 1; columns <= 3; columns += 2) {
        struct camera camera = part_camera(&stage, columns);
        struct image part = trace(&stage, &camera, columns * WIDTH, HEIGHT);
        check_part("reference", &part, &whole, columns);
        image_free(&part);
    }
    image_free(&whole);
    stage_free(&stage);
}

/* --- panoramas --- */

enum { FACE = 128, AROUND = 96 };

/* The face of a cube whose middle is along an axis of the panorama's camera, to either side. */
static struct camera face_camera(const struct camera *panorama, int face) {
    const float *axes[3] = {panorama->right, panorama->up, panorama->forward};
    struct camera camera = {.fov_y = GLM_PI_2f};
    vec3 forward;
    glm_vec3_scale((float *)axes[face / 2], face % 2 ? -1 : 1, forward);
    camera_look(&camera, panorama->eye, forward, axes[face / 2 == 1 ? 2 : 1]);
    return camera;
}

/* A pixel of a panorama sees along its longitude and latitude what one of six faces sees there. */
static void test_panorama(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, BOX);
    struct camera camera = stage.camera;
    glm_vec3_copy(stage.geometry.center, camera.eye);
    check_ok("panorama", camera_set_panorama(&camera));
    struct image around = trace(&stage, &camera, AROUND, AROUND / 2), faces[6];
    struct camera cameras[6];
    struct primary_rays primary[6];
    struct rays rays;
    open_rays(&rays, &stage);
    for (int face = 0; face < 6; face++) {
        cameras[face] = face_camera(&camera, face);
        faces[face] = trace(&stage, &cameras[face], FACE, FACE);
        primary[face] = primary_rays_of(&rays.scene, &cameras[face], &stage.geometry, FACE, FACE);
    }
    int z = image_find_channel(&around, "Z"), light = image_find_channel(&around, "direct.G");
    int compared = 0, astray = 0, other = 0, used[6] = {0};
    for (int y = 0; y < AROUND / 2; y++)
        for (int x = 0; x < AROUND; x++) {
            double longitude = (x + .5) / AROUND * 2 * GLM_PI - GLM_PI;
            double latitude = GLM_PI_2 - (y + .5) / (AROUND / 2.) * GLM_PI;
            double local[3] = {cos(latitude) * sin(longitude), sin(latitude),
                               cos(latitude) * cos(longitude)};
            const float *seen = image_at(&around, x, y);
            vec3 point;
            float place[2];
            int axis = 0;
            for (int i = 1; i < 3; i++)
                axis = fabs(local[i]) > fabs(local[axis]) ? i : axis;
            int face = 2 * axis + (local[axis] < 0);
            for (int c = 0; c < 3; c++)
                point[c] = camera.eye[c] + seen[z] * (float)(local[0] * (double)camera.right[c] +
                                                             local[1] * (double)camera.up[c] +
                                                             local[2] * (double)camera.forward[c]);
            if (seen[z] <= 0)
                continue;
            assert_true(camera_project(&cameras[face], point, 1, place));
            int px = (int)fminf(place[0] * FACE, FACE - 1),
                py = (int)fminf(place[1] * FACE, FACE - 1);
            const float *of_face = image_at(&faces[face], px, py);
            struct hit hit;
            compared++;
            used[face]++;
            astray += !primary_hit(&primary[face], place[0] * FACE, place[1] * FACE, 0, &hit) ||
                      glm_vec3_distance(hit.position.raw, point) > 1e-3F;
            other += !(fabsf(seen[light] - of_face[light]) <= .05F * seen[light] + 1e-3F);
        }
    for (int face = 0; face < 6; face++)
        printf("    face %d: %d pixels\n", face, used[face]);
    assert_true(compared > AROUND * AROUND / 4);
    check_at_most("pixels that see another place", (double)astray / compared, .002);
    check_at_most("pixels of other light", (double)other / compared, .1);
    camera.shift[0] = .1F;
    check_refused(camera_set_panorama(&camera), "shifted lens");
    for (int face = 0; face < 6; face++)
        image_free(&faces[face]);
    image_free(&around);
    close_rays(&rays);
    stage_free(&stage);
}

/* --- refusals --- */

static void test_refusals(void **state) {
    (void)state;
    static const char *const texts[][2] = {
        {"intrinsics=1,2,3,4,5", "wants 6 numbers"},
        {"intrinsics=0,9,3,4,5,5", "focal lengths of 0 and 9 pixels"},
        {"intrinsics=9,9,3,4,0,5", "0x5 is no size"},
        {"intrinsics=9,9,3,4,5,5 fov=1", "excludes fov"},
        {"opencv=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1 eye=0,0,0", "exclude each other"},
        {"opengl=1,0,0,0,0,2,0,0,0,0,1,0,0,0,0,1", "pose: column 1 has the length 2, not 1"},
        {"opengl=1,0,0,0,0,1,0,0,0,0,1,0,0,0,1,1", "pose: its last row is not 0 0 0 1"},
        {"opengl=1,0,0,0,0,1,0,0,0,0,-1,0,0,0,0,1", "right points to the left"},
        {"opengl=1,0,0,0,0,1,.6,0,0,0,.8,0,0,0,0,1", "not at right angles"},
        {"shift=.5", "wants 2 numbers"},
    };
    struct scene scene;
    struct camera camera;
    check_ok("scene", scene_load(&scene, BOX));
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        check_refused(camera_from_text(&camera, &scene, texts[i][0], 0, NULL), texts[i][1]);
    scene_free(&scene);
    struct manylight_camera made = {.size = sizeof made};
    struct manylight_pinhole pinhole = {sizeof pinhole, 9, 9, 9, 9, 4, (double)NAN, {0}, 0};
    check_failed(manylight_camera_pinhole(&pinhole, &made), MANYLIGHT_BAD_ARGUMENT, "not finite");
    pinhole.cy = 4;
    pinhole.axes = 7;
    check_failed(manylight_camera_pinhole(&pinhole, &made), MANYLIGHT_BAD_ARGUMENT, "axes: 7");
    const struct manylight_camera shifted = {.size = sizeof shifted, .shift = {.1F, 0}};
    const struct manylight_mesh mesh = {
        .size = sizeof mesh, .positions = (float[]){0, 0, 0, 1, 0, 0, 0, 1, 0}, .vertex_count = 3};
    struct manylight_scene *none;
    check_failed(manylight_scene_open(
                     &(struct manylight_scene_desc){.size = sizeof(struct manylight_scene_desc),
                                                    .meshes = &mesh,
                                                    .mesh_count = 1,
                                                    .cameras = &shifted,
                                                    .camera_count = 1},
                     &none),
                 MANYLIGHT_BAD_SCENE, "camera 0: shift");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_projection), cmocka_unit_test(test_frame),
        cmocka_unit_test(test_caustics),   cmocka_unit_test(test_reference),
        cmocka_unit_test(test_panorama),   cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, open_group_context, close_group_context);
}
