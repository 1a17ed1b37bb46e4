/* A renderer that is changed while it runs: the picture is that of one made anew, nothing leaks,
 * and what fails leaves it as it was. */
#include "support.h"

#include "gl/context/context.h"
#include "gl/glsl.h"
#include "gl/memory.h"
#include "renderer/renderer.h"
#include "scene/placing.h"

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
    fixture->context = context_create(&(struct context_desc){.debug = true});
    if (!fixture->context)
        return 0;
    check_ok("scene", scene_load(&fixture->scene, path));
    check_ok("geometry", geometry_init(&fixture->geometry, &fixture->scene, 0));
    struct renderer_desc *desc = &fixture->desc;
    *desc = FILLED(renderer_desc, .width = WIDTH, .height = HEIGHT, .technique = technique_default,
                   .scene = &fixture->scene, .geometry = &fixture->geometry, .keep_lights = true);
    renderer_settings_init(&desc->settings);
    set(&desc->settings, "vpls=128 vals=8 map-size=32 rsm-size=64 shadow-size=128");
    camera_place(&desc->camera, &fixture->scene, 0, 0);
    check_ok("lights", emitters_from_text(&desc->emitters, &fixture->scene, NULL, 0));
    return 0;
}

static int set_up(void **state) {
    return set_up_scene(state, "scenes/cornell-box.glb");
}

static int set_up_sky(void **state) {
    return set_up_scene(state, "scenes/courtyard.glb");
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
    check_ok("display", renderer_read_display(renderer, &bitmap));
    return bitmap;
}

static bool same(const struct bitmap *a, const struct bitmap *b) {
    return a->width == b->width && a->height == b->height &&
           memcmp(a->rgba, b->rgba, (size_t)a->width * (size_t)a->height * 4) == 0;
}

/* The changed renderer's picture is bit for bit that of a new one of the same description. */
static void check_as_new(const char *what, struct renderer *renderer) {
    OWNED(renderer) fresh;
    check_ok("a new renderer", renderer_init(&fresh, &renderer->desc));
    OWNED(bitmap) expected = picture_of(&fresh), got = picture_of(renderer);
    if (!same(&expected, &got))
        fail_msg("%s: not the picture of a new renderer", what);
}

static void check_followed(const char *what, struct renderer *renderer,
                           const struct renderer_desc *desc) {
    check_ok(what, renderer_follow(renderer, desc));
    check_as_new(what, renderer);
}

TEST_WITH(as_new, set_up, tear_down) {
    struct fixture *fixture = need_context(state);
    struct renderer renderer;
    check_ok("init", renderer_init(&renderer, &fixture->desc));
    struct bitmap before = picture_of(&renderer);

    struct renderer_desc desc = fixture->desc;
    for (const struct technique *const *t = techniques; *t; t++) {
        desc.technique = *t;
        check_followed((*t)->name, &renderer, &desc);
    }
    desc.technique = technique_default;
    set(&desc.settings, "exposure=1");
    check_followed("exposure", &renderer, &desc);
    set(&desc.settings, "caster-long=10 shadow-size=64 vals=4");
    check_followed("settings", &renderer, &desc);
    desc.width = 33, desc.height = 21;
    check_followed("size", &renderer, &desc);

    struct emitter light[2] = {desc.emitters.items[0], desc.emitters.items[0]};
    light[0].type = EMITTER_POINT;
    light[0].position[1] -= .1F;
    desc.emitters = (struct emitters){.items = light, .count = 1};
    check_followed("a light of six views", &renderer, &desc);
    desc.emitters.count = 2;
    check_followed("a second light", &renderer, &desc);
    light[1].intensity[0] /= 8;
    check_followed("a dimmer one: other shares of VPLs", &renderer, &desc);
    desc.camera.eye[0] += .2F;
    check_followed("camera", &renderer, &desc);
    check_ok("shaders", renderer_reload_shaders(&renderer));
    check_as_new("shaders", &renderer);
    desc.technique = technique_baseline;
    desc.width = 30;
    desc.emitters.count = 1;
    set(&desc.settings, "samples=1 caster-long=5");
    check_followed("all at once", &renderer, &desc);

    /* And all the way back. */
    check_ok("back", renderer_follow(&renderer, &fixture->desc));
    struct bitmap after = picture_of(&renderer);
    assert_true(same(&before, &after));
    bitmaps_free(&before, &after);
    renderer_free(&renderer);
    assert_int_equal(context_message_count(fixture->context), 0);
}

static void check_still_works(struct renderer *renderer, const struct bitmap *before) {
    OWNED(bitmap) after = picture_of(renderer);
    assert_true(same(before, &after));
}

/* Where pixels share more in large pictures, a picture that became large has nothing left of a
 * small one's. */
TEST_WITH(sizes, set_up, tear_down) {
    struct fixture *fixture = need_context(state);
    OWNED(renderer) renderer;
    struct renderer_desc desc = fixture->desc;
    check_ok("init", renderer_init(&renderer, &desc));
    for (const struct technique *const *t = techniques; *t; t++) {
        if (!is_tried_here((size_t)(t - techniques), 3))
            continue;
        desc.technique = *t;
        desc.width = WIDTH, desc.height = HEIGHT;
        check_ok((*t)->name, renderer_follow(&renderer, &desc));
        desc.width = 480, desc.height = 440;
        check_followed((*t)->name, &renderer, &desc);
        desc.width = WIDTH, desc.height = HEIGHT;
        check_followed((*t)->name, &renderer, &desc);
    }
}

TEST_WITH(failures, set_up, tear_down) {
    struct fixture *fixture = need_context(state);
    OWNED(renderer) renderer;
    check_ok("init", renderer_init(&renderer, &fixture->desc));
    OWNED(bitmap) before = picture_of(&renderer);
    size_t bytes = gpu_memory_total();
    int objects = gpu_memory_object_count();

    struct renderer_desc desc = renderer.desc;
    set(&desc.settings, "vpls=1"); /* fewer than the pattern has places */
    assert_false(renderer_follow(&renderer, &desc));
    check_still_works(&renderer, &before);

    desc = renderer.desc;
    desc.width = 1 << 20;
    check_refused(renderer_follow(&renderer, &desc), "");
    check_still_works(&renderer, &before);

    /* Lights too many for the technique that comes with them. */
    desc = renderer.desc;
    desc.technique = technique_find("imperfect-volume");
    desc.emitters =
        (struct emitters){.items = mem_alloc(65, sizeof *desc.emitters.items), .count = 65};
    for (int i = 0; i < 65; i++) {
        desc.emitters.items[i] = renderer.desc.emitters.items[0];
        desc.emitters.items[i].type = EMITTER_POINT;
    }
    check_refused(renderer_follow(&renderer, &desc), "");
    emitters_free(&desc.emitters);
    check_still_works(&renderer, &before);

    assert_int_equal(context_message_count(fixture->context), 0);

    char output[256];
    const char *tree = scratch("tree");
    const char *command =
        form("rm -rf %s && mkdir -p %s/src && cp -r glsl %s && cp -r src/passes src/techniques "
             "src/direct src/inspect %s/src",
             tree, tree, tree, tree);
    run_command(command, output, sizeof output);
    write_text(scratch("tree/src/passes/gather/gather.frag"), "void main() { nonsense }\n");
    glsl_set_folder(scratch("tree/glsl"));
    check_refused(renderer_reload_shaders(&renderer), "passes/gather/gather.frag");
    glsl_set_folder(NULL);
    check_still_works(&renderer, &before);

    assert_int_equal(gpu_memory_total(), bytes);
    assert_int_equal(gpu_memory_object_count(), objects);
}

static PFNGLGETERRORPROC get_error;
static int calls_left; /* of get_error: the next one tells of no memory */

static GLenum APIENTRY fail_once(void) {
    return calls_left-- == 0 ? GL_OUT_OF_MEMORY : get_error();
}

/* Each allocation of a change fails once. */
static void check_out_of_memory(struct renderer *renderer, const struct renderer_desc *desc) {
    const struct renderer_desc old = renderer->desc;
    OWNED(bitmap) before = picture_of(renderer);
    size_t bytes = gpu_memory_total();
    int failures = 0;
    calls_left = 0;
    for (int n = 0; calls_left < 0 || n == 0; n++) {
        calls_left = n;
        gl.GetError = fail_once;
        bool followed = renderer_follow(renderer, desc);
        gl.GetError = get_error;
        failures += !followed;
        if (followed)
            check_ok("back", renderer_follow(renderer, &old));
        assert_int_equal(gpu_memory_total(), bytes);
        if (!followed && failures % 6 == 0)
            check_still_works(renderer, &before);
    }
    printf("    %s: %d failures\n", desc->technique->name, failures);
    assert_true(failures > 10);
}

TEST_WITH(out_of_memory, set_up_sky, tear_down) {
    struct fixture *fixture = need_context(state);
    OWNED(renderer) renderer;
    struct renderer_desc desc = fixture->desc;
    get_error = gl.GetError;
    check_ok("init", renderer_init(&renderer, &desc));
    for (const struct technique *const *t = techniques; *t; t++) {
        if (!is_tried_here((size_t)(t - techniques), 3))
            continue;
        desc.technique = *t;
        desc.width = WIDTH;
        check_ok((*t)->name, renderer_follow(&renderer, &desc));
        desc.width = WIDTH + 9;
        check_out_of_memory(&renderer, &desc);
    }
}

/* Through all techniques and back. */
static void go_round(struct renderer *renderer, const struct renderer_desc *desc) {
    struct renderer_desc wanted = *desc;
    int odd = 0;
    for (const struct technique *const *t = techniques; *t; t++, odd = !odd) {
        set(&wanted.settings, odd ? "vals=8" : "vals=16");
        wanted.technique = *t;
        wanted.width = WIDTH + odd;
        check_ok("follow", renderer_follow(renderer, &wanted));
    }
    check_ok("back", renderer_follow(renderer, desc));
}

/* What the pool of casters keeps is there after the first round. */
TEST_WITH(no_leak, set_up, tear_down) {
    struct fixture *fixture = need_context(state);
    struct renderer renderer;
    check_ok("init", renderer_init(&renderer, &fixture->desc));
    go_round(&renderer, &fixture->desc);
    size_t bytes = gpu_memory_total();
    int objects = gpu_memory_object_count();
    for (int i = 0; i < (is_long_run() ? 20 : 5); i++)
        go_round(&renderer, &fixture->desc);
    assert_int_equal(gpu_memory_total(), bytes);
    assert_int_equal(gpu_memory_object_count(), objects);
    renderer_free(&renderer);
    assert_int_equal(gpu_memory_object_count(), 0);
    assert_int_equal(gpu_memory_total(), 0);
}

/* Follows and renders; the light's passes are drawn or kept, and either way the picture is a new
 * renderer's. */
static void check_frame(const char *what, struct renderer *renderer,
                        const struct renderer_desc *desc, bool draws_lights) {
    check_ok(what, renderer_update(renderer) && renderer_follow(renderer, desc));
    renderer_render(renderer);
    timers_flush(&renderer->timers); /* a GPU tells times frames later */
    static const char *const light_passes[] = {"frame/shadow map", "frame/rsm", "frame/vpls"};
    for (size_t i = 0; i < sizeof light_passes / sizeof *light_passes; i++) {
        double ms = timer_ms(&renderer->timers, light_passes[i]);
        printf("    %-20s %-18s %.3f ms\n", what, light_passes[i], ms);
        assert_true(draws_lights == (ms > 0));
    }
    assert_true(timer_ms(&renderer->timers, "frame/gather") > 0);
    check_as_new(what, renderer);
}

TEST_WITH(lights_are_kept, set_up_moving, tear_down) {
    struct fixture *fixture = need_context(state);
    struct renderer_desc desc = fixture->desc;
    OWNED(renderer) renderer;
    desc.timed = true;
    check_ok("init", renderer_init(&renderer, &desc));
    check_frame("first", &renderer, &desc, true);

    struct emitter light = desc.emitters.items[0];
    desc.emitters = (struct emitters){.items = &light, .count = 1};
    desc.camera.eye[0] += .1F;
    check_frame("camera", &renderer, &desc, false);
    set(&desc.settings, "exposure=1");
    check_frame("exposure", &renderer, &desc, false);
    desc.width = 57, desc.height = 31;
    check_frame("size", &renderer, &desc, false);
    light.position[1] -= .1F;
    check_frame("light", &renderer, &desc, true);
    set(&desc.settings, "vals=4");
    check_frame("settings", &renderer, &desc, true);
    check_ok("pose", geometry_pose(&fixture->geometry, &fixture->scene, 1));
    check_frame("geometry", &renderer, &desc, true);
    check_frame("nothing", &renderer, &desc, false);
    renderer_free(&renderer);

    desc.keep_lights = false; /* as a benchmark has it */
    check_ok("init", renderer_init(&renderer, &desc));
    renderer_render(&renderer);
    check_frame("not kept", &renderer, &desc, true);
}

RUN_TESTS(NULL, NULL)
