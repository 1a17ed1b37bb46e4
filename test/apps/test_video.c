/* Videos of render: frames, size, rate and pictures as ffmpeg decodes them; and what is there when ffmpeg is missing or
 * fails. */
#include "command_support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CLIP "% render scenes/moving-spot.glb --quality draft -q "

/* Entries of the video's stream as ffprobe prints them. */
static void check_stream(const char *video, const char *entries, const char *expected) {
    char line[512];
    snprintf(line, sizeof line,
             "ffprobe -v error -count_frames -show_entries stream=%s -of csv=p=0 @/%s", entries,
             video);
    expect(0, line);
    output[strcspn(output, "\n")] = '\0';
    assert_string_equal(output, expected);
}

static double psnr(const char *a, const char *b) {
    double value = NAN;
    char line[256];
    snprintf(line, sizeof line, "%% compare @/%s @/%s -m psnr -q", a, b);
    expect(0, line);
    assert_int_equal(sscanf(output, "psnr %lf", &value), 1);
    return value;
}

/* Sides are odd: the last column and row come twice. */
static void test_frames(void **state) {
    (void)state;
    need_command("command -v ffprobe");
    expect(0, CLIP "--size 99x75 --frames 0..20 -o @/clip.mp4 -o @/frame.##.png --fps 12.5");
    assert_string_equal(output, "");
    check_stream("clip.mp4", "width,height,pix_fmt,r_frame_rate,nb_read_frames",
                 "100,76,yuv420p,25/2,21");
    check_stream("clip.mp4", "color_range,color_space,color_transfer", "tv,bt709,iec61966-2-1");
    expect(0, "ffmpeg -v error -y -i @/clip.mp4 -vf format=rgb24,crop=99:75:0:0 -start_number 0 "
              "@/decoded.%02d.png");
    double first = psnr("decoded.00.png", "frame.00.png"),
           last = psnr("decoded.20.png", "frame.20.png"),
           across = psnr("decoded.00.png", "frame.20.png");
    /* Measured: 34.1, 32.5 and 15.2 dB. Half the colours alone give 35.7 dB. The first frame, read by another matrix of
     * colours, has 32.4 dB. */
    check_at_most("error of the first frame, -dB", -first, -33);
    check_at_most("error of the last frame, -dB", -last, -31);
    check_at_most("psnr of the first to the last, dB", across, first - 10);
}

static void test_containers(void **state) {
    (void)state;
    static const char *const names[] = {"a.mkv", "a.webm", "a.MOV"};
    need_command("command -v ffprobe");
    for (size_t i = 0; i < 3; i++) {
        char line[256];
        if (!is_tried_here(i, 3))
            continue;
        snprintf(line, sizeof line, "%s--size 32x32 --frames 0..2 -o @/%s", CLIP, names[i]);
        expect(0, line);
        check_stream(names[i], "width,height,nb_read_frames", "32,32,3");
    }
}

static void test_refusals(void **state) {
    (void)state;
    static const struct {
        const char *arguments, *message;
    } rows[] = {
        {"-o @/a.mp4", "a video needs --frames"},
        {"-o @/a.####.mp4 --frames 0..2", "a video has all frames"},
        {"-o @/a.mp4 --frames 0..2 --skip-existing", "--skip-existing leaves some out"},
        {"-o @/a.mp4 --frames 0..2 --background none", "cannot be transparent"},
        {"-o @/a.mp4 --frames 0..2 --aov val", "no output that holds layers"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char line[256];
        snprintf(line, sizeof line, "%s%s", CLIP, rows[i].arguments);
        expect(2, line);
        expect_text(rows[i].message);
        assert_int_equal(count_text(output, "\n"), 1);
    }
    expect(1, CLIP "-o @/none/a.mp4 --frames 0..2");
    expect_text("none/a.mp4");
    expect(0, "test ! -e @/a.mp4");
}

/* Nothing is rendered: the pictures beside the video are missing, too. */
static void test_missing(void **state) {
    (void)state;
    expect(0, "rm -rf @/empty && mkdir @/empty");
    expect(1, "PATH=@/empty " CLIP "--size 32x32 --frames 0..2 -o @/empty/a.mp4 "
              "-o @/empty/f.#.png");
    expect_text("videos need ffmpeg, which is not installed");
    assert_int_equal(count_files(scratch("empty")), 0);
}

/* An ffmpeg that ends so: the old video stays, and nothing lies beside it. */
static void check_failing(const char *script, const char *message) {
    char line[512];
    snprintf(line, sizeof line,
             "rm -rf @/fails && mkdir -p @/fails/bin && cd @/fails && echo old >a.mp4 && "
             "printf '#!/bin/sh\\n%s\\n' >bin/ffmpeg && chmod +x bin/ffmpeg",
             script);
    expect(0, line);
    expect(1, "PATH=@/fails/bin:$PATH " CLIP "--size 128x128 --frames 0..3 -o @/fails/a.mp4");
    expect_text(message);
    assert_int_equal(count_text(output, "manylight render"), 1);
    expect(0, "cat @/fails/a.mp4");
    assert_string_equal(output, "old\n");
    assert_int_equal(count_files(scratch("fails")), 2);
}

static void test_failing(void **state) {
    (void)state;
    check_failing("kill -9 $$", "a.mp4: ffmpeg was ended by signal 9 (Killed)");
    check_failing("head -c 99999 >/dev/null; kill -9 $$", "ended by signal 9");
    check_failing("cat >/dev/null; echo half >/proc/self/fd/3; exit 3",
                  "a.mp4: ffmpeg failed with exit status 3");
}

/* Ctrl-C reaches the program and ends it after its frame: there is no video, and no encoder goes on. */
static void test_interrupted(void **state) {
    (void)state;
    need_command("command -v ffmpeg");
    expect(0, "rm -rf @/stopped && mkdir @/stopped");
    expect(130, "timeout --preserve-status -s INT 5 " CLIP
                "--size 64x64 --frames 0..9999 -o @/stopped/a.mp4");
    expect_text("stopped before frame");
    assert_int_equal(count_text(output, "\n"), 1);
    assert_int_equal(count_files(scratch("stopped")), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_frames),   cmocka_unit_test(test_containers),
        cmocka_unit_test(test_refusals), cmocka_unit_test(test_missing),
        cmocka_unit_test(test_failing),  cmocka_unit_test(test_interrupted),
    };
    return cmocka_run_group_tests_name("video", tests, NULL, NULL);
}
