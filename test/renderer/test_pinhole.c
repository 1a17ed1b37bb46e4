/* Cameras by intrinsics and a pose: projection by the matrix, and pictures as crops of larger ones
 * of a camera without a shifted lens. */
#include "render_support.h"

#include "library/manylight.h"
#include "library_support.h"
#include "reference/path_tracer.h"
#include "scene/placing.h"

#include <cglm/cglm.h>

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
TEST(projection) {
    const int size[2] = {640, 360};
    const float aspect = 640 / 360.F;
    OWNED(scene) scene;
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
}

/* --- pictures --- */

enum { SIZE = 96, WIDTH = 60, HEIGHT = 40, LEFT = 7, TOP = 31 };

/* A frame of the technique, or one of the path tracer. */
static struct image picture(const struct stage *stage, const char *technique, const char *settings,
                            const struct camera *camera, int width, int height) {
    struct image image;
    if (technique) {
        struct renderer_desc desc = desc_of(stage, technique, settings, width, height);
        desc.camera = *camera;
        return render_layers(&desc);
    }
    const struct path_tracer_desc desc = {.scene = &stage->scene,
                                          .geometry = &stage->geometry,
                                          .camera = camera,
                                          .emitters = stage->emitters,
                                          .width = width,
                                          .height = height,
                                          .samples = 1,
                                          .centers = true};
    check_ok("trace", path_tracer_render(&desc, &image, NULL));
    return image;
}

/* The mean difference of a channel between a part and the whole, over the mean. columns: three for
 * each pixel's width. */
static double part_off(const struct image *part, const struct image *whole, const char *name,
                       int columns) {
    int a = image_find_channel(part, name), b = image_find_channel(whole, name);
    double off = 0, sum = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            double of_whole = (double)image_at(whole, LEFT + x, TOP + y)[b];
            off += fabs((double)image_at(part, columns * x + columns / 2, y)[a] - of_whole);
            sum += of_whole;
        }
    return off / sum;
}

/* A picture of a shifted lens, and of pixels that are not square, is a part of a larger picture.
 * Indirect light has noise. Spots of caustics have the size that a pixel shows of a surface. */
TEST(parts) {
    static const struct {
        const char *scene, *technique, *settings, *channel;
        int columns;
        double most;
    } rows[] = {
        {BOX, "clustered", "", "indirect.G", 1, .06},
        {BOX, "unshadowed", "", "Z", 1, 1e-5},
        {BOX, "unshadowed", "", "Z", 3, 1e-5},
        {BOX, "unshadowed", "", "direct.G", 3, .01},
        {BOX, NULL, "", "Z", 1, 1e-5},
        {BOX, NULL, "", "direct.G", 3, .01},
        {"scenes/ring.glb", "unshadowed", "caustics.surface=points", "caustic.G", 1, .01},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const int columns = rows[i].columns, width = columns * WIDTH;
        OWNED(stage) stage = open_stage(rows[i].scene);
        struct camera camera = stage.camera;
        const double f = SIZE / 2. / tan((double)camera.fov_y / 2), x = SIZE / 2. - LEFT;
        struct image whole =
            picture(&stage, rows[i].technique, rows[i].settings, &camera, SIZE, SIZE);
        check_ok("part", camera_set_intrinsics(
                             &camera, (double[]){columns * f, f, columns * x, SIZE / 2. - TOP},
                             (int[]){width, HEIGHT}));
        struct image part =
            picture(&stage, rows[i].technique, rows[i].settings, &camera, width, HEIGHT);
        check_at_most(rows[i].channel, part_off(&part, &whole, rows[i].channel, columns),
                      rows[i].most);
        images_free(&part, &whole);
    }
}

/* Pixels of a panorama see along their longitude and latitude. */
TEST(panorama) {
    struct rays rays;
    int astray = 0, seen = 0;
    OWNED(stage) stage = open_stage(BOX);
    open_rays(&rays, &stage);
    struct camera camera = stage.camera;
    glm_vec3_copy(stage.geometry.center, camera.eye);
    camera.lens = LENS_EQUIRECTANGULAR;
    check_ok("panorama", camera_check(&camera));
    struct image around = picture(&stage, NULL, "", &camera, SIZE, SIZE / 2);
    for (int y = 0; y < SIZE / 2; y++)
        for (int x = 0; x < SIZE; x++) {
            double longitude = (x + .5) / SIZE * 2 * GLM_PI - GLM_PI;
            double latitude = GLM_PI_2 - (y + .5) / (SIZE / 2.) * GLM_PI;
            vec3s direction;
            struct hit hit;
            for (int c = 0; c < 3; c++)
                direction.raw[c] = (float)(cos(latitude) * sin(longitude) * camera.right[c] +
                                           cos(latitude) * cos(longitude) * camera.forward[c] +
                                           sin(latitude) * camera.up[c]);
            bool hits = ray_scene_camera_hit(&rays.scene, to_vec3s(camera.eye), direction,
                                             (float[]){0, INFINITY}, 0, &hit);
            float depth = hits ? glms_vec3_distance(hit.position, to_vec3s(camera.eye)) : 0;
            astray +=
                !(fabsf(image_at(&around, x, y)[image_find_channel(&around, "Z")] - depth) < 1e-3F);
            seen += hits;
        }
    assert_true(seen > SIZE * SIZE / 4);
    check_at_most("pixels that see another place", astray, 8);
    camera.shift[0] = .1F;
    check_refused(camera_check(&camera), "shifted lens");
    image_free(&around);
    close_rays(&rays);
}

/* --- refusals --- */

TEST(refusals) {
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
    struct manylight_pinhole pinhole = {
        .size = sizeof pinhole, .width = 9, .height = 9, .fx = 9, .fy = 9, .cx = 4, .cy = NAN};
    check_failed(manylight_camera_pinhole(&pinhole, &made), MANYLIGHT_BAD_ARGUMENT, "not finite");
    pinhole.cy = 4;
    pinhole.axes = 7;
    check_failed(manylight_camera_pinhole(&pinhole, &made), MANYLIGHT_BAD_ARGUMENT, "axes: 7");
    struct manylight_image *image;
    struct manylight_scene *box = open_scene(BOX);
    const struct manylight_view view = {.size = sizeof view, .placed_next = &made};
    check_failed(
        manylight_reference(box,
                            &(struct manylight_reference_desc){
                                .size = sizeof(struct manylight_reference_desc), .view = &view},
                            &image),
        MANYLIGHT_BAD_ARGUMENT, "for views with placed");
    manylight_scene_free(box);
    const struct manylight_camera shifted = {.size = sizeof shifted, .shift = {.1F, 0}};
    const struct manylight_mesh mesh = {
        .size = sizeof mesh, .positions = (float[]){0, 0, 0, 1, 0, 0, 0, 1, 0}, .vertex_count = 3};
    struct manylight_scene *none;
    check_failed(
        manylight_scene_open(&FILLED(manylight_scene_desc,
                                     .size = sizeof(struct manylight_scene_desc), .meshes = &mesh,
                                     .mesh_count = 1, .cameras = &shifted, .camera_count = 1),
                             &none),
        MANYLIGHT_BAD_SCENE, "camera 0: shift");
}

/* A picture without --size has that of the intrinsics. */
TEST(default_size) {
    OWNED(stage) stage;
    int size[2];
    check_ok("stage",
             stage_init(&stage, &(struct stage_desc){.path = "scenes/cornell-box.glb",
                                                     .camera = "0 intrinsics=100,100,60,40,120,80",
                                                     .punctual_scale = 1}));
    stage_default_size(&stage, size);
    assert_int_equal(size[0], 120);
    assert_int_equal(size[1], 80);
}

RUN_TESTS(open_group_context, close_group_context)
