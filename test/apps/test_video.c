/* Videos of render: frames, size, rate and pictures as ffmpeg decodes them; and what is there when
 * ffmpeg is missing or fails. */
#include "command_support.h"

#define CLIP "% render scenes/moving-spot.glb --quality draft -q "

/* Entries of the video's stream as ffprobe prints them. */
static void check_stream(const char *video, const char *entries, const char *expected) {
    expect(0, form("ffprobe -v error -count_frames -show_entries stream=%s -of csv=p=0 @/%s",
                   entries, video));
    output[strcspn(output, "\n")] = '\0';
    assert_string_equal(output, expected);
}

static double psnr(const char *a, const char *b) {
    double value = NAN;
    expect(0, form("%% compare @/%s @/%s -m psnr -q", a, b));
    assert_int_equal(sscanf(output, "psnr %lf", &value), 1);
    return value;
}

/* What half the colours cost alone: the picture as 4:2:0 of 8 bits and back, without an encoder. */
static void halve_colours(int frame) {
    expect(0, form("ffmpeg -v error -y -i @/frame.%d.png -vf "
                   "scale=out_color_matrix=bt709:out_range=limited,"
                   "format=yuv420p -f rawvideo @/raw && ffmpeg -v error -y -f rawvideo -pix_fmt "
                   "yuv420p -s "
                   "99x75 -i @/raw -vf scale=in_color_matrix=bt709:in_range=limited,format=rgb24 "
                   "@/halved.%d.png",
                   frame, frame));
}

static void check_picture(int frame, int other) {
    const char *name = form("frame.%d.png", frame);
    const char *others = form("frame.%d.png", other);
    const char *decoded = form("decoded.%d.png", frame);
    const char *wrong = form("wrong.%d.png", frame);
    const char *halved = form("halved.%d.png", frame);
    halve_colours(frame);
    double own = psnr(decoded, name);
    /* The encoder adds at most as much error as half the colours: twice the power is 3.01 dB. */
    check_at_most("loss to half the colours, dB", psnr(halved, name) - own, 3.01);
    check_at_most("psnr by another matrix of colours, dB", psnr(wrong, name), own - 1);
    check_at_most("psnr to the other frame, dB", psnr(decoded, others), own - 10);
}

/* Sides are odd: the last column and row come twice. No float has the rate. */
TEST(frames) {
    need_command("command -v ffprobe");
    expect(0, CLIP "--size 99x75 --frames 0..4 -o @/clip.mp4 -o @/frame.#.png --fps 2.997");
    assert_string_equal(output, "");
    check_stream("clip.mp4", "width,height,pix_fmt,r_frame_rate,nb_read_frames",
                 "100,76,yuv420p,2997/1000,5");
    check_stream("clip.mp4", "color_range,color_space,color_transfer", "tv,bt709,iec61966-2-1");
    expect(0, "ffmpeg -v error -y -i @/clip.mp4 -vf format=rgb24,crop=99:75:0:0 -start_number 0 "
              "@/decoded.%d.png");
    expect(0, "ffmpeg -v error -y -i @/clip.mp4 -vf scale=in_color_matrix=bt601,format=rgb24,"
              "crop=99:75:0:0 -start_number 0 @/wrong.%d.png");
    check_picture(0, 4);
    check_picture(4, 0);
}

/* ffmpeg by itself would end with status 0. The old video stays. */
TEST(full_disk) {
    static const char *const names[] = {"full.mp4", "full.mkv", "full.webm", "full.mov"};
    need_command("command -v ffmpeg");
    for (size_t i = 0; i < 4; i++) {
        if (!is_tried_here(i, 4))
            continue;
        expect(0, form("rm -f @/full.* && echo old >@/%s", names[i]));
        expect(1, form("(ulimit -f 1; %s--size 64x64 --frames 0..2 -o @/%s)", CLIP, names[i]));
        expect_text("ffmpeg failed with exit status 1");
        expect(0, form("cat @/%s", names[i]));
        assert_string_equal(output, "old\n");
    }
}

TEST(containers) {
    static const char *const names[] = {"a.mkv", "a.webm", "a.MOV"};
    need_command("command -v ffprobe");
    for (size_t i = 0; i < 3; i++) {
        if (!is_tried_here(i, 3))
            continue;
        expect(0, form("%s--size 32x32 --frames 0..2 -o @/%s", CLIP, names[i]));
        check_stream(names[i], "width,height,nb_read_frames", "32,32,3");
    }
}

TEST(refusals) {
    static const struct {
        const char *arguments, *message;
    } rows[] = {
        {"-o @/a.mp4", "a video needs --frames"},
        {"-o @/a.####.mp4 --frames 0..2", "a video has all frames"},
        {"-o @/a.mp4 --frames 0..2 --skip-existing", "--skip-existing leaves some out"},
        {"-o @/a.mp4 --frames 0..2 --background none", "cannot be transparent"},
        {"-o @/a.mp4 --frames 0..2 --aov val", "--aov is for formats that hold all layers"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        expect(2, form("%s%s", CLIP, rows[i].arguments));
        expect_text(rows[i].message);
        assert_int_equal(count_text(output, "\n"), 1);
    }
    expect(1, CLIP "-o @/none/a.mp4 --frames 0..2");
    expect_text("none/a.mp4");
    expect(0, "test ! -e @/a.mp4");
}

/* Nothing is rendered: the pictures beside the video are missing, too. */
TEST(missing) {
    expect(0, "rm -rf @/empty && mkdir @/empty");
    expect(1, "PATH=@/empty " CLIP "--size 32x32 --frames 0..2 -o @/empty/a.mp4 "
              "-o @/empty/f.#.png");
    expect_text("videos need ffmpeg, which is not installed");
    assert_int_equal(count_files(scratch("empty")), 0);
}

/* An ffmpeg that ends so: the old video stays, and nothing lies beside it. */
static void check_failing(const char *script, const char *message) {
    expect(0, form("rm -rf @/fails && mkdir -p @/fails/bin && cd @/fails && echo old >a.mp4 && "
                   "printf '#!/bin/sh\\n%s\\n' >bin/ffmpeg && chmod +x bin/ffmpeg",
                   script));
    expect(1, "PATH=@/fails/bin:$PATH " CLIP "--size 128x128 --frames 0..3 -o @/fails/a.mp4");
    expect_text(message);
    assert_int_equal(count_text(output, "manylight render"), 1);
    expect(0, "cat @/fails/a.mp4");
    assert_string_equal(output, "old\n");
    assert_int_equal(count_files(scratch("fails")), 2);
}

TEST(failing) {
    check_failing("kill -9 $$", "a.mp4: ffmpeg was ended by signal 9 (Killed)");
    check_failing("head -c 99999 >/dev/null; kill -9 $$", "ended by signal 9");
    check_failing("exit 0", "a.mp4: ffmpeg ended before the last frame");
    check_failing("cat >/dev/null; echo half >/proc/self/fd/3; exit 3",
                  "a.mp4: ffmpeg failed with exit status 3");
}

/* A signal to the program and to its encoder, as Ctrl-C sends it, ends the work after a frame:
 * there is no video. The first picture tells that the work has begun. */
TEST(interrupted) {
    need_command("command -v ffmpeg");
    expect(0, "rm -rf @/stopped @/begun.* && mkdir @/stopped");
    expect(143, "timeout --preserve-status 60 " CLIP "--size 32x32 --frames 0..9999 "
                "-o @/stopped/a.mp4 -o @/begun.####.png & until test -e @/begun.0000.png; do "
                "sleep .1; done; kill $!; wait $!");
    expect_text("stopped before frame");
    expect_text("are left; there is no video");
    assert_int_equal(count_files(scratch("stopped")), 0);
}

RUN_TESTS(NULL, NULL)
