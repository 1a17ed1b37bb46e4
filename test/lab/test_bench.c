/* manylight bench: its modes, its tables and its files, as a shell sees them. Times are never
 * compared: only that they are there. */
#define _POSIX_C_SOURCE 200809L
#include "command_support.h"

#include "base/file/file.h"

#include <unistd.h>

static void check_runs(const char *arguments) {
    expect_command(0, "bench", arguments);
}

static char *read_text(const char *path) {
    char *text = file_read_text(path);
    check_ok(path, text && *text);
    return text;
}

/* Every row has as many cells as the first; returns the number of rows below it. */
static int check_csv(const char *text) {
    int columns = 0, rows = 0;
    for (const char *at = text; *at;) {
        int cells = 1;
        bool quoted = false;
        for (; *at && (quoted || *at != '\n'); at++) {
            quoted ^= *at == '"';
            cells += *at == ',' && !quoted;
        }
        assert_int_equal(*at++, '\n');
        if (rows++ == 0)
            columns = cells;
        assert_int_equal(cells, columns);
    }
    assert_int_equal(columns, 29);
    return rows - 1;
}

TEST(times) {
    const char *csv = scratch("bench.csv");
    check_runs(
        form("times scenes/cornell-box.glb --size 24x16 --frames 2 --set map-size=32 --set vals=4 "
             "--variant paper --variant fast --variant none:technique=unshadowed --csv %s",
             csv));
    static const char *const parts[] = {
        "Table 1",
        "cornell-box, 36 faces, 24x16",
        "paper: 20.4 fps",
        "  fast  ",
        "Table 2: cornell-box, paper, 24x16",
        "  frame/maps/depth maps ",
        "deferred rendering",
        "VPL generation",
        "VAL clustering",
        "VAL maps",
        "indirect illumination",
        "blur",
        "sum of passes",
        "ns/pixel",
    };
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        expect_text(parts[i]);
    if (strstr(output, "  other "))
        fail_msg("a pass belongs to no step:\n%s", output);
    char *text = read_text(csv);
    assert_true(check_csv(text) > 10);
    expect_in(text, "\ntimes,cornell-box,36,24,16,clustered,fast,,clustered.vals=4 map.size=32,"
                    "frame/maps/depth maps,,ms,");
    expect_in(text, ",unshadowed,none,,clustered.vals=4 map.size=32,clock,,ms,");
    free(text);
}

/* Whole frames alone: the clock and the CPU, and no pass. */
TEST(times_of_whole_frames) {
    const char *csv = scratch("whole.csv");
    check_runs(form("times scenes/cornell-box.glb --size 24x16 --frames 2 --whole-frames "
                    "--set map-size=32 --set vals=4 --variant fast --csv %s",
                    csv));
    expect_text("Table 1");
    assert_null(strstr(output, "Table 2"));
    char *text = read_text(csv);
    assert_int_equal(check_csv(text), 5);
    assert_int_equal(count_text(text, ",clock,,ms,") + count_text(text, ",cpu,,ms,"), 2);
    assert_int_equal(count_text(text, ",frame,") + count_text(text, ",frame/"), 0);
    free(text);
}

/* The first frame has the pixels of render's picture, whatever comes after it. */
TEST(picture_of_times) {
    expect(0, "% render scenes/cornell-box.glb --size 24x16 --technique clustered --set path=traced"
              " -q -o @/rendered.exr");
    expect(0, "% bench times scenes/cornell-box.glb --size 24x16 --variant traced --frames 1"
              " --warm-up 3 --whole-frames --picture @/timed.exr -q");
    /* Their headers differ: that of render tells its making. */
    static const char *const layers[] = {"beauty", "indirect", "direct", "albedo", "normal"};
    for (size_t i = 0; i < sizeof layers / sizeof *layers; i++) {
        expect(0,
               form("%% compare @/timed.exr @/rendered.exr -l %s --max mrse=0 -m mrse", layers[i]));
    }
    expect(1, "% bench times scenes/cornell-box.glb --picture @/none.exr -q");
    expect_text("--picture is of one SCENE and one --variant");
    expect(1, "test -e @/none.exr");
}

/* A frame by some of the lights alone takes no passes of the others. */
LONG_TEST(times_by_light) {
    static const char *const lights[] = {"", " --light 0", " --light sky"};
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        check_runs(form(
            "times scenes/cornell-box.glb --size 24x16 --frames 1 --set map-size=32 --set vals=4 "
            "--set sky.lights=6 --variant fast --environment scenes/overcast.hdr%s",
            lights[i]));
        bool sky = strstr(output, "frame/sky blocks") != NULL;
        printf("    all%s: %s of the sky\n", lights[i], sky ? "passes" : "no pass");
        assert_int_equal(sky, i != 1);
    }
}

/* A sweep measures errors against a reference that the second run finds where the first put it. */
TEST(sweep_and_cache) {
    const char *cache = scratch("bench-cache"), *csv = scratch("sweep.csv");
    const char *arguments =
        form("sweep scenes/cornell-box.glb --size 24x16 --frames 1 --set map-size=32 "
             "--vary M=2,8 --vary visibility=cssm,hard --variant fast --tracer --noise .1 "
             "--cache %s --csv %s",
             cache, csv);
    expect(0, "rm -rf @/bench-cache");
    check_runs(arguments);
    expect_text("making reference");
    expect_text("  fast hard                vals=8 ");
    expect_text("  denoised tracer          spp=16 ");
    expect_text("by rRMSE");
    check_runs(arguments);
    assert_null(strstr(output, "making reference"));
    char *text = read_text(csv);
    check_csv(text);
    expect_in(text, "24,16,,denoised tracer,spp=1,,cpu,,ms,");
    expect_in(text, ",baseline-at-rmse,,x,");
    expect_in(text, ",fast hard,vals=8,clustered.vals=8 clustered.visibility=hard "
                    "map.size=32,relative-rmse,path,%,");
    free(text);
}

/* More voxels err less, at the same distance. */
LONG_TEST(ambient_occlusion) {
    double error[2] = {0};
    const char *csv = scratch("ao.csv");
    check_runs(
        form("sweep scenes/cornell-box.glb --size 40x40 --frames 1 --variant "
             "u:technique=unshadowed,volume.ao-distance=.2 --vary volume.size=16,64 --reference ao "
             "--noise .1 --cache %s --csv %s",
             scratch("ao-cache"), csv));
    char *text = read_text(csv);
    for (int i = 0; i < 2; i++) {
        char *row = strstr(text, i ? "volume.size=64" : "volume.size=16");
        row = row ? strstr(row, ",rmse,ao,1,") : NULL;
        assert_non_null(row);
        error[i] = atof(row + strlen(",rmse,ao,1,"));
        printf("    RMSE %g\n", error[i]);
    }
    assert_true(error[1] > 0 && error[1] < error[0] && error[0] < .3);
    free(text);
}

/* --- charts ----------------------------------------------------------------------------------- */

/* Draws a file of the scratch folder into a folder there; the test is skipped without gnuplot. */
static void draw(const char *csv, const char *folder) {
    if (run_command("gnuplot --version", output, sizeof output) != 0)
        skip();
    const char *from = form("%s", scratch(csv));
    const char *to = form("%s", scratch(folder));
    const char *line =
        form("rm -rf %s && mkdir -p %s && LC_ALL=C.UTF-8 gnuplot -e \"csv='%s'; folder='%s'\" "
             "bench/chart.gp && find %s -type f",
             to, to, from, to, to);
    assert_int_equal(run_command(line, output, sizeof output), 0);
    if (strstr(output, "warning"))
        fail_msg("gnuplot warns:\n%s", output);
}

/* Drawn from the rows that the sweep above has written. */
TEST(chart) {
    const char *svg = scratch("charts/cornell-box.svg"), *png = scratch("charts/cornell-box.png");
    remove(svg);
    remove(png);
    draw("sweep.csv", "charts");
    expect_text("cornell-box.svg");
    char *text = read_text(svg);
    expect_in(text, "faces), 24x16");
    expect_in(text, "Pareto front");
    expect_in(text, "denoised tracer");
    expect_in(text, "M=8");
    free(text);
    text = read_text(png);
    assert_memory_equal(text + 1, "PNG", 3);
    free(text);
}

static FILE *open_rows(const char *name) {
    FILE *file = fopen(scratch(name), "w");
    assert_non_null(file);
    fputs("mode,scene,faces,width,height,variant,point,what,value,frame_ms,gl_renderer\n", file);
    return file;
}

/* Of two scenes of one name each has a chart; rings stand around what is on the front. */
TEST(front) {
    static const double cases[][2] = {
        {1, 9}, {8, 1}, {4, 4}, /* on the front */
        {4, 5}, {9, 9},         /* as fast, less true; neither */
    };
    FILE *file = open_rows("front.csv");
    for (int faces = 30; faces <= 36; faces += 6)
        for (int i = 0; i < 5; i++)
            fprintf(file, "sweep,box,%d,8,8,fast,vals=%d,relative-rmse,%g,%g,x\n", faces, i + 1,
                    cases[i][1], cases[i][0]);
    fclose(file);
    draw("front.csv", "front");
    expect_text("box.svg");
    expect_text("box-36.svg");
    char *text = read_text(scratch("front/box-36.svg"));
    expect_in(text, "box (36 faces)");
    /* gnuplot's sixth mark is the ring's, with which the seventh is made. */
    assert_int_equal(count_text(text, "'#gpPt5' transform"), 3);
    for (int i = 1; i <= 5; i++) {
        const char *label = form("M=%d", i);
        expect_in(text, label);
    }
    free(text);
}

TEST(other_charts) {
    FILE *file = open_rows("others.csv");
    for (int i = 0; i < 4; i++) {
        fprintf(file, "curves,box,30,8,8,a curve's name,vals=%d,relative-rmse,%d,,x\n", 2 << i,
                9 - i);
        fprintf(file, "temporal,box,30,8,8,warm,time=%d,frame-flicker,%d,,x\n", i, i);
        fprintf(file, "temporal,box,30,8,8,warm,time=%d,vals,%d,,x\n", i, 30 - i);
    }
    fprintf(file, "temporal,box,30,8,8,warm,,flicker,2,,x\n");
    fclose(file);
    draw("others.csv", "others");
    static const char *const files[] = {"box-vals.svg", "box-flicker.svg", "box-vals-in-use.svg"};
    for (int i = 0; i < 3; i++)
        expect_text(files[i]);
    char *text = read_text(scratch("others/box-vals.svg"));
    expect_in(text, "a curve's name, RMSE");
    free(text);
}

/* Names of scenes and settings that a shell, a path or gnuplot would take for something else stay
 * names. */
TEST(odd_names) {
    FILE *file = open_rows("odd.csv");
    static const char *const names[] = {"../../escaped", "a b", "a c",  "$(touch x) `touch x`",
                                        "| touch x",     "%s",  "it's", ""};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        fprintf(file, "sweep,%s,30,8,8,fast,vals=4,relative-rmse,2,3,x\n", names[i]);
    for (int i = 1; i < 3; i++)
        fprintf(file, "curves,box,30,8,8,fast,/../../out=%d,relative-rmse,2,,x\n", i);
    fclose(file);
    draw("odd.csv", "odd");
    static const char *const files[] = {
        "/..-..-escaped.svg",  "/a-b.svg", "/a-c.svg",  "/$(touch-x)-`touch-x`.svg",
        "/|-touch-x.svg",      "/%s.svg",  "/it's.svg", "/unnamed.svg",
        "/box--..-..-out.svg",
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        expect_text(files[i]);
    assert_int_equal(count_text(output, ".svg"), (int)(sizeof files / sizeof *files));
    assert_int_equal(access("x", F_OK), -1);
}

/* --- the other modes -------------------------------------------------------------------------- */

/* The number in a column of the row that begins so, in a text; columns count from 0. */
static double number_of(const char *text, const char *row, int column) {
    const char *at = strstr(text, row);
    if (!at)
        fail_msg("'%s' is not in:\n%s", row, text);
    char *end = (char *)at + strlen(row);
    double value = 0;
    for (int i = 0; i <= column; i++)
        value = strtod(end, &end);
    return value;
}

/* The chain from the reference to the frame. Bounds are loose: 48 x 48 pixels, 10 % noise. */
TEST(budget) {
    const char *csv = scratch("budget.csv");
    check_runs(form("budget scenes/cornell-box.glb --size 48x48 --noise .1 --cache %s --csv %s -q",
                    scratch("bench-cache"), csv));
    const char *so_far = strstr(output, "against the reference: ");
    assert_non_null(so_far);
    /* Maps see what rays see: a leak or a shifted map costs tens of percent. */
    check_at_most("hard map per VPL, %", number_of(output, "hard map per VPL", 0), 5);
    check_at_most("soft map per VAL, %", number_of(output, "soft map per VAL", 0), 8);
    /* Interleaving is noise that the blur takes away again. */
    double interleaved = number_of(so_far, "interleaved", 0);
    double blurred = number_of(so_far, "blurred", 0);
    check_at_most("blurred over interleaved", blurred / interleaved, .8);
    check_at_most("antialiased over blurred",
                  number_of(so_far, "antialiased: the frame", 0) / blurred, .8);
    /* The first step alone is the first step so far. */
    check_near("first step", number_of(output, "pixel centres", 0),
               number_of(so_far, "pixel centres", 0), 0);
    char *text = read_text(csv);
    /* Five errors of ten steps alone and so far, and against pixels' centres; and the noise. */
    assert_int_equal(check_csv(text), 10 * 2 * 5 + 5 + 1);
    free(text);
}

/* What is chosen for an error is no slower than all that errs no more, and errs as was estimated.
 * Bounds are loose: 32 x 32 pixels, 10 % noise. */
TEST(quality) {
    const char *csv = scratch("quality.csv");
    check_runs(form("quality scenes/cornell-box.glb --size 32x32 --noise .1 --cache %s --csv %s -q "
                    "--passes %d --set vpls=64,map.size=32,vals=4",
                    scratch("bench-cache"), csv, is_long_run() ? 4 : 1));
    double estimated = number_of(output, "error=30%", 0), error = number_of(output, "error=30%", 1);
    check_near("estimated over measured", estimated / error, 1, .4);
    check_near("of the error asked for", number_of(output, "error=30%", 2), error / 30, .01);
    check_at_most("CPU ms of 30 %", number_of(output, "error=30%", 3),
                  1.5 * number_of(output, "error=2%", 3));
    char *text = read_text(csv);
    check_csv(text);
    free(text);
    expect(0, form("awk -f bench/leave-one-out.awk %s", csv));
    expect_text("| cornell-box | nothing to learn from | (1.0");
}

/* A camera that is nearer changes the estimate as it changes the error. */
LONG_TEST(quality_closer) {
    check_runs(
        form("quality scenes/cornell-box.glb --size 32x32 --noise .1 --cache %s -q --passes 1 "
             "--set vpls=64,map.size=32,vals=4 --estimates --camera \"0 fov=.5\"",
             scratch("bench-cache")));
    double closer =
        number_of(output, "clustered.vals=4 ", 0) / number_of(output, "clustered.vals=4 ", 1);
    check_near("estimated over measured, closer", closer, 1, .2);
    assert_null(strstr(output, "automatic"));
}

/* Soft shadows see of a lamp what the tracer sees, hard ones less; and what is seen of it
 * is drawn. */
TEST(direct) {
    const char *csv = scratch("direct.csv");
    check_runs(form("direct scenes/table.glb --size 64x64 --frames 1 --noise .03 --set texels=256 "
                    "--set shadow-size=512 --variant hard:direct=hard,technique=unshadowed "
                    "--variant msm:direct=msm,technique=unshadowed --variant "
                    "pcss:direct=pcss,technique=unshadowed --cache %s --csv %s -q",
                    scratch("bench-cache"), csv));
    expect_text("share of the lights that is seen: table");
    check_at_most("pcss, %", number_of(output, "  pcss                    ", 2), 5);
    check_at_most("msm, %", number_of(output, "  msm                     ", 2), 7);
    check_at_most("-hard, %", -number_of(output, "  hard                    ", 2), -9);
    char *text = read_text(csv);
    check_csv(text);
    expect_in(text, "visible-share-all,seen,%,");
    free(text);
    draw("direct.csv", "charts");
    expect_text("table-direct.svg");
}

/* --- the command line ------------------------------------------------------------------------- */

TEST(help) {
    static const char *const modes[] = {"times",    "passes",   "sweep",  "budget", "curves",
                                        "temporal", "failures", "direct", "quality"};
    check_runs("--help");
    enum { MODES = sizeof modes / sizeof *modes };
    for (int i = 0; i < MODES; i++)
        expect_text(modes[i]);
    for (int i = 0; i < MODES; i++) {
        if (!is_tried_here((size_t)i, 3))
            continue;
        check_runs(form("%s --help", modes[i]));
        expect_text(form("usage: manylight bench %s ", modes[i]));
    }
}

TEST(refusals) {
    static const char *const wrong[][2] = {
        {"", "MODE is missing"},
        {"woof", "no mode is called 'woof'"},
        {"times --budget", "unknown option '--budget'"},
        {"budget --frames 3", "unknown option '--frames'"},
        {"times --vary M=2", "unknown option '--vary'"},
        {"sweep --vary woof=1", "no setting is called 'woof'"},
        {"times scenes/cornell-box.glb --variant woof", "no variant is called 'woof'"},
        {"times scenes/cornell-box.glb --set vpls=4", "needs at least 64 VPLs"},
        {"failures woof", "no failure is called 'woof' (there are room"},
        {NULL},
    };
    static const char *const failures[][2] = {
        {"times no-such-scene.glb", "cannot open no-such-scene.glb"},
        {"times scenes/cornell-box.glb --light woof", "no light 'woof'"},
        {"direct scenes/cornell-box.glb --light woof", "no light 'woof'"},
        {"temporal scenes/cornell-box.glb", "cornell-box: nothing moves"},
        {"sweep scenes/cornell-box.glb --size 8x8 --tracer --reference ao",
         "--tracer has indirect light alone to compare, not --reference ao"},
        {NULL},
    };
    expect_refusals(2, "bench", wrong);
    expect_refusals(1, "bench", failures);
}

RUN_TESTS(NULL, NULL)
