/* What stays and what is asked for, in the window's own process: a reference past other sizes, its
 * file, one error of one definition, a part of a clip; and words of presets and the first exposure,
 * which need no window. */
#define _XOPEN_SOURCE 700
#include "view_inside.h"

#include "renderer/settings.h"
#include "viewer/files/screenshot.h"
#include "viewer/panel/panel.h"
#include "viewer/picture/preset.h"
#include "viewer/reference/comparing.h"
#include "viewer/reference/tracing.h"
#include "viewer/scene/develop.h"
#include "viewer/scene/placed.h"
#include "viewer/scene/sessions.h"
#include "viewer/scene/sky.h"

#include <sys/stat.h>
#include <unistd.h>

static void begin(const char *scene) {
    const char *path = form("%s/%s", stage.here, scene);
    begin_viewer(&(struct viewer_desc){.scene = path, .width = 96, .height = 96});
}

/* The window gets another size, and is filled: minutes of tracing stay. */
TEST(reference_is_kept) {
    begin("scenes/cornell-box.glb");
    viewer_trace(&viewer);
    turn_until(viewer.tracing.samples >= 4 || !viewer_is_tracing(&viewer));
    const float *traced = viewer.shown.compare.reference.picture.pixels;
    window_set_size(viewer.host.window, PANEL + 140, 120);
    turn_until(viewer.host.input->height == 120);
    viewer_fill_window(&viewer);
    rest();
    printf("    filled: %d x %d, %d samples of %d x %d\n", viewer.shown.renderer.desc.width,
           viewer.shown.renderer.desc.height, viewer.tracing.samples, viewer.tracing.view.width,
           viewer.tracing.view.height);
    assert_int_equal(viewer.shown.renderer.desc.height, 120);
    assert_true(viewer.tracing.samples >= 4 && viewer.tracing.of_view);
    assert_non_null(traced);
    assert_false(viewer_has_reference_size(&viewer));
    assert_null(viewer.shown.right);
    /* It comes back with its size. */
    viewer_compare_reference(&viewer);
    rest();
    assert_int_equal(viewer.shown.renderer.desc.height, 96);
    assert_true(viewer_has_reference_size(&viewer) && viewer.shown.right);
}

/* Of layer indirect both numbers are one; of all light it is the same light's noise over a larger
 * mean. */
TEST(one_error) {
    double error, with_noise;
    need_server();
    reference_tracer_pause(&viewer.tracing.tracer, true);
    viewer.shown.layer = LAYER_INDIRECT;
    viewer.shown.compare.measured = false;
    viewer.shown.recompose = true;
    rest();
    turn_until(viewer.tracing.has_error && viewer_compared_error(&viewer, &error));
    with_noise = viewer.shown.compare.values[metric_find("relative-rmse") - metrics];
    printf("    reference %.6f, compare %.6f, with noise %.6f\n", viewer.tracing.error, error,
           with_noise);
    check_near("of the indirect layer", error, viewer.tracing.error, 1e-6);
    assert_true(with_noise > error);
    check_near("of the noise", with_noise * with_noise - error * error,
               viewer.tracing.noise * viewer.tracing.noise, 1e-6);
    viewer.shown.layer = LAYER_BEAUTY;
    assert_true(viewer_reference_noise(&viewer) > 0);
    assert_true(viewer_reference_noise(&viewer) < viewer.tracing.noise);
}

static double last_lasts(void) {
    struct message recent[MESSAGES_SHOWN];
    int count = messages_recent(&viewer.host.messages, recent);
    return count > 0 ? recent[count - 1].lasts : 0;
}

static enum name_state state_of(void *user, int number) {
    return number <= *(int *)user ? NAME_IS_TAKEN : NAME_IS_FREE;
}

static enum name_state refuse_name(void *user, int number) {
    (void)user, (void)number;
    error_set("refused");
    return NAME_IS_REFUSED;
}

/* Numbers have as many digits as they need. */
TEST(free_number) {
    int taken[] = {0, 9999, FREE_NUMBER_MOST};
    assert_int_equal(free_number(state_of, &taken[0]), 1);
    assert_int_equal(free_number(state_of, &taken[1]), 10000);
    assert_int_equal(free_number(state_of, &taken[2]), 0);
    printf("    %s\n", error_get());
    assert_non_null(strstr(error_get(), "999999"));
    assert_int_equal(free_number(refuse_name, NULL), 0);
    assert_string_equal(error_get(), "refused");
}

/* Names of 1 to 9999 in the working folder. */
static void take_names(const char *format) {
    for (int i = 1; i < 10000; i++) {
        const char *name = form(format, i);
        FILE *file = fopen(name, "w");
        assert_non_null(file);
        fclose(file);
    }
}

static long size_of(const char *name) {
    struct stat info;
    return stat(name, &info) == 0 ? (long)info.st_size : -1;
}

/* The ten thousandth picture overwrites none. */
TEST(no_picture_is_overwritten) {
    char here[512];
    need_server();
    assert_non_null(getcwd(here, sizeof here));
    assert_int_equal(shell("mkdir -p %s/full", stage.folder), 0);
    assert_int_equal(chdir(in_stage("full")), 0);
    take_names("manylight-%04d.exr");
    take_names("manylight-reference-%04d.exr");
    viewer_take_screenshot(&viewer);
    viewer_save_reference(&viewer);
    long sizes[] = {size_of("manylight-9999.exr"), size_of("manylight-reference-9999.exr"),
                    size_of("manylight-10000.png"), size_of("manylight-10000.exr"),
                    size_of("manylight-reference-10000.exr")};
    assert_int_equal(chdir(here), 0);
    printf("    bytes: 9999: %ld and %ld, 10000: %ld, %ld and %ld\n", sizes[0], sizes[1], sizes[2],
           sizes[3], sizes[4]);
    assert_true(sizes[0] == 0 && sizes[1] == 0);
    assert_true(sizes[2] > 0 && sizes[3] > 0 && sizes[4] > 0);
    assert_int_equal(shell("rm -r %s", in_stage("full")), 0);
}

TEST(reference_is_saved) {
    struct image saved = {0};
    char here[512];
    need_server();
    const struct image *traced = &viewer.shown.compare.reference.picture;
    assert_non_null(getcwd(here, sizeof here));
    assert_int_equal(chdir(stage.folder), 0);
    viewer_save_reference(&viewer);
    check_ok("file", image_read(&saved, "manylight-reference-0001.exr"));
    assert_true(last_lasts() >= 60); /* seconds that its path is shown */
    assert_int_equal(chdir(here), 0);
    assert_int_equal(saved.width, traced->width);
    assert_int_equal(saved.channel_count, traced->channel_count);
    int a[3], b[3], wrong = 0;
    assert_true(image_find_layer(&saved, "indirect", a) && image_find_layer(traced, "indirect", b));
    for (int i = 0; i < saved.width * saved.height; i++)
        for (int c = 0; c < 3; c++) {
            float x = saved.pixels[i * saved.channel_count + a[c]];
            float y = traced->pixels[i * traced->channel_count + b[c]];
            wrong += fabsf(x - y) > 2e-3F * fabsf(y) + 1e-6F;
        }
    printf("    %d layers, %d values wrong\n", saved.channel_count, wrong);
    assert_int_equal(wrong, 0);
    image_free(&saved);
    reference_tracer_pause(&viewer.tracing.tracer, false);
    finish_viewer();
}

static bool refuse(void **state, const struct direct_desc *desc) {
    (void)state, (void)desc;
    return error_set("no memory for these shadows");
}

/* A method of direct light that cannot be made is told, and the wish goes back to the one before */
TEST(refused_direct) {
    begin("scenes/cornell-box.glb");
    struct direct_method refused = *direct_find("hard");
    refused.init = refuse;
    static const char *const before[] = {NULL, "pcss"};
    for (int i = 0; i < 2; i++) {
        const struct direct_method *method = before[i] ? direct_find(before[i]) : NULL;
        viewer.wish.direct = method;
        viewer_touch(&viewer);
        rest();
        messages_forget_errors(&viewer.host.messages);
        viewer.wish.direct = &refused;
        viewer_touch(&viewer);
        rest();
        printf("    after a refused method: %s, drawn with %s\n",
               viewer.wish.direct ? viewer.wish.direct->name : "by the lights",
               viewer.shown.renderer.desc.direct->name);
        assert_true(is_message_told("no memory for these shadows", UI_ERROR));
        assert_ptr_equal(viewer.wish.direct, method);
        assert_ptr_equal(viewer.shown.renderer.desc.direct, direct_find(method ? "pcss" : "hard"));
    }
    finish_viewer();
}

/* Light in false colours is saved with its scale, as `probe --map` draws both. */
TEST(light_is_saved) {
    const char *scene = form("%s/scenes/cornell-box.glb", stage.here), *path;
    begin_viewer(&(struct viewer_desc){.scene = scene, .width = 256, .height = 64});
    viewer.shown.choice.output = "illuminance";
    viewer.shown.recompose = true;
    rest();
    path = in_stage("light.png");
    check_ok(path, viewer_write_picture(&viewer, path));
    OWNED(bitmap) saved = read_bitmap(path), expected;
    heat_map_draw(&viewer.shown.inspect.light, &expected);
    assert_int_equal(count_differences(&saved, &expected), 0);
    finish_viewer();
}

/* --- time ------------------------------------------------------------------------------------- */

/* The timeline has its own room, below the picture; the window has grown by it. */
TEST(timeline) {
    begin("scenes/moving-spot.glb");
    const struct rectangle *area = &viewer.shown.area, *picture = &viewer.shown.picture;
    turn_until(viewer.host.input->height > 96);
    rest();
    printf("    window %d, picture %d to %d, timeline %.0f\n", viewer.host.input->height,
           picture->y, picture->y + picture->height, (double)timeline_height(&viewer));
    assert_true(timeline_height(&viewer) > 20);
    assert_int_equal(area->height + (int)timeline_height(&viewer), viewer.host.input->height);
    assert_true(picture->y + picture->height <= area->height);
    assert_int_equal(viewer.shown.renderer.desc.height, 96);
    finish_viewer();
}

/* --- one scene after another ------------------------------------------------------------------ */

static void open_scene(const char *scene) {
    const char *path = form("%s/%s", stage.here, scene);
    viewer_open(&viewer, path);
    turn_until(!viewer_is_opening(&viewer) && strcmp(viewer.document.scene.path, path) == 0);
    turn();
}

/* Settings go from scene to scene, and the others' files do not. */
TEST(second_scene) {
    begin("scenes/cornell-box.glb");
    check_ok("settings", settings_assign(&viewer.wish.settings, "vpls=32"));
    viewer.wish.passes = 4;
    snprintf(viewer.panel.session_path, sizeof viewer.panel.session_path, "a.settings");
    check_ok("camera", viewer_place_camera(&viewer, "eye=0,1,5 forward=0,0,-1"));
    open_scene("scenes/three-lights.glb");
    printf("    %g virtual lights, settings in %s\n",
           settings_number(&viewer.wish.settings, "lights.vpls"), viewer.panel.session_path);
    assert_int_equal(settings_number(&viewer.wish.settings, "lights.vpls"), 32);
    assert_string_equal(viewer.panel.session_path, "manylight.settings");
    assert_false(viewer.placed.camera_moved);
    finish_viewer();
}

TEST(settings_name_no_clip) {
    begin("scenes/gloss.glb");
    const char *path = form("%s/old.settings", stage.folder);
    assert_int_equal(shell("printf 'clip = 0\\npasses = 3\\n' > %s", path), 0);
    assert_int_equal(viewer.document.scene.clip_count, 0);
    check_ok("clip 0 of none", viewer_load_session(&viewer, path));
    assert_int_equal(viewer.wish.passes, 3);
    assert_false(is_message_told("", UI_ERROR));
    finish_viewer();
}

/* --- without a window ------------------------------------------------------------------------- */

TEST(words) {
    static const char *const pairs[][2] = {{"path=fast", "path=normal"},
                                           {"path=traced", "path=high"}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        struct settings a, b;
        renderer_settings_init(&a);
        renderer_settings_init(&b);
        check_ok(pairs[i][0], renderer_settings_assign(&a, technique_default, &pairs[i][0], 1));
        check_ok(pairs[i][1], renderer_settings_assign(&b, technique_default, &pairs[i][1], 1));
        assert_true(renderer_settings_same(&a, &b, technique_default->parts));
    }
    for (const struct preset *p = technique_default->presets; p->name; p++) {
        char title[PRESET_TITLE_SIZE], help[PRESET_HELP_SIZE];
        preset_title(p, title);
        preset_explain(p, help);
        printf("    %-8s %s\n", title, help);
        assert_non_null(strstr(help, "On the command line: --"));
    }
}

/* A fiftieth of the picture stays below white; a hundredth may not be. */
TEST(exposure) {
    static const char *const names[] = {"R", "G", "B"};
    for (int bright = 1; bright <= 4; bright += 3) {
        OWNED(image) image = {0};
        image_init_named(&image, 100, 10, names, 3);
        for (int i = 0; i < 1000; i++)
            for (int c = 0; c < 3; c++)
                image.pixels[3 * i + c] = i < 10 * bright ? 20 : .1F;
        float ev = develop_exposure(&image);
        printf("    %d %% at 20: %g EV, shown as if %.2f\n", bright, (double)ev,
               20 * exp2((double)ev));
        if (bright == 4)
            check_at_most("the lamp's place", 20 * exp2((double)ev), 2.75);
        else
            check_near("by the middle", (double)ev, .5, .01);
    }
}

RUN_TESTS(open_view_stage, close_view_stage)
