/* A renderer that is changed while it runs: the picture is that of one made anew, nothing leaks,
 * and what fails leaves it as it was. */
#include "support.h"

#include "base/error.h"
#include "gl/context/context.h"
#include "gl/glsl.h"
#include "gl/memory.h"
#include "renderer/renderer.h"
#include "scene/placing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { WIDTH = 48, HEIGHT = 40 };

struct fixture {
    struct context *context;
    struct scene scene;
    struct geometry geometry;
    struct renderer_desc desc;
};

static void set(struct settings *settings, const char *assignments) {
    check_ok(assignments, settings_assign(settings, assignments));
}

static int set_up_scene(void **state, const char *path) {
    struct fixture *fixture = *state = calloc(1, sizeof *fixture);
    fixture->context = context_create(&(struct context_desc){.device = -1, .debug = true});
    if (!fixture->context)
        return 0;
    check_ok("scene", scene_load(&fixture->scene, path));
    check_ok("geometry", geometry_init(&fixture->geometry, &fixture->scene, 0));
    struct renderer_desc *desc = &fixture->desc;
    *desc = (struct renderer_desc){.width = WIDTH,
                                   .height = HEIGHT,
                                   .technique = technique_default,
                                   .scene = &fixture->scene,
                                   .geometry = &fixture->geometry,
                                   .keep_lights = true};
    renderer_settings_init(&desc->settings);
    set(&desc->settings, "vpls=128 vals=8 map-size=32 rsm-size=64 shadow-size=128");
    camera_place(&desc->camera, &fixture->scene, 0, 0);
    check_ok("lights", emitters_from_text(&desc->emitters, &fixture->scene, NULL, 0));
    return 0;
}

static int set_up(void **state) {
    return set_up_scene(state, "scenes/cornell-box.glb");
}

static int set_up_moving(void **state) {
    return set_up_scene(state, "scenes/door.glb");
}

static int tear_down(void **state) {
    struct fixture *fixture = *state;
    if (fixture->context) {
        emitters_free(&fixture->desc.emitters);
        geometry_free(&fixture->geometry);
        scene_free(&fixture->scene);
        context_free(fixture->context);
    }
    free(fixture);
    return 0;
}

static struct fixture *need_context(void **state) {
    struct fixture *fixture = *state;
    if (!fixture->context)
        skip();
    return fixture;
}

static struct bitmap picture_of(struct renderer *renderer) {
    struct bitmap bitmap;
    renderer_render(renderer);
    renderer_read_display(renderer, &bitmap);
    return bitmap;
}

static bool same(const struct bitmap *a, const struct bitmap *b) {
    return a->width == b->width && a->height == b->height &&
           memcmp(a->rgba, b->rgba, (size_t)a->width * (size_t)a->height * 4) == 0;
}

/* The changed renderer's picture is bit for bit that of a new one of the same description. */
static void check_as_new(const char *what, struct renderer *renderer) {
    struct renderer fresh;
    check_ok("a new renderer", renderer_init(&fresh, &renderer->desc));
    struct bitmap expected = picture_of(&fresh), got = picture_of(renderer);
    if (!same(&expected, &got))
        fail_msg("%s: not the picture of a new renderer", what);
    bitmap_free(&expected);
    bitmap_free(&got);
    renderer_free(&fresh);
}

static void test_as_new(void **state) {
    struct fixture *fixture = need_context(state);
    struct renderer renderer;
    check_ok("init", renderer_init(&renderer, &fixture->desc));
    struct bitmap before = picture_of(&renderer);

    struct settings settings = renderer.desc.settings;
    for (const struct technique *const *t = techniques; *t; t++) {
        check_ok("technique", renderer_configure(&renderer, *t, &settings));
        check_as_new((*t)->name, &renderer);
    }
    set(&settings, "exposure=1");
    check_ok("exposure", renderer_configure(&renderer, technique_default, &settings));
    check_as_new("exposure", &renderer);
    set(&settings, "caster-long=10 shadow-size=64 vals=4");
    check_ok("settings", renderer_configure(&renderer, technique_default, &settings));
    check_as_new("settings", &renderer);
    check_ok("size", renderer_resize(&renderer, 33, 21));
    check_as_new("size", &renderer);

    struct emitter light[2] = {renderer.desc.emitters.items[0], renderer.desc.emitters.items[0]};
    light[0].type = EMITTER_POINT;
    light[0].position[1] -= .1F;
    check_ok("a light of six views", renderer_set_lights(&renderer, &(struct emitters){light, 1}));
    check_as_new("light", &renderer);
    check_ok("a second light", renderer_set_lights(&renderer, &(struct emitters){light, 2}));
    check_as_new("two lights", &renderer);
    light[1].intensity[0] /= 8;
    check_ok("a dimmer one", renderer_set_lights(&renderer, &(struct emitters){light, 2}));
    check_as_new("other shares of VPLs", &renderer);
    struct camera camera = renderer.desc.camera;
    camera.eye[0] += .2F;
    renderer_set_camera(&renderer, &camera);
    check_as_new("camera", &renderer);
    check_ok("shaders", renderer_reload_shaders(&renderer));
    check_as_new("shaders", &renderer);

    /* And all the way back. */
    check_ok("settings",
             renderer_configure(&renderer, fixture->desc.technique, &fixture->desc.settings));
    check_ok("light", renderer_set_lights(&renderer, &fixture->desc.emitters));
    renderer_set_camera(&renderer, &fixture->desc.camera);
    check_ok("size", renderer_resize(&renderer, WIDTH, HEIGHT));
    struct bitmap after = picture_of(&renderer);
    assert_true(same(&before, &after));
    bitmap_free(&before);
    bitmap_free(&after);
    renderer_free(&renderer);
    assert_int_equal(context_message_count(fixture->context), 0);
}

static void check_still_works(struct renderer *renderer, const struct bitmap *before) {
    struct bitmap after = picture_of(renderer);
    assert_true(same(before, &after));
    bitmap_free(&after);
}

static void write_text(const char *path, const char *text) {
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void test_failures(void **state) {
    struct fixture *fixture = need_context(state);
    struct renderer renderer;
    check_ok("init", renderer_init(&renderer, &fixture->desc));
    struct bitmap before = picture_of(&renderer);
    size_t bytes = gpu_memory_total();
    int objects = gpu_memory_object_count();

    struct settings settings = renderer.desc.settings;
    set(&settings, "vpls=1"); /* fewer than the pattern has places */
    assert_false(renderer_configure(&renderer, technique_default, &settings));
    check_still_works(&renderer, &before);

    assert_false(renderer_resize(&renderer, 1 << 20, 1));
    printf("    %s\n", error_get());
    check_still_works(&renderer, &before);

    assert_int_equal(context_message_count(fixture->context), 0);

    char output[256];
    char command[1200];
    const char *tree = scratch("tree");
    snprintf(
        command, sizeof command,
        "rm -rf %s && mkdir -p %s/src && cp -r glsl %s && cp -r src/techniques src/direct %s/src",
        tree, tree, tree, tree);
    run_command(command, output, sizeof output);
    write_text(scratch("tree/glsl/gather/gather.frag"), "void main() { nonsense }\n");
    glsl_set_folder(scratch("tree/glsl"));
    assert_false(renderer_reload_shaders(&renderer));
    assert_non_null(strstr(error_get(), "gather/gather.frag"));
    glsl_set_folder(NULL);
    check_still_works(&renderer, &before);

    assert_int_equal(gpu_memory_total(), bytes);
    assert_int_equal(gpu_memory_object_count(), objects);
    bitmap_free(&before);
    renderer_free(&renderer);
}

/* Through all techniques and back. */
static void go_round(struct renderer *renderer, const struct renderer_desc *desc) {
    struct settings settings = desc->settings;
    int odd = 0;
    for (const struct technique *const *t = techniques; *t; t++, odd = !odd) {
        set(&settings, odd ? "vals=8" : "vals=16");
        check_ok("configure", renderer_configure(renderer, *t, &settings));
        check_ok("resize", renderer_resize(renderer, WIDTH + odd, HEIGHT));
    }
    check_ok("back", renderer_configure(renderer, desc->technique, &desc->settings));
    check_ok("back", renderer_resize(renderer, WIDTH, HEIGHT));
}

/* What the pool of casters keeps is there after the first round. */
static void test_no_leak(void **state) {
    struct fixture *fixture = need_context(state);
    struct renderer renderer;
    check_ok("init", renderer_init(&renderer, &fixture->desc));
    go_round(&renderer, &fixture->desc);
    size_t bytes = gpu_memory_total();
    int objects = gpu_memory_object_count();
    for (int i = 0; i < 20; i++)
        go_round(&renderer, &fixture->desc);
    assert_int_equal(gpu_memory_total(), bytes);
    assert_int_equal(gpu_memory_object_count(), objects);
    renderer_free(&renderer);
    assert_int_equal(gpu_memory_object_count(), 0);
    assert_int_equal(gpu_memory_total(), 0);
}

/* Renders; the light's passes are drawn or kept, and either way the picture is a new renderer's. */
static void check_frame(const char *what, struct renderer *renderer, bool draws_lights) {
    renderer_render(renderer);
    static const char *const light_passes[] = {"frame/shadow map", "frame/rsm", "frame/vpls"};
    for (size_t i = 0; i < sizeof light_passes / sizeof *light_passes; i++) {
        double ms = timer_ms(&renderer->timers, light_passes[i]);
        printf("    %-20s %-18s %.3f ms\n", what, light_passes[i], ms);
        assert_true(draws_lights == (ms > 0));
    }
    assert_true(timer_ms(&renderer->timers, "frame/gather") > 0);
    check_as_new(what, renderer);
}

static void test_lights_are_kept(void **state) {
    struct fixture *fixture = need_context(state);
    struct renderer_desc desc = fixture->desc;
    struct renderer renderer;
    desc.timed = true;
    check_ok("init", renderer_init(&renderer, &desc));
    check_frame("first", &renderer, true);

    struct camera camera = desc.camera;
    struct emitter light = desc.emitters.items[0];
    const struct emitters lights = {&light, 1};
    struct settings settings = desc.settings;
    camera.eye[0] += .1F;
    check_ok("camera", renderer_update(&renderer, &lights, &camera));
    check_frame("camera", &renderer, false);
    set(&settings, "exposure=1");
    check_ok("exposure", renderer_configure(&renderer, technique_default, &settings));
    check_frame("exposure", &renderer, false);
    check_ok("size", renderer_resize(&renderer, 57, 31));
    check_frame("size", &renderer, false);
    light.position[1] -= .1F;
    check_ok("light", renderer_update(&renderer, &lights, &camera));
    check_frame("light", &renderer, true);
    set(&settings, "vals=4");
    check_ok("settings", renderer_configure(&renderer, technique_default, &settings));
    check_frame("settings", &renderer, true);
    check_ok("pose", geometry_pose(&fixture->geometry, &fixture->scene, 1));
    check_ok("pose", renderer_update(&renderer, &lights, &camera));
    check_frame("geometry", &renderer, true);
    check_ok("nothing", renderer_update(&renderer, &lights, &camera));
    check_frame("nothing", &renderer, false);
    renderer_free(&renderer);

    desc.keep_lights = false; /* as a benchmark has it */
    check_ok("init", renderer_init(&renderer, &desc));
    renderer_render(&renderer);
    check_frame("not kept", &renderer, true);
    renderer_free(&renderer);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_as_new, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_failures, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_no_leak, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_lights_are_kept, set_up_moving, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
