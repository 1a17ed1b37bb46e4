/* Shaders are compiled in the background: the window takes turns meanwhile and shows what it has
 * shown, or, where the camera moves, goes on with the shaders that it has. */
#define _XOPEN_SOURCE 700
#include "view_inside.h"

/* While shaders are compiled. */
struct waiting {
    int turns, frames;
};

static bool waits(void) {
    return viewer.shown.awaits || viewer_is_opening(&viewer);
}

static struct waiting wait_for_shaders(const char *what, bool moves) {
    struct waiting waiting = {0};
    const struct technique *before = viewer.has_scene ? viewer.shown.renderer.desc.technique : NULL;
    int first = viewer.shown.frame_count;
    for (turn(); waits(); turn()) {
        waiting.turns++;
        waiting.frames = viewer.shown.frame_count - first;
        if (before)
            assert_ptr_equal(viewer.shown.renderer.desc.technique, before);
        if (moves) {
            viewer.placed.orbit.camera.eye[0] += .001F;
            viewer_touch(&viewer);
        }
    }
    printf("    %-28s %d turns and %d frames meanwhile\n", what, waiting.turns, waiting.frames);
    while (viewer.shown.dirty || viewer.shown.coarse || viewer.shown.moving)
        turn();
    assert_ptr_equal(viewer.shown.renderer.desc.technique, viewer.wish.technique);
    return waiting;
}

static void choose(const char *technique) {
    viewer.wish.technique = technique_find(technique);
    viewer_touch(&viewer);
}

TEST(compiling) {
    begin_viewer(&(struct viewer_desc){.width = 100, .height = 90});
    viewer_open(&viewer, "scenes/cornell-box.glb");
    struct waiting first = wait_for_shaders("the first picture", false);
    choose("unshadowed");
    struct waiting still = wait_for_shaders("another technique", false);
    choose("instant-radiosity");
    struct waiting moving = wait_for_shaders("another, and the camera moves", true);
    choose("unshadowed");
    struct waiting back = wait_for_shaders("back", false);
    check_ok("lookup", settings_assign(&viewer.wish.settings, "shadow-size=64 visibility=pcss"));
    choose("clustered");
    viewer.shown.compare.mode = COMPARE_TECHNIQUE;
    viewer.shown.compare.settings = viewer.wish.settings;
    struct waiting both = wait_for_shaders("two pictures", false);
    assert_true(viewer.shown.compare.has_other);
    assert_true(first.turns > 0 && still.turns > 0 && moving.turns > 0 && both.turns > 0);
    assert_int_equal(still.frames, 0);
    assert_true(moving.frames > 0 || moving.turns < 4);
    assert_int_equal(back.turns, 0);
    finish_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
