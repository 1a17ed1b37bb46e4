/* The library against the program: the same bits and the same words, from files, memory and arrays,
 * on any thread. */
#define _XOPEN_SOURCE 700
#include "library_support.h"

#include "gl/memory.h"
#include "scene/lights/emitter.h"
#include "scene/open.h"

#include <fenv.h>
#include <locale.h>
#include <pthread.h>

#define BOX "scenes/cornell-box.glb"

/* --- the program's bits ----------------------------------------------------------------------- */

static const struct row {
    const char *scene, *arguments, *environment;
    struct manylight_renderer_desc desc;
    struct manylight_view view;
} rows[] = {
    {BOX, "", NULL, {0}, {0}},
    {"scenes/moving-spot.glb", "--time 1.5", NULL, {0}, {.time = 1.5}},
    {BOX, "--quality draft --passes 2", NULL, {.quality = "draft", .passes = 2}, {0}},
    {BOX,
     "--technique row-column --set vpls=512 --camera 'eye=0,1,3'",
     NULL,
     {.technique = "row-column", .settings = "vpls=512"},
     {.camera = "eye=0,1,3"}},
    {"scenes/gloss.glb",
     "--direct hard --quality high",
     NULL,
     {.direct = "hard", .quality = "high"},
     {0}},
    {"scenes/three-lights.glb",
     "--light 1 --first-pass 3",
     NULL,
     {.first_pass = 3},
     {.light = "1"}},
    {BOX,
     "--environment scenes/day.hdr --background none",
     "scenes/day.hdr",
     {.hide_environment = 1},
     {0}},
    {BOX,
     "--light '+area position=0,5.4,0 size=1,1 intensity=9,9,9'",
     NULL,
     {0},
     {.light = "+area position=0,5.4,0 size=1,1 intensity=9,9,9"}},
};

TEST(same_bits_as_program) {
    struct manylight_device *device = open_device();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (!is_tried_here(i, 4))
            continue;
        struct row row = rows[i];
        row.view.size = sizeof row.view;
        expect(0, form("%% render %s %s -o @/program.exr --size 48x40", row.scene, row.arguments));
        /* Lights of a view are those of the scene, as --light names them. */
        struct manylight_scene *scene;
        check_call("scene",
                   manylight_scene_open(PART(scene_desc, .path = row.scene, .light = row.view.light,
                                             .environment = row.environment),
                                        &scene));
        struct manylight_image *image = draw_once(device, scene, &row.desc, &row.view);
        check_same_as_file(image, scratch("program.exr"));
        manylight_image_free(image);
        manylight_scene_free(scene);
    }
    manylight_device_free(device);
}

/* A renderer is the same whatever it drew before, and whatever it was. */
TEST(same_bits_after_changes) {
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene("scenes/door.glb");
    const struct manylight_view *at_0 = PART(view, .time = 0), *later = PART(view, .time = 2);
    const struct manylight_renderer_desc *first = PART(renderer_desc, .width = 48, .height = 40),
                                         *other = PART(renderer_desc, .width = 32, .height = 16,
                                                       .settings = "vpls=256");
    struct manylight_image *expected = draw_once(device, scene, NULL, at_0), *image;
    struct manylight_renderer *renderer = open_drawing(device, scene, NULL);
    check_call("render", manylight_render(renderer, later));
    check_call("change", manylight_renderer_change(renderer, other));
    check_call("render", manylight_render(renderer, later));
    check_call("change", manylight_renderer_change(renderer, first));
    check_call("render", manylight_render(renderer, NULL));
    check_call("read", manylight_read(renderer, NULL, &image));
    assert_true(same_images(image, expected));
    manylight_image_free(image);
    manylight_image_free(expected);
    manylight_renderer_free(renderer);
    manylight_scene_free(scene);
    manylight_device_free(device);
}

/* --- scenes from elsewhere -------------------------------------------------------------------- */

enum { PARTS_MAX = 64 };

/* The arrays of a scene whose nodes leave its meshes where they are. */
static size_t take_arrays(const struct scene *scene, struct manylight_mesh meshes[PARTS_MAX],
                          struct manylight_material materials[PARTS_MAX]) {
    size_t count = 0;
    for (int n = 0; n < scene->node_count; n++) {
        int mesh = scene->nodes[n].mesh;
        for (int p = 0; mesh >= 0 && p < scene->meshes[mesh].primitive_count; p++) {
            const struct primitive *primitive = &scene->meshes[mesh].primitives[p];
            assert_true(count < PARTS_MAX);
            meshes[count++] = FILLED(
                manylight_mesh, .size = sizeof *meshes,
                .positions = (const float *)primitive->position,
                .normals = (const float *)primitive->normal,
                .vertex_count = (size_t)primitive->vertex_count, .indices = primitive->indices,
                .index_count = (size_t)primitive->index_count, .material = primitive->material);
        }
    }
    for (int i = 0; i < scene->material_count; i++) {
        const struct material *from = &scene->materials[i];
        struct manylight_material *to = &materials[i];
        *to = FILLED(manylight_material, .size = sizeof *to, .metalness = from->metalness,
                     .roughness = from->roughness, .double_sided = from->double_sided);
        memcpy(to->base_color, from->base_color, sizeof to->base_color);
        memcpy(to->emission, from->emission, sizeof to->emission);
    }
    return count;
}

static const struct manylight_renderer_desc by_maps = {.settings = "path=maps"};

/* Camera and light of the file by text, and those of the arrays, differ in last bits alone. By
 * maps: a last bit moves some shadow rays past an edge. */
TEST(scene_from_arrays) {
    struct manylight_device *device = open_device();
    struct manylight_scene *file = open_scene(BOX), *arrays;
    struct manylight_mesh meshes[PARTS_MAX] = {{0}};
    struct manylight_material materials[PARTS_MAX] = {{0}};
    struct manylight_camera camera = {.size = sizeof camera};
    struct manylight_light light = {.size = sizeof light, .type = MANYLIGHT_SPOT};
    OWNED(scene) scene;
    OWNED(geometry) geometry;
    struct emitter emitter;
    check_ok("open", scene_open(&scene, &geometry, BOX, NULL));
    emitter_place(&emitter, &scene, 0, 0);
    memcpy(light.position, emitter.position, sizeof light.position);
    memcpy(light.direction, emitter.direction, sizeof light.direction);
    memcpy(light.up, emitter.up, sizeof light.up);
    memcpy(light.intensity, emitter.intensity, sizeof light.intensity);
    light.inner_angle = scene.lights[0].inner;
    light.outer_angle = scene.lights[0].outer;
    check_call("camera", manylight_scene_camera(file, NULL, 0, &camera));
    const struct manylight_scene_desc desc = {.size = sizeof desc,
                                              .meshes = meshes,
                                              .mesh_count = take_arrays(&scene, meshes, materials),
                                              .materials = materials,
                                              .material_count = (size_t)scene.material_count,
                                              .lights = &light,
                                              .light_count = 1,
                                              .cameras = &camera,
                                              .camera_count = 1};
    assert_int_equal(scene.light_count, 1);
    check_call("arrays", manylight_scene_open(&desc, &arrays));
    struct manylight_image *a = draw_once(device, file, &by_maps, NULL),
                           *b = draw_once(device, arrays, &by_maps, NULL);
    double error;
    check_call("compare", manylight_compare(b, a, NULL, &error, NULL));
    check_at_most("relative RMSE", error, 1e-4);
    manylight_image_free(a);
    manylight_image_free(b);
    manylight_scene_free(file);
    manylight_scene_free(arrays);
    manylight_device_free(device);
}

/* --- threads ---------------------------------------------------------------------------------- */

struct party {
    struct manylight_device *device;
    struct manylight_scene *scene;
    struct manylight_image *image;
    double time;
};

static void *draw_alone(void *user) {
    struct party *party = user;
    const struct manylight_renderer_desc *desc = PART(renderer_desc, .width = 48, .height = 40);
    struct manylight_renderer *renderer;
    for (int i = 0; i < (is_long_run() ? 4 : 1); i++) {
        if (manylight_renderer_create(party->device, party->scene, desc, &renderer))
            return NULL;
        if (!manylight_render(renderer, PART(view, .time = party->time))) {
            manylight_image_free(party->image);
            manylight_read(renderer, NULL, &party->image);
        }
        manylight_renderer_free(renderer);
    }
    return NULL;
}

/* Four threads, one scene whose triangles move, each thread at a time of its own. */
TEST(devices_and_threads) {
    enum { THREADS = 4 };
    struct manylight_device *devices[2] = {open_device(), open_device()};
    struct manylight_scene *scene = open_scene("scenes/door.glb");
    struct party parties[THREADS] = {{0}};
    pthread_t threads[THREADS];
    for (int i = 0; i < THREADS; i++) {
        parties[i] = (struct party){devices[i % 2], scene, NULL, i};
        assert_int_equal(pthread_create(&threads[i], NULL, draw_alone, &parties[i]), 0);
    }
    for (int i = 0; i < THREADS; i++)
        pthread_join(threads[i], NULL);
    for (int i = 0; i < THREADS; i++) {
        struct manylight_image *alone = draw_once(devices[0], scene, NULL, PART(view, .time = i));
        assert_non_null(parties[i].image);
        assert_true(same_images(alone, parties[i].image));
        manylight_image_free(alone);
        manylight_image_free(parties[i].image);
    }
    manylight_scene_free(scene);
    manylight_device_free(devices[0]);
    manylight_device_free(devices[1]);
}

static void *fail_alone(void *user) {
    struct manylight_scene *scene;
    manylight_scene_open(PART(scene_desc, .path = "no-such-file.glb"), &scene);
    strcpy(user, manylight_error());
    return NULL;
}

TEST(errors_are_of_threads) {
    char theirs[2048];
    pthread_t thread;
    check_failed(manylight_setting_at(-1, NULL), MANYLIGHT_BAD_ARGUMENT, "there is no setting -1");
    assert_int_equal(pthread_create(&thread, NULL, fail_alone, theirs), 0);
    pthread_join(thread, NULL);
    expect_in(theirs, "no-such-file.glb");
    expect_in(manylight_error(), "there is no setting -1");
}

/* The caller's rounding mode neither changes the picture nor is changed. */
TEST(rounding_mode) {
    struct manylight_scene *scene = open_scene(BOX);
    const struct manylight_reference_desc desc = {
        .size = sizeof desc, .width = 16, .height = 16, .samples = 4, .threads = 1};
    struct manylight_image *a, *b;
    check_call("reference", manylight_reference(scene, &desc, &a));
    fesetround(FE_UPWARD);
    enum manylight_status status = manylight_reference(scene, &desc, &b);
    int after = fegetround();
    fesetround(FE_TONEAREST);
    check_call("reference", status);
    assert_int_equal(after, FE_UPWARD);
    assert_true(same_images(a, b));
    manylight_image_free(a);
    manylight_image_free(b);
    manylight_scene_free(scene);
}

/* Nor does a locale that writes 1,5: the texts of callers are those of the command line. */
TEST(locale) {
    char folder[1024];
    need_command("command -v localedef && test -e /usr/share/i18n/locales/de_DE");
    expect(0, "mkdir -p @ && localedef -i de_DE -f UTF-8 @/de_DE.UTF-8 || test -d @/de_DE.UTF-8");
    in_scratch(folder, sizeof folder, "@");
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene(BOX);
    const struct manylight_renderer_desc desc = {.settings = "exposure=1.5 clustered.vals=20"};
    const struct manylight_view view = {.size = sizeof view, .camera = "0 eye=0,1.25,3.5"};
    struct manylight_image *expected = draw_once(device, scene, &desc, &view);
    setenv("LOCPATH", folder, 1);
    assert_non_null(setlocale(LC_ALL, "de_DE.UTF-8"));
    struct manylight_image *image = draw_once(device, scene, &desc, &view);
    assert_string_equal(localeconv()->decimal_point, ",");
    setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
    assert_true(same_images(image, expected));
    manylight_image_free(image);
    manylight_image_free(expected);
    manylight_scene_free(scene);
    manylight_device_free(device);
}

/* --- what is told ----------------------------------------------------------------------------- */

struct told {
    int count;
    char last[256];
};

static void hear(void *user, enum manylight_log_level level, const char *message) {
    struct told *told = user;
    if (level == MANYLIGHT_DETAIL)
        return;
    told->count++;
    snprintf(told->last, sizeof told->last, "%s", message);
}

TEST(log) {
    const float triangle[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const struct manylight_mesh *mesh = PART(mesh, .positions = triangle, .vertex_count = 3);
    struct told told = {0};
    struct manylight_scene *scene;
    manylight_log_to(hear, &told);
    check_call("scene",
               manylight_scene_open(PART(scene_desc, .meshes = mesh, .mesh_count = 1), &scene));
    manylight_log_to(NULL, NULL);
    printf("    %d: %s\n", told.count, told.last);
    assert_true(told.count > 0);
    expect_in(told.last, "arrays: no ");
    manylight_scene_free(scene);
}

struct steps {
    struct manylight_renderer *renderer;
    int count, last;
    double done;
    enum manylight_status nested;
};

static int step(void *user, double done, const char *note) {
    struct steps *steps = user;
    steps->count += done > steps->done; /* else it is within a long pass */
    steps->nested = manylight_render(steps->renderer, NULL);
    manylight_renderer_free(steps->renderer); /* refused, too */
    assert_true(done >= steps->done && *note);
    steps->done = done;
    return steps->last > 0 && steps->count == steps->last;
}

TEST(progress) {
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene(BOX);
    struct manylight_image *image;
    const struct manylight_renderer_desc desc = {.passes = 4};
    struct steps steps = {.renderer = open_drawing(device, scene, &desc)};
    check_call("render",
               manylight_render(steps.renderer, PART(view, .progress = step, .user = &steps)));
    assert_int_equal(steps.count, 4);
    assert_int_equal(steps.nested, MANYLIGHT_BAD_ARGUMENT);
    check_near("done", steps.done, 1, 0);
    struct steps cancelled = {.renderer = steps.renderer, .last = 2};
    check_failed(manylight_render(steps.renderer, PART(view, .progress = step, .user = &cancelled)),
                 MANYLIGHT_CANCELLED, "cancelled");
    assert_int_equal(cancelled.count, 2);
    check_failed(manylight_read(steps.renderer, NULL, &image), MANYLIGHT_BAD_ARGUMENT, "no frame");
    check_call("render", manylight_render(steps.renderer, NULL));
    manylight_renderer_free(steps.renderer);
    manylight_scene_free(scene);
    manylight_device_free(device);
}

/* --- layers and metrics ----------------------------------------------------------------------- */

TEST(layers) {
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene(BOX);
    struct manylight_renderer *renderer = open_drawing(device, scene, &by_maps);
    struct manylight_image *image;
    static float floats[48 * 40 * 4];
    static uint8_t rgba[48 * 40 * 4];
    int channels;
    check_call("render", manylight_render(renderer, NULL));
    check_call("read", manylight_read(renderer, "val,visibility", &image));
    check_call("beauty", manylight_image_layer(image, NULL, floats, sizeof floats / sizeof *floats,
                                               &channels));
    assert_int_equal(channels, 4);
    assert_memory_equal(floats, manylight_image_pixels(image), 4 * sizeof *floats);
    check_call("val", manylight_image_layer(image, "val", NULL, 0, &channels));
    assert_int_equal(channels, 3);
    check_call("Z", manylight_image_layer(image, "Z", floats, 48 * 40, &channels));
    assert_int_equal(channels, 1);
    check_failed(manylight_image_layer(image, "direct", floats, 48 * 40, &channels),
                 MANYLIGHT_BAD_ARGUMENT, "layer: 40x48x3 floats have no room in 1920");
    check_failed(manylight_image_layer(image, "velvet", NULL, 0, &channels), MANYLIGHT_BAD_ARGUMENT,
                 "no layer is called 'velvet'");
    check_call("display", manylight_read_display(renderer, "indirect", rgba, sizeof rgba));
    check_failed(manylight_read_display(renderer, NULL, rgba, 3), MANYLIGHT_BAD_ARGUMENT,
                 "no room in 3");
    assert_int_equal(manylight_matte_id("bunny"), 0x13851a76);
    assert_int_equal(manylight_matte_id(NULL), 0);
    manylight_image_free(image);
    check_call("read", manylight_read(renderer, "albedo,val,id.node", &image));
    assert_int_equal(manylight_image_channel_count(image), 1 + 3 + 3 + 1);
    assert_true(manylight_image_pixels(image)[0] == floats[0]);
    manylight_image_free(image);
    manylight_renderer_free(renderer);
    manylight_scene_free(scene);
    manylight_device_free(device);
}

TEST(compare) {
    const float a[] = {1, 2, 3, 4, 5, 6}, b[] = {1, 2, 4, 4, 5, 6};
    struct manylight_image *test, *reference, *none;
    float map[2];
    double value;
    struct manylight_compare_desc desc = {.size = sizeof desc, .metric = "mae"};
    check_call("test", manylight_image_create(2, 1, "R G B", a, &test));
    check_call("reference", manylight_image_create(2, 1, "R G B", b, &reference));
    check_call("compare", manylight_compare(test, reference, &desc, &value, map));
    check_near("mae", value, 1. / 6, 1e-6);
    check_near("map", (double)map[0], 1. / 3, 1e-6);
    check_near("map", (double)map[1], 0, 0);
    desc.metric = "rmse-of-nothing";
    check_failed(manylight_compare(test, reference, &desc, &value, NULL), MANYLIGHT_BAD_ARGUMENT,
                 "no metric is called 'rmse-of-nothing'");
    /* A layer's channels come in the order of their letters. */
    float floats[4];
    check_call("names", manylight_image_create(1, 1, "B G x.Z x.Y A R", a, &none));
    check_call("beauty", manylight_image_layer(none, NULL, floats, 4, NULL));
    assert_memory_equal(floats, ((const float[]){6, 2, 1, 5}), sizeof floats);
    check_call("x", manylight_image_layer(none, "x", floats, 2, NULL));
    assert_memory_equal(floats, ((const float[]){4, 3}), 2 * sizeof *floats);
    manylight_image_free(none);
    check_failed(manylight_image_create(0, 1, "R", a, &none), MANYLIGHT_BAD_ARGUMENT,
                 "image: a side");
    manylight_image_free(test);
    manylight_image_free(reference);
}

TEST(names) {
    struct manylight_setting setting = {.size = sizeof setting};
    int settings = 0, techniques = 0, metrics = 0;
    while (!manylight_setting_at(settings, &setting)) {
        assert_true(*setting.name && *setting.value && setting.help);
        settings++;
    }
    while (manylight_technique_name(techniques))
        techniques++;
    while (manylight_metric_name(metrics))
        metrics++;
    printf("    %d settings, %d techniques, %d metrics\n", settings, techniques, metrics);
    assert_true(settings > 50 && techniques > 4 && metrics == 15);
    assert_string_equal(manylight_quality_name(3), "final");
    assert_null(manylight_quality_name(4));
    assert_null(manylight_direct_name(-1));
}

/* --- growth ----------------------------------------------------------------------------------- */

static void cycle(void) {
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene(BOX);
    const struct manylight_renderer_desc desc = {.width = 16, .height = 16};
    struct manylight_renderer *renderer = open_drawing(device, scene, &desc);
    struct manylight_image *image;
    check_call("render", manylight_render(renderer, NULL));
    check_call("read", manylight_read(renderer, NULL, &image));
    manylight_image_free(image);
    /* In an order that nobody would choose. */
    manylight_device_free(device);
    manylight_scene_free(scene);
    manylight_renderer_free(renderer);
}

/* Memory of the driver settles within some cycles. */
TEST(cycles) {
    int cycles = is_long_run() ? 100 : 24, settling = is_long_run() ? 20 : 12;
    int objects = gpu_memory_object_count();
    double before = 0;
    for (int i = 0; i < cycles; i++) {
        if (i == settling)
            before = mem_resident();
        cycle();
    }
    printf("    %.1f MiB, then %.1f MiB\n", before, mem_resident());
    assert_int_equal(gpu_memory_object_count(), objects);
#ifndef __SANITIZE_ADDRESS__ /* which keeps freed memory for a while */
    check_at_most("growth of a cycle, MiB", (mem_resident() - before) / (cycles - settling), .5);
#endif
}

RUN_TESTS(NULL, NULL)
