/* What the programs say, and leave, when a disk or stdout takes no more: exit 1, one message, no
 * file that is not whole. */
#include "command_support.h"

/* Small enough for a frame in no time. */
#define QUICK                                                                                      \
    "--size 24x16 --set vpls=64 --set vals=4 --set map-size=32 --set rsm-size=64 "                 \
    "--set shadow-size=128 "
#define BOX "scenes/cornell-box.glb "

static void make_folder(void) {
    expect(0, "rm -rf @/full-disk && mkdir @/full-disk");
}

/* Two pictures to compare. */
static void write_pictures(void) {
    OWNED(image) image;
    image_init(&image, 64, 64, "R G B");
    for (int i = 0; i < 2; i++) {
        check_ok("picture", image_write(&image, scratch(i ? "b.exr" : "a.exr")));
        for (int k = 0; k < 64 * 64 * 3; k++)
            image.pixels[k] = (float)(k * 7919 % 101) / 100;
    }
}

/* Runs `BINARY ARGUMENTS` behind a shell's preamble. */
static int run(const char *before, const char *arguments, const char *after) {
    return run_line(form("%s %% %s %s", before, arguments, after));
}

/* One line says so, beside notes and warnings. */
static void expect_message(const char *what, const char *reason) {
    int count = 0;
    for (char *line = strtok(output, "\n"); line; line = strtok(NULL, "\n")) {
        if (strstr(line, "manylight: note: ") || strstr(line, "manylight: warning: "))
            continue;
        count++;
        assert_non_null(strstr(line, what));
        assert_non_null(strstr(line, reason));
    }
    assert_int_equal(count, 1);
}

TEST(stdout) {
    static const char *const cases[] = {
        "--help",
        "--version",
        "render --help",
        "info " BOX,
        "info --gl",
        "compare @/a.exr @/b.exr",
        "compare @/a.exr @/b.exr --json",
        "render " BOX QUICK "-o @/full-disk/stats.png --stats",
        "bench times " BOX "--size 24x16 --frames 1",
        "bench budget " BOX "--size 24x16 --set vpls=64 --noise 1 --cache @/cache",
    };
    write_pictures();
    make_folder();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (run("", cases[i], ">/dev/null") != 0)
            continue; /* no OpenGL here */
        assert_int_equal(run("", cases[i], ">/dev/full"), 1);
        expect_message("cannot write standard output", "No space left on device");
        assert_int_equal(run("", cases[i], ">&-"), 1);
        expect_message("cannot write standard output", "Bad file descriptor");
    }
}

/* A picture does not get the number of a stream that is closed, nor need one. */
TEST(closed_streams) {
    make_folder();
    write_pictures();
    const char *arguments = "render " BOX QUICK "-o @/full-disk/closed.exr --quiet";
    if (run("", arguments, ">/dev/null") != 0)
        skip();
    assert_int_equal(run("", arguments, "<&- >&- 2>&-"), 0);
    check_ok("whole", image_is_whole(scratch("full-disk/closed.exr")));
}

/* Programs that write files. */
static const char *const writers[] = {
    "compare @/a.exr @/b.exr -o @/full-disk/heat.png",
    "compare @/a.exr @/b.exr -o @/full-disk/heat.jpg",
    "compare @/a.exr @/b.exr -o @/full-disk/heat.exr",
    "render " BOX QUICK "-o @/full-disk/a.png",
    "render " BOX QUICK "-o @/full-disk/a.jpg",
    "render " BOX QUICK "-o @/full-disk/a.exr",
    "render " BOX QUICK "-o @/full-disk/a.##.tga --frames 0..3",
    "reference " BOX "--size 24x16 --spp 4 -o @/full-disk/reference.exr",
    "bench times " BOX "--size 24x16 --frames 1 --csv @/full-disk/times.csv",
    "bench budget " BOX "--size 24x16 --set vpls=64 --noise 1 --csv @/full-disk/budget.csv "
    "--cache @/cache",
    "bench sweep " BOX "--size 24x16 --reference path --noise 1 --frames 1 --cache @/full-disk",
    "bench temporal scenes/moving-spot.glb --size 16x16 --frames 2 --set vpls=64 "
    "--set map-size=32 --variant instant-radiosity --csv @/full-disk/temporal.csv",
    "bench failures room --size 16x16 --noise 1 --cache @/cache "
    "--csv @/full-disk/failures.csv",
    "bench failures room --size 16x16 --noise 1 --cache @/cache -o @/full-disk",
};

TEST(writers) {
    write_pictures();
    make_folder();
    for (size_t i = 0; i < sizeof writers / sizeof *writers; i++) {
        if (!knows_format("jpg") && (strstr(writers[i], ".jpg") || strstr(writers[i], ".tga")))
            continue;
        make_folder();
        int status = run("", writers[i], ">/dev/null");
        if (strstr(output, "no context"))
            continue;
        assert_true(status == 0 || strstr(output, "not what is promised"));
        assert_true(count_files(scratch("full-disk")) > 0);
        make_folder();
        assert_int_equal(run("ulimit -f 0;", writers[i], ">/dev/null"), 1);
        expect_message("cannot write ", ": File too large");
        assert_int_equal(count_files(scratch("full-disk")), 0);
    }
}

/* Every format onto a disk of four pages that another file has filled. */
static void check_real_disk(const char *before) {
    static const char *const formats[] = {"exr", "tif", "pfm", "hdr", "png", "jpg", "webp",
                                          "bmp", "tga", "gif", "jp2", "ppm", "dpx"};
    char known[128] = "";
    int count = 0;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (knows_format(formats[i])) {
            strcat(strcat(known, " "), formats[i]);
            count++;
        }
    expect(0, form("unshare -rm sh -c 'mount -t tmpfs -o size=16k none @/full-disk || exit 1; "
                   "head -c 1M /dev/zero >@/full-disk/other; %s for e in %s; do "
                   "%% compare @/a.exr @/b.exr -o @/full-disk/heat.$e >/dev/null; echo $?; done; "
                   "ls -A @/full-disk'",
                   before, known));
    assert_int_equal(count_text(output, ": No space left on device\n1\n"), count);
    assert_null(strstr(output, "\n0\n"));
    expect_text("\n1\nother\n");
}

/* Without /proc a file must have a name from the start, as on file systems that know no other. */
TEST(real_disk) {
    make_folder();
    write_pictures();
    if (run_line("unshare -rm mount -t tmpfs none @/full-disk") != 0) {
        printf("    skipped: no disk can be mounted here: %s", output);
        skip();
    }
    check_real_disk("");
#ifndef __SANITIZE_ADDRESS__ /* which wants a /proc */
    check_real_disk("mount -t tmpfs none /proc;");
#endif
}

/* The tool that makes our scenes. */
TEST(scenes) {
    make_folder();
    assert_int_not_equal(
        run_line("ulimit -f 0; trap '' XFSZ; exec " BUILD "/scenes/make_scenes @/full-disk"), 0);
    expect(0, "find @/full-disk -type f");
    assert_string_equal(output, "");
}

RUN_TESTS(NULL, NULL)
