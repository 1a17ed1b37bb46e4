/* bench/table/run: what was measured is kept, a case that fails is a row, and the rows are the same
 * bytes in whatever order and by however many processes they were made. A copy of a picture stands
 * for a renderer. */
#define _POSIX_C_SOURCE 200809L
#include "command_support.h"

#include "base/file/file.h"

#include <unistd.h>

/* The driver's own program is that of the tests. */
#define TABLE WITH_MODULE(BUILD "/python") "bench/table/run "
#define RUN TABLE "--frames 0 --spp 4 --device test --scene scenes/cornell-box.glb "
#define SIZES "--size 24x24 --size 32x24 "
#define COPY "--variant none --renderer 'copy=@/draw' "
#define MORE "--renderer 'none=echo too bad >&2; false' "

static int prepare(void **state) {
    if (build_module(state) != 0 || run_line("test/python/find") != 0)
        return 0;
    expect(0, "rm -rf @/* && mkdir -p @/entry");
    expect(0, "printf '#!/bin/sh\\nexec %s reference \"$1\" --size \"$2\" --spp 1 --seed 1 -q -o "
              "\"$3\"\\n' "
              "\"$(realpath \"${MANYLIGHT_BINARY:-./manylight}\")\" > @/draw && chmod +x @/draw");
    expect(1, RUN SIZES COPY MORE "-o @/one");
    return 0;
}

/* Fails unless a file holds so many of the text. */
static void expect_count(const char *file, const char *text, int expected) {
    char *all = file_read_text(scratch(file));
    check_ok(file, all);
    int count = count_text(all, text);
    printf("    %s: %d of '%s'\n", file, count, text);
    assert_int_equal(count, expected);
    free(all);
}

TEST(failed_case_is_a_row) {
    need_module();
    expect_count("one/results.json", "\"scene\": ", 4);
    expect_count("one/results.json", "\"status\": \"failed\", \"error\": \"too bad\"", 2);
    expect_count("one/results.json", "\"relative-rmse\": ", 2);
    expect_count("one/TABLE.md", "- `cornell-box` 24x24 none: `too bad`", 1);
}

/* All figures are those of score for the folder that the table leaves as an entry. */
TEST(rows_are_scores) {
    need_module();
    run_line(
        WITH_MODULE(BUILD "/python") "$PYTHON bench/score.py @/one/entries/copy @/one/references"
                                     " -o @/score.json"); /* noise may be a fault */
    expect_text("copy\npicture");
    expect(0, "grep -o '\"metrics\": {[^}]*}' @/score.json > @/a && "
              "grep -o '\"metrics\": {[^}]*}' @/one/results.json > @/b && cmp @/a @/b && cat @/a");
    assert_int_equal(count_text(output, "hdr-flip"), 2);
    expect_count("one/entries/copy/method.json", ".exr\": \"", 2);
}

TEST(resume) {
    need_module();
    expect(0,
           "rm -rf @/two && cp -r @/one @/two && rm @/two/cases/*24x24.copy* @/two/results.json");
    expect(0, RUN SIZES COPY MORE "-o @/two --dry-run");
    expect_text("missing: 1\nstale: 0\nfailed: 2\nok: 1");
    expect(1, "test -e @/two/results.json");
    expect(1, RUN SIZES COPY MORE "-o @/two --missing-only");
    expect_text("cornell-box 24x24 copy\n4 rows, 2 failed");
    expect(0, "cmp @/one/results.json @/two/results.json");
    expect(1, RUN SIZES COPY MORE "-o @/two");
    assert_int_equal(count_text(output, " none\n"), 2); /* in either order */
    expect_text("4 rows");
    /* Rows of another commit are measured again, unless only missing rows are wanted. */
    expect(0, "sed -i 's/\"commit\": \"[^\"]*\"/\"commit\": \"other\"/' @/two/cases/*32x24.copy*");
    expect(1, RUN SIZES COPY MORE "-o @/two --missing-only");
    assert_int_equal(count_text(output, "cornell-box"), 0);
    expect(1, RUN SIZES COPY "-o @/two");
    expect_text("cornell-box 32x24 copy\n4 rows");
    expect(0, "cmp @/one/results.json @/two/results.json");
}

TEST(dry_run_writes_nothing) {
    need_module();
    expect(0, RUN SIZES COPY "-o @/nothing --dry-run");
    expect_text("missing  cornell-box 24x24 copy");
    expect_text("missing: 2");
    expect(1, "test -e @/nothing");
}

TEST(parts_and_machines) {
    need_module();
    expect(0, RUN SIZES COPY MORE "-o @/parts --part 1/2");
    expect(1, "test -e @/parts/results.json");
    expect(0, RUN SIZES COPY MORE "-o @/parts --part 0/2");
    expect(1, RUN SIZES "-o @/parts --join");
    expect(0, "cmp @/one/results.json @/parts/results.json");
    /* Another machine has other rows; the same machine must not have other figures. */
    expect(0, "rm -rf @/other && cp -r @/parts @/other && cd @/other/cases && for f in *; do "
              "sed 's/\"test\"/\"far\"/' $f > $(echo $f | sed s/test.json/far.json/); rm $f; done");
    expect(1, RUN "-o @/parts --join --merge @/other");
    expect_text("8 rows, 4 failed");
    expect(1, RUN "-o @/other --join --merge @/one --merge @/parts");
    expect(0, "cmp @/parts/results.json @/other/results.json");
    expect(0,
           "rm -rf @/wrong && cp -r @/one @/wrong && sed -i 's/\"sha256\": \"./\"sha256\": \"x/' "
           "@/wrong/cases/*copy*");
    expect(1, RUN "-o @/parts --join --merge @/wrong");
    expect_text("another row of this device is here");
}

TEST(entry_and_variant) {
    need_module();
    expect(0, "cp @/one/references/cornell-box.24x24.exr @/entry && echo '{\"name\": \"them\", "
              "\"device\": \"GPU\", "
              "\"ms\": {\"median\": 2.5, \"frames\": 9}}' > @/entry/method.json");
    expect(0, TABLE
           "--spp 4 --scene scenes/cornell-box.glb " SIZES
           "--size 24x24 --frames 1 --variant few:technique=unshadowed,vpls=64 --entry @/entry "
           "-o @/mixed");
    expect_count("mixed/results.json", "\"method\": \"entry\"", 1);
    expect_count("mixed/results.json", "--technique unshadowed --set vpls=64", 2);
    expect_count("mixed/times.json", "\"ms\": 2.5, \"cpu_ms\": null", 1);
    expect_count("mixed/times.json", "\"cpu_ms\": null", 1);
    expect_count("mixed/times.json", "\"frames\": 1,", 2);
    need_command("python3 -c 'import jsonschema'");
    expect(
        0,
        "python3 test/apps/check_schema.py bench/schema/results.schema.json @/mixed/results.json "
        "bench/schema/results.schema.json @/one/results.json");
}

#define FEW TABLE "--spp 4 --scene scenes/cornell-box.glb --size 24x24 --frames 1 "

/* A row of another picture of the entry or of other settings is stale. */
TEST(changed_inputs) {
    need_module();
    expect(0,
           FEW "--variant few:technique=unshadowed,vpls=64 --entry @/entry -o @/mixed --dry-run");
    expect_text("stale: 0\nfailed: 0\nok: 2");
    expect(0,
           FEW "--variant few:technique=unshadowed,vpls=32 --entry @/entry -o @/mixed --dry-run");
    expect_text("stale: 1\nfailed: 0\nok: 1");
    expect(0, "@/draw scenes/cornell-box.glb 24x24 @/entry/cornell-box.24x24.exr");
    expect(0,
           FEW "--variant few:technique=unshadowed,vpls=64 --entry @/entry -o @/mixed --dry-run");
    expect_text("stale: 1\nfailed: 0\nok: 1");
}

/* A run that is ended stops the renderer that it started, and leaves no row of it. */
TEST(ended_run) {
    need_module();
    expect(0,
           RUN "--size 24x24 --variant none --renderer 'slow=echo $$ > @/pid; exec sleep 300; :' "
               "-o @/ended & run=$!; i=0; while [ $i -lt 600 ] && ! [ -s @/pid ]; do sleep .1; "
               "i=$((i + 1)); done; kill -TERM $run; wait $run; [ $? -eq 130 ] && "
               "[ -s @/pid ] && ! kill -0 $(cat @/pid) && [ -z \"$(ls -A @/ended/cases)\" ]");
}

/* Names stay whole in all files. A case that is named twice is measured once. */
TEST(odd_names) {
    need_module();
    expect(0, "cp scenes/cornell-box.glb '@/a \"b\" c\\d|e.glb'");
    expect(0, TABLE "--frames 0 --spp 4 --device test --scene '@/a \"b\" c\\d|e.glb' "
                    "--scene '@/a \"b\" c\\d|e.glb' " SIZES "--size 24x24 --jobs 2 --variant none "
                    "--renderer 'my copy=@/draw' -o '@/odd names'");
    assert_int_equal(count_text(output, "c\\d|e 24x24 my copy\n"), 1);
    expect_text("2 rows, 0 failed");
    need_command("python3 -c 1");
    expect(0, "cd '@/odd names' && for f in *.json cases/* times/* entries/*/*.json; do "
              "python3 -m json.tool \"$f\" >/dev/null || exit 1; done");
    expect(0,
           "grep -cF 'a \\\"b\\\" c\\\\d|e.24x24.exr' '@/odd names/entries/my-copy/method.json'");
    expect_count("odd names/TABLE.md", "| `a \"b\" c\\d\\|e` | my copy | ", 2);
}

/* Two cases must not write one file. */
TEST(names_taken) {
    need_module();
    expect(0, "cp scenes/cornell-box.glb @/cornell-box.glb");
    expect(2, RUN "--scene @/cornell-box.glb -o @/nothing");
    expect_text("its rows would be those of scenes/cornell-box.glb");
    expect(2, RUN "--variant traced --variant traced:vals=9 -o @/nothing");
    expect_text("--variant traced:vals=9: its rows would be those of traced");
    expect(2, RUN "--variant none --renderer 'a b=x' --renderer a-b=y -o @/nothing");
    expect_text("--renderer a-b=y: its rows would be those of a b=x");
    expect(1, "test -e @/nothing");
}

TEST(refusals) {
    need_module();
    expect(2, RUN "--size 24 -o @/nothing");
    expect_text("--size 24: it is no WxH");
    expect(2, RUN "--part 2/2 -o @/nothing");
    expect(2, RUN "--jobs 0 -o @/nothing");
    expect_text("--jobs 0: it is no number from 1 on");
    expect(2, RUN "--renderer =x -o @/nothing");
    expect_text("it is no NAME=COMMAND");
    expect(2, RUN "--speed -o @/nothing");
    expect_text("--speed");
    expect(1, RUN "--entry @/one -o @/nothing");
    expect_text("it has no method.json");
    expect(1, RUN "--scene scenes/none.glb -o @/nothing");
    expect_text("--scene scenes/none.glb: it cannot be read");
    expect(1, "test -e @/nothing");
    /* A scene that cannot be traced fails in its row, not alone. */
    expect(1, "head -c 1000 scenes/cornell-box.glb > @/cut.glb; " RUN
              "--size 24x24 --scene @/cut.glb " COPY "-o @/cut");
    expect_text("2 rows, 1 failed");
    expect_count("cut/results.json", "\"error\": \"reference: ", 1);
}

RUN_TESTS(prepare, NULL)
