/* The viewer over and over: techniques, scenes, sizes, wipes, animations, minimised and back. What
 * GL holds and what memory takes stay as they were, and GL has nothing to say.
 *
 *     build/test/test_view_leaks [ROUNDS]     at least so many; 200 takes minutes
 */
#define _GNU_SOURCE
#include "view_inside.h"

#include "desktop.h"

#include "gl/memory.h"
#include "viewer/picture/look.h"
#include "viewer/picture/picture.h"
#include "viewer/reference/tracing.h"
#include "viewer/scene/animation.h"
#include "viewer/scene/lights.h"
#include "viewer/scene/placed.h"
#include "viewer/window/ui.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <dirent.h>
#include <malloc.h>

static int rounds = 4;

/* --- what there is --- */

static int count_objects(const char *function) {
    enum {
        NAMES = 1 << 18
    }; /* GL hands names out from 1 on; not all drivers take those first that became free again */
    GLboolean (*is)(GLuint) = (GLboolean(*)(GLuint))window_getproc(function);
    assert_non_null(is);
    int count = 0;
    for (GLuint name = 1; name < NAMES; name++)
        count += is(name) != 0;
    return count;
}

struct holdings {
    int objects[5];
    size_t gpu_bytes;
    double resident; /* MiB */
};

static const char *const kinds[5] = {"glIsTexture", "glIsBuffer", "glIsFramebuffer",
                                     "glIsVertexArray", "glIsQuery"};

static struct holdings take_stock(void) {
    struct holdings holdings = {.gpu_bytes = gpu_memory_total()};
    for (int i = 0; i < 5; i++)
        holdings.objects[i] = count_objects(kinds[i]);
    malloc_trim(0);
    holdings.resident = mem_resident();
    return holdings;
}

static void print_holdings(const char *when, const struct holdings *holdings) {
    printf("    %-28s textures %d, buffers %d, framebuffers %d, vertex arrays %d, queries %d, "
           "%.1f MiB of GPU, %.0f MiB resident\n",
           when, holdings->objects[0], holdings->objects[1], holdings->objects[2],
           holdings->objects[3], holdings->objects[4], (double)holdings->gpu_bytes / (1 << 20),
           holdings->resident);
    fflush(stdout);
}

/* --- turns --- */

static void turns(int count) {
    for (int i = 0; i < count; i++)
        turn();
}

static void load(const char *path) {
    viewer_open(&viewer, path);
    turn();
    turn_until(!viewer_is_opening(&viewer));
    turns(2);
}

/* What is wanted is there. */
static void settle(void) {
    turns(2);
    turn_until(!viewer.shown.awaits);
    turn();
}

static const struct technique *technique_of(int round) {
    static const char *const names[] = {"clustered", "unshadowed", "instant-radiosity"};
    return technique_find(names[round % 3]);
}

static void switch_technique(int round) {
    viewer.wish.technique = technique_of(round);
    check_ok("VALs", settings_assign(&viewer.wish.settings, round % 2 ? "vals=5" : "vals=4"));
    viewer_touch(&viewer);
    settle();
}

static void switch_scene(int round) {
    static const char *const scenes[] = {"scenes/metaballs.glb", "scenes/no-such-file.glb",
                                         "scenes/moving-spot.glb", "scenes/cornell-box.glb"};
    load(scenes[round % 4]);
}

static void switch_size(int round) {
    window_set_size(viewer.host.window, PANEL + 100 + 7 * (round % 5), 90 + 5 * (round % 3));
    turns(2);
}

static void switch_wipe(int round) {
    viewer.shown.compare.mode = round % 2 ? COMPARE_OFF : COMPARE_TECHNIQUE;
    viewer.shown.compare.technique = technique_of(round / 2);
    viewer_touch(&viewer);
    settle();
}

static void switch_output(int round) {
    (void)round;
    viewer_step_output(&viewer, 1);
    turn();
}

static void play(int round) {
    viewer.wish.play.on = true;
    viewer_go_to(&viewer, .07 * round);
    turn();
    viewer.wish.play.on = false;
}

/* One more, of another type, and away again. */
static void change_lights(int round) {
    viewer_add_light(&viewer, (enum emitter_type)(round % 4));
    settle();
    viewer_retype_light(&viewer, (enum emitter_type)((round + 1) % 4));
    settle();
    viewer_remove_light(&viewer);
    settle();
}

static void look_closely(int round) {
    viewer.shown.compare.mode = COMPARE_TECHNIQUE;
    viewer.shown.compare.technique = technique_of(round);
    viewer_touch(&viewer);
    viewer.look.inspects = round % 2;
    look_step_layout(&viewer);
    look_scroll(&viewer, round);
    views_keep(&viewer, round % SESSION_VIEWS);
    settle();
    views_go(&viewer, (round + 1) % SESSION_VIEWS);
    turns(2);
}

static void change_scale(int round) {
    window_set_scale(viewer.host.window, round % 2 ? 1 : 1.25F);
    turns(3);
}

static void minimise(int round) {
    char output[64];
    assert_int_equal(run_command("xdotool search --name manylight", output, sizeof output), 0);
    assert_true(desktop_minimise(strtoul(output, NULL, 10), round % 2 == 0));
    pause_ms(30);
    turns(2);
    if (round % 2 == 0)
        assert_int_equal(viewer.host.input->width, 0);
    else
        assert_true(viewer.host.input->width > 0);
}

static void trace(int round) {
    viewer_trace(&viewer);
    turn_until(viewer.tracing.samples > 0);
    if (round % 2)
        viewer_forget_reference(&viewer);
}

static void table(int round) {
    viewer_measure(&viewer);
    turn_until(viewer.tracing.table.next > round % 3);
    viewer_take_row(&viewer, 0);
    settle();
}

/* As at the beginning, so that what is there can be compared. */
static void go_back(void) {
    viewer.wish.technique = technique_default;
    viewer.wish.settings = viewer.desc.settings;
    viewer.shown.compare.mode = COMPARE_OFF;
    viewer_forget_reference(&viewer);
    viewer.look = (struct look){0};
    viewer.shown.choice.output = "normal"; /* whatever output was shown, one canvas is there */
    viewer.shown.recompose = true;
    window_set_size(viewer.host.window, PANEL + 100, 90);
    load("scenes/metaballs.glb");
    viewer_go_to(&viewer, 0);
    settle();
    turns(30);
    pause_ms(300);
    turns(3);
    rest();
    viewer.shown.choice.output = NULL;
    viewer.shown.recompose = true;
    turn();
}

static void check_kept(const char *what, void (*step)(int round), int least) {
    int count = rounds > least ? rounds : least;
    for (int i = 0; i < least; i++) /* once through all, so that caches are full */
        step(i);
    go_back();
    struct holdings before = take_stock();
    print_holdings(what, &before);
    for (int i = 0; i < count; i++)
        step(i);
    go_back();
    struct holdings after = take_stock();
    const char *when = form("after %d", count);
    print_holdings(when, &after);
    for (int i = 0; i < 5; i++)
        if (after.objects[i] != before.objects[i])
            fail_msg("%s: %s: %d, then %d", what, kinds[i], before.objects[i], after.objects[i]);
    assert_int_equal(after.gpu_bytes, before.gpu_bytes);
#ifndef __SANITIZE_ADDRESS__ /* which keeps freed memory for a while */
    /* What grew by a picture or a scene a round would be more. */
    assert_true(after.resident - before.resident < 24);
#endif
    assert_int_equal(context_message_count(viewer.host.context), 0);
}

/* A driver that the user interface cannot use: what was begun of it ends well. */
TEST(no_interface) {
    need_server();
    struct window *window =
        window_create(&(struct window_desc){.title = "manylight", .width = 60, .height = 40});
    assert_non_null(window);
    keep_driver();
    ui_free();
    glfwMakeContextCurrent(NULL);
    check_refused(ui_init(window_native(window), 1), "");
    ui_free();
    glfwMakeContextCurrent(window_native(window));
    check_ok("user interface", ui_init(window_native(window), 1));
    ui_free();
    window_free(window);
}

/* Nothing has changed, and nothing is rendered. */
static void check_rest(void) {
    int before = viewer.shown.frame_count;
    turns(5);
    printf("    %-28s %d frames rendered\n", "five turns at rest",
           viewer.shown.frame_count - before);
    assert_int_equal(viewer.shown.frame_count, before);
}

TEST(kept) {
    begin_viewer(&(struct viewer_desc){.width = 100, .height = 90});
    load("scenes/metaballs.glb");
    go_back();
    check_rest();
    check_kept("techniques", switch_technique, 6);
    check_kept("scenes", switch_scene, 4);
    check_kept("sizes", switch_size, 6);
    check_kept("frames of an animation", play, 40);
    check_kept("references traced", trace, 2);
    check_kept("lights", change_lights, 8);
    check_kept("wipes", switch_wipe, 6);
    check_kept("outputs", switch_output, 14);
    check_kept("scales of widgets", change_scale, 2);
    check_kept("minimised and back", minimise, 2);
    check_kept("tables", table, 3);
    check_kept("looking closely", look_closely, 6);
    viewer_end(&viewer);
    assert_int_equal(gpu_memory_object_count(), 0);
    assert_int_equal(gpu_memory_total(), 0);
}

/* Each file of the folder, one after another: shown or refused, and the next is opened. */
static int open_all(const char *folder) {
    struct dirent **entries;
    int count = scandir(folder, &entries, NULL, alphasort), opened = 0;
    for (int i = 0; i < count; i++) {
        const char *path = form("%s/%s", folder, entries[i]->d_name);
        if (entries[i]->d_name[0] != '.') {
            load(path);
            opened++;
        }
        free(entries[i]);
    }
    free(entries);
    return opened;
}

/* The files of strangers that fuzzing begins with, or those of the folder MANYLIGHT_STRANGERS; a
 * scene that is whole is shown after them. */
TEST(strangers) {
    const char *folder = getenv("MANYLIGHT_STRANGERS");
    begin_viewer(&(struct viewer_desc){.width = 100, .height = 90});
    int count = open_all(folder ? folder : "test/fuzz/seeds/scene");
    load("scenes/cornell-box.glb");
    printf("    %d files opened; then %s is shown, %.0f MiB at most\n", count,
           viewer.document.scene.path, mem_most_resident());
    assert_true(count > 0 && viewer.has_scene);
    assert_string_equal(viewer.document.scene.path, "scenes/cornell-box.glb");
    viewer_end(&viewer);
}

int main(int argc, char **argv) {
    if (argc > 1)
        rounds = atoi(argv[1]);
    return run_file(__FILE__, open_view_stage, close_view_stage);
}
