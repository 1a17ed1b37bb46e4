/* manylight bench: its statistics, its grids and its files. Times are never compared: only that
 * they are there. */
#include "support.h"

#include "apps/bench.h"
#include "apps/bench_budget.h"
#include "apps/bench_chart.h"
#include "apps/bench_csv.h"
#include "apps/bench_sweep.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char output[32768];

static int bench(const char *arguments) {
    char command[2048];
    snprintf(command, sizeof command, "%s bench %s", binary_path(), arguments);
    return run_command(command, output, sizeof output);
}

static void check_says(const char *text) {
    if (!strstr(output, text))
        fail_msg("'%s' is not in:\n%s", text, output);
}

static void check_runs(const char *arguments) {
    if (bench(arguments) != 0)
        fail_msg("bench %s: %s", arguments, output);
}

static char *read_text(const char *path) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *text = calloc(1, 1 << 20);
    size_t size = fread(text, 1, (1 << 20) - 1, file);
    fclose(file);
    assert_true(size > 0);
    return text;
}

static void test_summary(void **state) {
    (void)state;
    float values[101];
    for (int i = 0; i < 101; i++)
        values[i] = (float)((i * 37) % 101); /* 0 to 100, shuffled */
    struct summary summary = summary_of(values, 101);
    assert_int_equal(summary.count, 101);
    check_near("median", summary.median, 50, 0);
    check_near("p5", summary.p5, 5, 0);
    check_near("p95", summary.p95, 95, 0);
    check_near("minimum", summary.minimum, 0, 0);
    check_near("maximum", summary.maximum, 100, 0);
    summary = summary_of((float[]){7}, 1);
    check_near("median of one", summary.median, 7, 0);
    check_near("p95 of one", summary.p95, 7, 0);
}

static void test_steps(void **state) {
    (void)state;
    struct bench_case measured = {
        .passes = {{"frame", 0, {.median = 20}},
                   {"frame/rsm", 1, {.median = 1}},
                   {"frame/vpls", 1, {.median = 2}},
                   {"frame/cssm", 1, {.median = 5}},
                   {"frame/cssm/mips", 2, {.median = 4}}, /* within the one above */
                   {"frame/gather", 1, {.median = 8}},
                   {"frame/never heard of", 1, {.median = 3}}},
        .pass_count = 7,
    };
    check_near("frame", bench_frame_ms(&measured), 20, 0);
    check_near("VPLs", bench_step_ms(&measured, STEP_VPLS), 3, 0);
    check_near("CSSM", bench_step_ms(&measured, STEP_CSSM), 5, 0);
    check_near("other", bench_step_ms(&measured, STEP_OTHER), 3, 0);
    check_near("sum", bench_sum_ms(&measured), 19, 0);
}

static void check_axis(const char *text, const char *name, const char *values) {
    struct sweep sweep = {0};
    char joined[512] = "";
    check_ok(text, sweep_parse(&sweep, text));
    assert_int_equal(sweep.axis_count, 1);
    assert_string_equal(sweep.axes[0].name, name);
    for (int i = 0; i < sweep.axes[0].count; i++) {
        strcat(joined, i ? " " : "");
        strcat(joined, sweep.axes[0].values[i]);
    }
    assert_string_equal(joined, values);
}

static void test_sweep_axes(void **state) {
    (void)state;
    check_axis("vals=2,8,30", "vals", "2 8 30");
    check_axis("M=2..120", "vals", "2 4 8 16 32 64 120");
    check_axis("N=64..256", "vpls", "64 128 256");
    check_axis("K=1,2..8", "terms", "1 2 4 8");
    check_axis("gain=1.5,2", "gain", "1.5 2");
    check_axis("technique=clustered,unshadowed", "technique", "clustered unshadowed");
    check_axis("size=40x30,80x60", "size", "40x30 80x60");
}

static void test_sweep_refusals(void **state) {
    (void)state;
    static const char *const wrong[] = {"",        "vals",   "vals=",          "=3",
                                        "vals=x",  "vals=0", "vals=8..2",      "vals=2..",
                                        "vals=2,", "woof=1", "technique=woof", "visibility=a..b"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct sweep sweep = {0};
        if (sweep_parse(&sweep, wrong[i]))
            fail_msg("'%s' was taken for a sweep", wrong[i]);
    }
}

static void test_sweep_points(void **state) {
    (void)state;
    struct sweep sweep = {0};
    check_ok("sweep", sweep_parse(&sweep, "M=2,4,visibility=cssm,hard,N=64..256"));
    assert_int_equal(sweep_point_count(&sweep), 2 * 2 * 3);
    struct bench_case prepared = {.series = "paper", .technique = technique_default};
    renderer_settings_init(&prepared.settings);
    sweep_apply(&sweep, 2 * 3 + 3 + 1, &prepared);
    assert_string_equal(prepared.series, "paper hard");
    assert_string_equal(prepared.label, "vals=4 vpls=128");
    char options[256];
    bench_options(&prepared.settings, options, sizeof options);
    assert_string_equal(options, "lights.vpls=128 clustered.vals=4 clustered.visibility=hard");
}

/* Where a JSON value ends, or NULL when it is none. */
static const char *skip_json(const char *at);

static const char *skip_space(const char *at) {
    while (isspace((unsigned char)*at))
        at++;
    return at;
}

static const char *skip_text(const char *at) {
    if (*at++ != '"')
        return NULL;
    for (; *at != '"'; at++)
        if (*at == '\0' || (*at == '\\' && *++at == '\0'))
            return NULL;
    return at + 1;
}

static const char *skip_members(const char *at, char close, bool named) {
    at = skip_space(at + 1);
    if (*at == close)
        return at + 1;
    for (;; at++) {
        at = skip_space(at);
        if (named) {
            if (!(at = skip_text(at)) || *(at = skip_space(at)) != ':')
                return NULL;
            at++;
        }
        if (!(at = skip_json(at)))
            return NULL;
        at = skip_space(at);
        if (*at == close)
            return at + 1;
        if (*at != ',')
            return NULL;
    }
}

static const char *skip_json(const char *at) {
    at = skip_space(at);
    if (*at == '{' || *at == '[')
        return skip_members(at, *at == '{' ? '}' : ']', *at == '{');
    if (*at == '"')
        return skip_text(at);
    for (const char *const *w = (const char *const[]){"true", "false", "null", NULL}; *w; w++)
        if (strncmp(at, *w, strlen(*w)) == 0)
            return at + strlen(*w);
    char *end;
    strtod(at, &end);
    return end == at ? NULL : end;
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

static void test_tables(void **state) {
    (void)state;
    char arguments[1024];
    const char *csv = scratch("bench.csv"), *json = scratch("bench.json");
    snprintf(arguments, sizeof arguments,
             "scenes/cornell-box.glb --size 24x16 --frames 2 --set map-size=32 --set vals=4 "
             "--variant paper --variant fast --variant 'none, \"it\":technique=unshadowed' --csv "
             "%s --json %s",
             csv, json);
    check_runs(arguments);
    check_says("Table 1");
    check_says("  cornell-box      paper                  24x16       36   1024     4 ");
    check_says("Table 2: cornell-box, paper, 24x16");
    static const char *const rows[] = {
        "deferred rendering",      "VPL generation", "VAL clustering", "CSSM",
        "indirect illumination",   "blur",           "sum of passes",  "ns per pixel",
        "times the frame of paper"};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        check_says(rows[i]);
    if (strstr(output, "  other "))
        fail_msg("a pass belongs to no step:\n%s", output);

    char *text = read_text(csv);
    assert_true(check_csv(text) > 10);
    assert_non_null(
        strstr(text, "\ncornell-box,36,24,16,1024,4,clustered,fast,,clustered.vals=4 map.size=32,"
                     "frame/cssm/depth maps,ms,2,"));
    assert_non_null(strstr(text, ",unshadowed,\"none, \"\"it\"\"\",,"));
    free(text);

    text = read_text(json);
    const char *end = skip_json(text);
    assert_non_null(end);
    assert_int_equal(*skip_space(end), '\0');
    assert_non_null(strstr(text, "\"gl_renderer\": \""));
    assert_non_null(strstr(text, "\"series\": \"none, \\\"it\\\"\""));
    free(text);
}

/* A sweep measures errors against a reference that the second run finds where the first put it. */
static void test_sweep_and_cache(void **state) {
    (void)state;
    char arguments[1024], remove[600];
    const char *cache = scratch("bench-cache"), *csv = scratch("sweep.csv");
    snprintf(remove, sizeof remove, "rm -rf %s", cache);
    assert_int_equal(run_command(remove, output, sizeof output), 0);
    snprintf(arguments, sizeof arguments,
             "scenes/cornell-box.glb --size 24x16 --frames 1 --set map-size=32 "
             "--sweep M=2,8,visibility=cssm,hard --reference path --noise .1 --cache %s --csv %s",
             cache, csv);
    check_runs(arguments);
    check_says("making reference");
    check_says("cornell-box      hard               vals=8 ");
    check_runs(arguments);
    assert_null(strstr(output, "making reference"));
    char *text = read_text(csv);
    check_csv(text);
    assert_non_null(strstr(text,
                           ",hard,vals=8,clustered.vals=8 clustered.visibility=hard map.size=32,"
                           "relative-rmse,1,"));
    free(text);
}

static void test_pareto_front(void **state) {
    (void)state;
    struct plot plot = {0};
    plot_add(&plot, "a", &(struct plot_point){.x = 1, .y = 9, .label = "fast"});
    plot_add(&plot, "a", &(struct plot_point){.x = 8, .y = 1, .label = "true"});
    plot_add(&plot, "b", &(struct plot_point){.x = 4, .y = 4, .label = "between"});
    plot_add(&plot, "b", &(struct plot_point){.x = 4, .y = 5, .label = "as fast, less true"});
    plot_add(&plot, "b", &(struct plot_point){.x = 9, .y = 9, .label = "neither"});
    struct plot_series front = plot_pareto_front(&plot);
    assert_int_equal(front.count, 3);
    assert_string_equal(front.points[0].label, "fast");
    assert_string_equal(front.points[1].label, "between");
    assert_string_equal(front.points[2].label, "true");
    free(front.points);
    plot_free(&plot);
}

static void test_log_ticks(void **state) {
    (void)state;
    double ticks[8];
    assert_int_equal(plot_log_ticks(1.5, 120, ticks, 8), 6); /* 2 5 10 20 50 100 */
    check_near("first", ticks[0], 2, 1e-9);
    check_near("last", ticks[5], 100, 1e-9);
    assert_int_equal(plot_log_ticks(.01, 1000, ticks, 8), 8);
}

static void test_csv(void **state) {
    (void)state;
    const char *path = scratch("cells.csv");
    FILE *file = fopen(path, "w");
    fputs("a,b\n\"x, \"\"y\"\"\",\n,2\n", file);
    fclose(file);
    struct csv csv;
    int column;
    check_ok("csv", csv_read(&csv, path));
    assert_int_equal(csv.row_count, 2);
    check_ok("column", csv_find(&csv, "b", &column));
    assert_string_equal(csv_cell(&csv, 0, 0), "x, \"y\"");
    assert_string_equal(csv_cell(&csv, 0, column), "");
    assert_string_equal(csv_cell(&csv, 1, column), "2");
    assert_false(csv_find(&csv, "c", &column));
    csv_free(&csv);
    file = fopen(path, "a");
    fputs("1,2,3\n", file);
    fclose(file);
    assert_false(csv_read(&csv, path));
}

/* Drawn from the rows that the sweep above has written. */
static void test_chart(void **state) {
    (void)state;
    char arguments[1024];
    const char *svg = scratch("charts/cornell-box.svg"), *png = scratch("charts/cornell-box.png");
    remove(svg);
    remove(png);
    snprintf(arguments, sizeof arguments, "--chart %s -o %s", scratch("sweep.csv"),
             scratch("charts"));
    if (bench(arguments) != 0 && strstr(output, "cannot run gnuplot"))
        skip();
    check_says("cornell-box.svg");
    char *text = read_text(svg);
    assert_non_null(strstr(text, "faces), 24x16"));
    assert_non_null(strstr(text, "Pareto front"));
    assert_non_null(strstr(text, "M=8"));
    free(text);
    text = read_text(png);
    assert_memory_equal(text + 1, "PNG", 3);
    free(text);
    assert_int_equal(bench("--chart no-such-file.csv"), 1);
    check_says("cannot open no-such-file.csv");
}

/* Two scenes of one name have a chart each, and points that are close keep their labels. */
static void test_chart_of_namesakes(void **state) {
    (void)state;
    FILE *file = fopen(scratch("namesakes.csv"), "w");
    fputs("scene,faces,width,height,series,label,quantity,median,gl_renderer\n", file);
    for (int faces = 30; faces <= 36; faces += 6)
        for (int vals = 2; vals <= 16; vals *= 2)
            fprintf(
                file,
                "box,%d,8,8,fast,vals=%d,wall,%g,x\nbox,%d,8,8,fast,vals=%d,relative-rmse,%g,x\n",
                faces, vals, 100. + vals, faces, vals, vals == 16 ? 1 : .1 + .0001 * vals);
    fclose(file);
    char arguments[1024];
    snprintf(arguments, sizeof arguments, "--chart %s -o %s", scratch("namesakes.csv"),
             scratch("namesakes"));
    if (bench(arguments) != 0 && strstr(output, "cannot run gnuplot"))
        skip();
    check_says("box.svg");
    check_says("box-36.svg");
    char *text = read_text(scratch("namesakes/box-36.svg"));
    assert_non_null(strstr(text, "box (36 faces)"));
    assert_non_null(strstr(text, "M=2"));
    assert_non_null(strstr(text, "M=4"));
    free(text);
}

static void test_slope(void **state) {
    (void)state;
    double x[] = {1, 10, 100}, cube[3], constant[] = {7, 7, 7};
    for (int i = 0; i < 3; i++)
        cube[i] = 5 * x[i] * x[i] * x[i];
    check_near("slope of a cube", bench_log_slope(x, cube, 3), 3, 1e-9);
    check_near("slope of a constant", bench_log_slope(x, constant, 3), 0, 1e-9);
    check_near("slope of a point", bench_log_slope(x, cube, 1), 0, 0);
}

static void test_scaling(void **state) {
    (void)state;
    check_runs("scenes/cornell-box.glb --scaling --size 24x16 --frames 1 --variant fast "
               "--set map-size=16 --set rsm-size=64 --set shadow-size=64 -q");
    check_says("  cornell-box      fast               pixels   slope ");
    check_says("  24: ");
    check_says("  384: ");
    check_says("  cornell-box      fast               N        slope ");
    check_says("  4096: ");
    check_says("  cornell-box      fast               M        slope ");
    check_says("  all scenes       fast               faces    slope  0.00 :  36: ");
}

/* The number in a column of the row of the output that begins so; columns count from 0. */
static double number_of(const char *row, int column) {
    const char *at = strstr(output, row);
    if (!at)
        fail_msg("'%s' is not in:\n%s", row, output);
    char *end = (char *)at + strlen(row);
    double value = 0;
    for (int i = 0; i <= column; i++)
        value = strtod(end, &end);
    return value;
}

/* The chain from the truth to the frame. Bounds are loose: 48 x 48 pixels, 10 % noise. */
static void test_budget(void **state) {
    (void)state;
    char arguments[1024];
    const char *csv = scratch("budget.csv");
    snprintf(arguments, sizeof arguments,
             "scenes/cornell-box.glb --budget --variant fast --size 48x48 --noise .1 --cache %s "
             "--csv %s -q",
             scratch("bench-cache"), csv);
    check_runs(arguments);
    for (int i = 0; i < BUDGET_STEPS; i++)
        check_says(budget_steps[i].name);
    /* Maps see what rays see: a leak or a shifted map costs tens of percent. */
    check_at_most("hard map per VPL, %", number_of("hard map per VPL", 0), 5);
    check_at_most("soft map per VAL, %", number_of("soft map per VAL", 0), 8);
    /* Interleaving is noise that the blur takes away again. */
    double interleaved = number_of("interleaved", 4), blurred = number_of("blurred", 4);
    check_at_most("blurred over interleaved", blurred / interleaved, .8);
    check_at_most("antialiased over blurred", number_of("antialiased: the frame", 4) / blurred, .8);
    /* The first step alone is the first step so far. */
    check_near("first step", number_of("pixel centres", 0), number_of("pixel centres", 4), 0);
    struct csv rows;
    check_ok("csv", csv_read(&rows, csv));
    assert_int_equal(rows.row_count, 2 * BUDGET_STEPS + 1);
    csv_free(&rows);
}

/* manylight reference --technique vpl-raytraced: rays and maps see the same from the same VPLs. */
static void test_vpl_raytraced(void **state) {
    (void)state;
    char command[2048];
    const char *traced = scratch("traced.exr"), *mapped = scratch("mapped.exr");
    snprintf(command, sizeof command,
             "%s reference scenes/cornell-box.glb --technique vpl-raytraced --set vpls=64 "
             "--set clamp=disk --size 32x32 -o %s -q && %s render scenes/cornell-box.glb "
             "--technique instant-radiosity --set vpls=64 --set clamp=disk --set interleave=1 "
             "--set samples=1 "
             "--size 32x32 -o %s && %s compare %s %s -l indirect --max relative-rmse=.05",
             binary_path(), traced, binary_path(), mapped, binary_path(), mapped, traced);
    if (run_command(command, output, sizeof output) != 0)
        fail_msg("%s", output);
}

static void test_refusals(void **state) {
    (void)state;
    assert_int_equal(bench("--sweep woof=1"), 2);
    check_says("no setting is called 'woof'");
    assert_int_equal(bench("no-such-scene.glb"), 1);
    check_says("cannot open no-such-scene.glb");
    assert_int_equal(bench("scenes/cornell-box.glb --variant woof"), 1);
    check_says("no variant is called 'woof'");
    assert_int_equal(bench("scenes/cornell-box.glb --set vpls=4"), 1);
    check_says("needs at least 64 VPLs");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_summary),         cmocka_unit_test(test_steps),
        cmocka_unit_test(test_sweep_axes),      cmocka_unit_test(test_sweep_refusals),
        cmocka_unit_test(test_sweep_points),    cmocka_unit_test(test_tables),
        cmocka_unit_test(test_sweep_and_cache), cmocka_unit_test(test_pareto_front),
        cmocka_unit_test(test_log_ticks),       cmocka_unit_test(test_csv),
        cmocka_unit_test(test_chart),           cmocka_unit_test(test_chart_of_namesakes),
        cmocka_unit_test(test_slope),           cmocka_unit_test(test_scaling),
        cmocka_unit_test(test_budget),          cmocka_unit_test(test_vpl_raytraced),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
