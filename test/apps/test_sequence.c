/* Sequences: every frame depends on its time alone, is written whole, and costs no memory. */
#define _POSIX_C_SOURCE 200809L
#include "command_support.h"
#include "render_support.h"

#include "apps/frames.h"
#include "gl/memory.h"
#include "scene/shapes/metaballs.h"
#include "shared/vpl.h"

#include <sys/stat.h>
#include <unistd.h>

static const char scene_path[] = "scenes/metaballs.glb";
static const char small[] = "vpls=64 vals=6 map-size=32 rsm-size=64 shadow-size=128 iterations=2";

/* --- which frames ----------------------------------------------------------------------------- */

TEST(ranges) {
    struct frames frames;
    check_ok("mixed", frames_parse(&frames, "3..5,9,0..11x5"));
    static const int expected[] = {3, 4, 5, 9, 0, 5, 10};
    assert_int_equal(frames.count, 7);
    assert_memory_equal(frames.numbers, expected, sizeof expected);
    frames_free(&frames);
    static const char *const wrong[] = {"",           "a",     "1,",    "1..", "5..4",
                                        "-1",         "1...2", "1 2",   "1;2", "0..99999999",
                                        "0..9999999", "0..5x", "0..5x0"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        check_refused(frames_parse(&frames, wrong[i]), "");
    }
}

TEST(names) {
    static const struct {
        const char *name, *expected;
    } cases[] = {{"out.####.exr", "out.0042.exr"},
                 {"a#/b##.png", "a#/b42.png"},
                 {"#.png", "42.png"},
                 {"still.png", "still.png"},
                 {"a@b/%04d.png", "a@b/0042.png"},
                 {"a.%4d.png", "a.0042.png"},
                 {"a.%d.png", "a.42.png"},
                 {"a.$F4.exr", "a.0042.exr"},
                 {"$F_a.$F.exr", "$F_a.42.exr"},
                 {"a.${F3}x.exr", "a.042x.exr"},
                 {"@@@@.png", "0042.png"},
                 {"%s%x$FF%.4d.png", "%s%x$FF%.4d.png"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *name = frame_name(cases[i].name, 42);
        assert_string_equal(name, cases[i].expected);
        free(name);
    }
}

TEST(rates) {
    static const struct {
        const char *text, *rate;
        double fps;
    } cases[] = {{"25", "25", 25},
                 {"24000/1001", "24000/1001", 24 / 1.001},
                 {"23.976", "24000/1001", 24 / 1.001},
                 {"29.97", "30000/1001", 30 / 1.001},
                 {"59.94", "60000/1001", 60 / 1.001},
                 {"2.997", "2.997", 2.997}};
    static const char *const wrong[] = {"", "0", "1/0", "-1/-1", "25x", "25/1x", "nan", "1e7"};
    struct frame_rate rate;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        check_ok(cases[i].text, frame_rate_parse(&rate, cases[i].text));
        assert_string_equal(rate.text, cases[i].rate);
        check_near("fps", rate.fps, cases[i].fps, 1e-9);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        check_refused(frame_rate_parse(&rate, wrong[i]), "neither a number");
}

/* --- the program ------------------------------------------------------------------------------ */

static int render(const char *more) {
    return run_line(form("%% render %s --size 24x16 --set vpls=64 --set map-size=32 "
                         "--set rsm-size=64 --set shadow-size=128 %s",
                         scene_path, more));
}

/* The program's pictures of some frames as scratch files PREFIX.N.exr; true where GL is there. */
static bool render_frames(const char *prefix, const char *frames) {
    const char *name = form("%s.##.exr", prefix);
    const char *more = form("--frames %s --fps 2 -o %s", frames, scratch(name));
    if (render(more) == 0)
        return true;
    printf("    %s\n", output);
    return false;
}

static size_t read_frame(const char *prefix, int frame, char *bytes, size_t size) {
    const char *name = form("%s.%02d.exr", prefix, frame);
    FILE *file = fopen(scratch(name), "rb");
    assert_non_null(file);
    size_t got = fread(bytes, 1, size, file);
    assert_true(got > 1000 && got < size);
    fclose(file);
    return got;
}

/* One run forwards, against two runs that begin elsewhere and go backwards. */
TEST(split) {
    static char bytes[2][65536];
    if (!render_frames("whole", "0..5"))
        skip();
    assert_true(render_frames("split", "5,4,3"));
    assert_true(render_frames("split", "2,0,1"));
    for (int frame = 0; frame < 6; frame++) {
        size_t size = read_frame("whole", frame, bytes[0], sizeof bytes[0]);
        assert_int_equal(read_frame("split", frame, bytes[1], sizeof bytes[1]), size);
        if (memcmp(bytes[0], bytes[1], size) != 0)
            fail_msg("frame %d: the files differ", frame);
    }
    read_frame("whole", 0, bytes[0], sizeof bytes[0]);
    read_frame("whole", 5, bytes[1], sizeof bytes[1]);
    assert_true(memcmp(bytes[0], bytes[1], 4096) != 0);
}

/* The size of a file, -1 where there is none. */
static long size_of(const char *path) {
    struct stat found;
    return stat(path, &found) == 0 ? (long)found.st_size : -1;
}

/* A frame that is there and whole is left alone; one that is cut, or of another size, is not. */
TEST(resume) {
    const char *more = form("--frames 0..2 --skip-existing -o %s", scratch("resumed.#.png"));
    for (int frame = 0; frame < 3; frame++) {
        const char *name = form("resumed.%d.png", frame);
        remove(scratch(name));
    }
    unsigned char grey[24 * 16 * 4];
    memset(grey, 128, sizeof grey);
    check_ok("another picture",
             bitmap_write(&(struct bitmap){24, 16, grey}, scratch("resumed.1.png")));
    check_ok("another size",
             bitmap_write(&(struct bitmap){16, 24, grey}, scratch("resumed.0.png")));
    long kept = size_of(scratch("resumed.1.png"));
    if (render(more) != 0)
        skip();
    printf("    %s", output);
    expect_text("2 frames in");
    expect_text("resumed.0.png is 16x24, not 24x16; it is rendered again");
    assert_int_equal(size_of(scratch("resumed.1.png")), kept);
    long whole = size_of(scratch("resumed.2.png"));
    assert_true(whole > 100);
    assert_int_equal(truncate(scratch("resumed.2.png"), whole - 1), 0);
    assert_int_equal(render(more), 0);
    printf("    %s", output);
    expect_text("resumed.2.png: ends too soon; it is rendered again");
    expect_text("1 frames in");
    assert_int_equal(size_of(scratch("resumed.2.png")), whole);
    assert_int_equal(size_of(scratch("resumed.1.png")), kept);
}

TEST(misuse) {
    static const char *const wrong[][2] = {
        {"-o 'a.{frame}.png' --frames 4",
         "a.{frame}.png: its form of a frame's number is not known; #### and %04d are"},
        {"-o 'a.%.4d.png' --frames 4",
         "a.%.4d.png: its form of a frame's number is not known; #### and %04d are"},
        {"-o a.png --frames 0..4", "a.png: 5 frames need #### or %04d in the file's name"},
        {"-o a.##.png", "'##' stands for the number of a frame, and there is no --frames"},
        {"-o a.##.png --frames 4..1", "frames: '4..1' is not like 0..249, 0..100x5 or 1,5,9"},
        {"-o a.png --fps 0", "fps"},
        {NULL},
    };
    expect_refusals(2, "render scenes/metaballs.glb", wrong);
    expect(1, "% render scenes/metaballs.glb -o a.png --clip walk");
    expect_text("no clip 'walk' (there is: none)");
}

/* --- the renderer ----------------------------------------------------------------------------- */

static void pose(struct stage *stage, struct renderer *renderer, double time) {
    check_ok("pose", stage_pose(stage, time));
    check_ok("update", stage_show(stage, renderer));
    renderer_render(renderer);
}

/* A frame after others, whose metaballs outgrew their room, equals the one of a fresh renderer. */
static bool same_files(const char *a, const char *b) {
    const char *line = form("cmp @/%s @/%s", a, b);
    return run_line(line) == 0;
}

/* Views of a file are pictures of their own; what is wrong with a line is told before any. */
TEST_WITH(views, open_group_context, close_group_context) {
    static const struct {
        const char *lines, *more, *error;
        int status;
    } wrong[] = {
        {"0\n0 fov=9\n", "", "views.txt: line 2: camera: fov: 9", 1},
        {"#\n\ntime=x 0\n", "", "views.txt: line 3: 'time=x 0' wants seconds", 1},
        {"# none\n", "", "views.txt: it has no view", 1},
        {"0\n", "--camera 0", "--camera is for pictures without --cameras", 2},
        {"0\n", "--frames 1", "there is no view 1 in", 2},
    };
    write_text(scratch("views.txt"),
               "# two\n0 eye=0,1,4 forward=0,0,-1\r\n\n  time=2.3 0 shift=.2,0\n");
    expect(0, "% render scenes/character.glb --size 24x16 -q -o @/v.#.exr --cameras @/views.txt");
    expect(0, "% render scenes/character.glb --size 24x16 -q -o @/0.exr "
              "--camera '0 eye=0,1,4 forward=0,0,-1'");
    expect(0, "% render scenes/character.glb --size 24x16 -q -o @/1.exr --time 2.3 "
              "--camera '0 shift=.2,0'");
    assert_true(same_files("v.0.exr", "0.exr") && same_files("v.1.exr", "1.exr"));
    assert_false(same_files("0.exr", "1.exr"));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        write_text(scratch("views.txt"), wrong[i].lines);
        const char *line =
            form("%% render scenes/door.glb -o @/w.#.exr --cameras @/views.txt %s", wrong[i].more);
        expect(wrong[i].status, line);
        expect_text(wrong[i].error);
    }
    assert_true(access(scratch("w.0.exr"), F_OK) != 0);
}

TEST_WITH(any_start, open_group_context, close_group_context) {
    struct renderer renderer;
    struct image image[2];
    OWNED(stage) stage = open_stage(scene_path);
    float cell = stage.scene.metaballs[0].cell;
    stage.scene.metaballs[0].cell = .5f;
    pose_stage(&stage);
    struct renderer_desc desc = desc_of(&stage, "clustered", small, 32, 32);
    open_renderer(&renderer, desc);
    stage.scene.metaballs[0].cell = cell;
    for (double time = 2.5; time < 20; time += 2.5)
        pose(&stage, &renderer, time);
    assert_true(stage.geometry.laid_out > 1);
    pose(&stage, &renderer, 6);
    check_ok("layers", renderer_read_layers(&renderer, &image[0]));
    renderer_free(&renderer);
    pose_stage(&stage);
    desc.emitters = stage.emitters; /* those before are gone */
    open_renderer(&renderer, desc);
    pose(&stage, &renderer, 6);
    check_ok("layers", renderer_read_layers(&renderer, &image[1]));
    renderer_free(&renderer);
    assert_true(same_pixels(&image[0], &image[1]));
    images_free(&image[0], &image[1]);
}

/* After one period of the metaballs all room has been made: nothing grows any more. */
TEST_WITH(memory, open_group_context, close_group_context) {
    OWNED(stage) stage = open_stage(scene_path);
    OWNED(renderer) renderer;
    open_renderer(&renderer, desc_of(&stage, "clustered", small, 16, 16));
    size_t bytes = 0;
    int objects = 0;
    for (int frame = 0; frame < 250; frame++) {
        pose(&stage, &renderer, frame * .16);
        if (frame == 125) {
            bytes = gpu_memory_total();
            objects = gpu_memory_object_count();
        }
        if (frame > 125)
            assert_int_equal(gpu_memory_total(), bytes);
    }
    assert_int_equal(gpu_memory_object_count(), objects);
    printf("    %zu bytes in %d objects\n", bytes, objects);
}

/* VALs in use while a spot walks from the wall to the ceiling [Dong 2009, Fig. 8]. */
static int least_vals(const char *start) {
    OWNED(stage) stage;
    OWNED(renderer) renderer;
    const char *settings = form("%s vpls=256 vals=13 iterations=5 start=%s", small, start);
    stage = open_stage("scenes/moving-spot.glb");
    open_renderer(&renderer, desc_of(&stage, "clustered", settings, 16, 16));
    int least = 13;
    for (int frame = 0; frame < 40; frame++) {
        pose(&stage, &renderer, frame * .25);
        struct vpl *vpls = read_vpls(&renderer);
        bool used[13] = {false};
        int count = 0;
        for (int i = 0; i < 256; i++) {
            bool *val = &used[(int)vpls[i].val];
            count += vpls[i].reach > 0 && !*val;
            *val |= vpls[i].reach > 0;
        }
        least = count < least ? count : least;
        free(vpls);
    }
    printf("    start=%s: at least %d of 13 VALs in use\n", start, least);
    return least;
}

TEST_WITH(starts, open_group_context, close_group_context) {
    assert_true(least_vals("seeds") >= 12);
    assert_true(least_vals("reseed") >= 12);
    assert_true(least_vals("warm") <= 6);
}

RUN_TESTS(NULL, NULL)
