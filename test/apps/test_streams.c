/* Standard input, standard output and pipes in place of files, as a shell sees them. */
#define _XOPEN_SOURCE 700
#include "command_support.h"
#include "gltf_parts.h"

#include <sys/stat.h>

#define QUICK                                                                                      \
    "--size 24x16 --set vpls=16,vals=2,map-size=32,rsm-size=32,shadow-size=64,interleave=1"

/* Runs the line in bash, where each part of a pipe must end well. */
static void in_bash(int status, const char *line) {
    expect(status, form("bash -c 'set -o pipefail; %s'", line));
}

/* Whether script can make a terminal. */
static bool has_terminals(void) {
    return run_command("script -qec true /dev/null", output, sizeof output) == 0;
}

/* A glTF of the quad with the buffer in a data URI, or named. */
static void write_gltf(const char *name, const char *uri) {
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    static char buffers[2048], json[16384];
    unsigned char bin[PARTS_BIN + 1] = {0};
    char data[PARTS_BIN * 2];
    size_t used = 0;
    struct gltf_parts parts = {0};
    parts_bin(&parts, bin);
    for (size_t i = 0; i < PARTS_BIN; i += 3) {
        unsigned bits = (unsigned)bin[i] << 16 |
                        (unsigned)(i + 1 < PARTS_BIN ? bin[i + 1] : 0) << 8 |
                        (unsigned)(i + 2 < PARTS_BIN ? bin[i + 2] : 0);
        for (int shift = 18; shift >= 0; shift -= 6)
            data[used++] = letters[bits >> shift & 63];
    }
    if (PARTS_BIN % 3)
        data[used - 1] = '=';
    if (PARTS_BIN % 3 == 1)
        data[used - 2] = '=';
    data[used] = '\0';
    snprintf(buffers, sizeof buffers, "[{\"byteLength\": %d, \"uri\": \"%s%s\"}]", PARTS_BIN,
             uri ? uri : "data:application/octet-stream;base64,", uri ? "" : data);
    parts.buffers = buffers;
    size_t size = parts_json(&parts, json, sizeof json);
    write_bytes(scratch(name), json, size);
}

static int make_files(void **state) {
    (void)state;
    struct gltf_parts quad = {0};
    unsigned char bin[PARTS_BIN];
    write_parts("quad.glb", &quad);
    write_gltf("quad.gltf", NULL);
    write_gltf("names.gltf", "names.bin");
    write_gltf("fifo.gltf", "pipe.bin");
    parts_bin(&quad, bin);
    write_bytes(scratch("names.bin"), bin, PARTS_BIN);
    remove(scratch("pipe.bin"));
    return mkfifo(scratch("pipe.bin"), 0600);
}

/* --- inputs ----------------------------------------------------------------------------------- */

/* Pictures without a difference, though their headers name other scenes. */
#define SAME(a, b)                                                                                 \
    "% compare @/" a ".exr @/" b ".exr -m mae --max mae=0 -q && % compare @/" a ".exr @/" b        \
    ".exr -l indirect -m mae --max mae=0 -q"

/* The same light, however the scene comes. */
TEST(scene_from_pipe) {
    in_bash(0, "% render @/quad.glb -o @/file.exr -q " QUICK);
    in_bash(0, "% render - -o @/in.exr -q " QUICK " < @/quad.glb && " SAME("in", "file"));
    in_bash(0, "cat @/quad.gltf | % render - -o @/gltf.exr -q " QUICK " && " SAME("gltf", "file"));
    in_bash(0, "% render <(cat @/quad.glb) -o @/fifo.exr -q " QUICK " && " SAME("fifo", "file"));
    in_bash(0, "cat @/quad.glb | % render /dev/stdin -o @/dev.exr -q " QUICK
               " && " SAME("dev", "file"));
}

TEST(other_commands_from_pipe) {
    in_bash(0, "cat @/quad.glb | % info -");
    expect_text("scene      -\n");
    expect_text("2 triangles");
    in_bash(0, "% info <(cat @/quad.gltf)");
    expect_text("2 triangles");
    in_bash(0, "% reference @/quad.glb -o @/traced.exr -q --size 8x8 --spp 1");
    in_bash(0, "% reference - -o - --format exr -q --size 8x8 --spp 1 < @/quad.glb > @/piped.exr"
               " && " SAME("piped", "traced"));
}

TEST(pictures_from_pipe) {
    in_bash(0, "% render @/quad.glb -o @/a.exr -o @/a.png -q --passes 1 " QUICK);
    in_bash(0, "% compare - @/a.exr -m rmse --max rmse=0 < @/a.exr");
    in_bash(0, "% compare @/a.exr - -m rmse --max rmse=0 < @/a.exr");
    in_bash(0, "% compare <(cat @/a.png) @/a.png -m rmse --max rmse=0");
    in_bash(0, "% compare <(cat @/a.exr) <(cat @/a.exr) -m rmse --max rmse=0");
    in_bash(0, "cat @/a.exr | % average - -o - --format exr > @/mean.exr && "
               "% compare @/mean.exr @/a.exr -m rmse --max rmse=1e-6");
    in_bash(2, "% compare - - < @/a.exr");
    expect_text("-: standard input can be only one of the pictures");
    in_bash(2, "% average - - -o @/mean.exr < @/a.exr");
}

TEST(pipes_refused) {
    in_bash(1, "% info - < /dev/null");
    expect_text("manylight info: -: the file is empty");
    in_bash(1, "% info - <&-");
    expect_text("manylight info: cannot read -: ");
    in_bash(1, "head -c 100 @/quad.glb | % info -");
    expect_text("manylight info: -: truncated");
    in_bash(1, "echo x | % compare - @/quad.glb");
    expect_text("manylight compare: -: ");
    if (has_terminals()) {
        in_bash(1, "script -qec \"% info -\" /dev/null");
        expect_text("standard input is a terminal");
    }
#ifndef __SANITIZE_ADDRESS__ /* which reserves more */
    in_bash(1, "ulimit -d 300000; head -c 1G /dev/zero 2>/dev/null | % info -");
    expect_text("manylight info: cannot read -: it has more than ");
#endif
}

/* A scene from a pipe reads no files of the working folder, and no scene reads standard input or a
 * pipe. */
TEST(names_inside_scenes) {
    in_bash(0, "% info @/names.gltf");
    in_bash(1, "cd @ && cat names.gltf | % info -");
    expect_text("buffer 0: cannot find 'names.bin': the scene came through a pipe");
    in_bash(1, "cd @ && % info <(cat names.gltf)");
    expect_text("the scene came through a pipe");
    in_bash(1, "% info @/fifo.gltf");
    expect_text("not a file");
    write_gltf("dash.gltf", "-");
    in_bash(1, "cd @ && % info dash.gltf < quad.glb");
    expect_text("buffer 0: cannot open -: No such file");
}

/* --- outputs ---------------------------------------------------------------------------------- */

TEST(picture_to_stdout) {
    in_bash(0, "% render @/quad.glb -o @/one.png -o @/one.exr -q " QUICK);
    static const char *const formats[] = {"png", "exr", "webp"};
    if (knows_format("webp"))
        in_bash(0, "% render @/quad.glb -o @/one.webp -q " QUICK);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (!knows_format(formats[i]))
            continue;
        const char *line = form("%% render @/quad.glb -o - --format %s --stats " QUICK
                                " 2>@/said | cmp - @/one.%s",
                                formats[i], formats[i]);
        in_bash(0, line);
        in_bash(0, "grep -c \"time per pass\" @/said");
    }
    in_bash(0, "% render @/quad.glb -o >(cat > @/sub.png) --format png -q " QUICK
               " && sleep .2 && cmp @/sub.png @/one.png");
    /* A named file keeps its extension's format. */
    in_bash(0, "% render @/quad.glb -o @/both.png -o - --format exr -q " QUICK
               " | cmp - @/one.exr && cmp @/both.png @/one.png");
    in_bash(0, "% render @/quad.glb -o @/odd.name --format png -q " QUICK
               " && cmp @/odd.name @/one.png");
}

TEST(table_leaves_stdout) {
    in_bash(0, "% render @/quad.glb -o @/a.exr -q " QUICK);
    in_bash(0, "% compare @/a.exr @/a.exr -m rmse -o @/heat.png");
    in_bash(0, "% compare @/a.exr @/a.exr -m rmse -o - --format png 2>@/said | cmp - @/heat.png");
    in_bash(0, "grep -c ^rmse @/said");
    in_bash(0, "% compare @/a.exr @/a.exr -m rmse --json -o - --format png 2>@/said >/dev/null");
    in_bash(0, "grep -c \"\\\"rmse\\\": 0\" @/said");
}

TEST(outputs_refused) {
    static const struct {
        const char *line, *message;
        int status;
    } cases[] = {
        {"% render @/quad.glb -o -", "-: standard output needs --format", 2},
        {"% render @/quad.glb -o - --format gltf", "format: 'gltf' is not one of those known: .exr",
         2},
        {"% render @/quad.glb -o x.png --format exr", "the outputs' extensions tell", 2},
        {"% render @/quad.glb -o - -o - --format exr", "two pictures cannot share", 2},
        {"% render @/quad.glb -o - --format exr --frames 0..3", "standard output takes one picture",
         2},
        {"% render @/quad.glb -o - --format exr --skip-existing", "takes one picture", 2},
        {"% reference @/quad.glb -o - --format png", "-: only EXR files (.exr) hold all layers", 2},
        {"% average @/a.exr -o - --format png", "-: only EXR", 2},
        {"% bench times @/quad.glb --csv -", "standard output has the tables", 1},
        {"% render @/quad.glb -o - --format exr -q " QUICK " >&-",
         "cannot write standard output: ", 1},
        {"% render @/quad.glb -o - --format exr -q " QUICK " >/dev/full",
         "cannot write standard output: No space left on device", 1},
        /* More than a pipe holds, and the reader ends. */
        {"% render @/quad.glb -o - --format pfm -q " QUICK
         " --size 200x200 | head -c 10 >/dev/null",
         "manylight render: frame 0: cannot write standard output: Broken pipe\n", 1},
        {"script -qec \"% render @/quad.glb -o - --format png\" /dev/null", "it is a terminal", 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (strncmp(cases[i].line, "script", 6) == 0 && !has_terminals())
            continue;
        in_bash(cases[i].status, cases[i].line);
        expect_text(cases[i].message);
    }
}

RUN_TESTS(make_files, NULL)
