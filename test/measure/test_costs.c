/* Costs of this machine, by tables that are written here: what is chosen by them, and which files are refused. No time decides
 * anything. */
#define _POSIX_C_SOURCE 200809L
#include "command_support.h"
#include "render_support.h"

#include "base/file/file.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "quality/costs.h"
#include "quality/quality.h"
#include "quality/time_budget.h"
#include "viewer/picture/preset.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int open_gl(void **state) {
    setenv("XDG_CACHE_HOME", scratch("cache"), 1);
    *state = open_context(CONTEXT_AUTO);
    log_set_level(LOG_QUIET); /* the listener hears all the same */
    hear_notes();
    return 0;
}

static int close_gl(void **state) {
    end_notes();
    context_free(*state);
    return 0;
}

/* Of all choices; those of the ladder the other way round: its last one is the cheapest. */
static struct costs reversed(void) {
    struct quality_choice choices[QUALITY_CHOICES_MAX];
    int count = quality_ladder(choices, 1, NULL);
    struct costs costs;
    costs_list(&costs);
    for (int i = 0; i < costs.count; i++)
        costs.items[i].ms = 1000 + i;
    for (int k = 0; k < count; k++) {
        char *text = costs_choice(choices[k].technique, choices[k].settings);
        for (int i = 0; i < costs.count; i++)
            if (strcmp(costs.items[i].choice, text) == 0)
                costs.items[i].ms = 100 - k;
        free(text);
    }
    return costs;
}

static void check_shipped(const struct quality_choice *ladder, const struct quality_choice *shipped,
                          int count) {
    for (int i = 0; i < count; i++) {
        assert_ptr_equal(ladder[i].settings, shipped[i].settings);
        assert_ptr_equal(ladder[i].technique, shipped[i].technique);
        assert_int_equal(ladder[i].passes, shipped[i].passes);
    }
}

/* The ladder goes by costs that have all of it, and else as it came; means of passes stay behind frames. */
static void test_order(void **state) {
    (void)state;
    struct quality_choice shipped[QUALITY_CHOICES_MAX], sorted[QUALITY_CHOICES_MAX];
    int frames = quality_ladder(shipped, 1, NULL), count = quality_ladder(shipped, 16, NULL);
    struct costs costs = reversed(), none = {0};
    assert_int_equal(quality_ladder(sorted, 16, &costs), count);
    for (int i = 0; i < count; i++) {
        const struct quality_choice *other = &shipped[i < frames ? frames - 1 - i : i];
        assert_ptr_equal(sorted[i].settings, other->settings);
        assert_ptr_equal(sorted[i].technique, other->technique);
        assert_int_equal(sorted[i].passes, other->passes);
    }
    /* Equal costs leave the order. */
    for (int i = 0; i < costs.count; i++)
        costs.items[i].ms = 5;
    quality_ladder(sorted, 16, &costs);
    check_shipped(sorted, shipped, count);
    costs_free(&costs);
    costs = reversed();
    for (int i = 0; i < costs.count; i++)
        if (strcmp(costs.items[i].choice, "technique=clustered") == 0)
            costs.items[i].choice[0] = 'T';
    quality_ladder(sorted, 16, &costs);
    check_shipped(sorted, shipped, count);
    quality_ladder(sorted, 16, &none);
    check_shipped(sorted, shipped, count);
    costs_free(&costs);
}

/* Each choice is one that measure_assign takes. */
static void test_choices(void **state) {
    (void)state;
    struct costs costs;
    costs_list(&costs);
    printf("    %d choices\n", costs.count);
    for (int i = 0; i < costs.count; i++) {
        struct measure_desc desc = measure_default(NULL, 8, 8);
        check_ok(costs.items[i].choice, measure_assign(&desc, costs.items[i].choice));
        check_ok(costs.items[i].choice, measure_check(&desc));
    }
    costs_free(&costs);
}

/* --- the file --------------------------------------------------------------------------------- */

/* Writes the machine's table, and returns its path, to be freed. */
static char *write_table(const struct costs *costs) {
    char *path = costs_path();
    assert_non_null(path);
    check_ok("write", costs_write(costs, path));
    return path;
}

static void test_round_trip(void **state) {
    (void)state;
    struct costs costs = reversed(), read;
    char *path = costs_path();
    remove(path);
    *notes = '\0';
    costs_load(&read);
    assert_int_equal(read.count, 0);
    assert_string_equal(notes, "");
    free(path);
    path = write_table(&costs);
    costs_load(&read);
    assert_string_equal(notes, "");
    assert_int_equal(read.count, costs.count);
    for (int i = 0; i < costs.count; i++) {
        assert_string_equal(read.items[i].choice, costs.items[i].choice);
        check_near(read.items[i].choice, read.items[i].ms, costs.items[i].ms, 0);
    }
    costs_free(&read);
    costs_free(&costs);
    free(path);
}

/* The text with one part replaced by another; all of it where there is no part. */
static char *replace(const char *text, const char *part, const char *by) {
    const char *at = part ? strstr(text, part) : text;
    assert_non_null(at);
    return mem_printf("%.*s%s%s", (int)(at - text), text, by, part ? at + strlen(part) : "");
}

static void test_refused(void **state) {
    (void)state;
    static const struct {
        const char *part, *by, *says;
    } cases[] = {
        {NULL, "", "it is no table of costs"},
        {NULL, "a text of somebody's\n", "it is no table of costs"},
        {"# what frames cost", "# what frames lost", "it is no table of costs"},
        {" cores\n", " cores more\n", "of another machine, driver or version"},
        {"# manylight ", "# manylight 0.0.", "of another machine, driver or version"},
        {"100 technique=clustered path=draft clustered.vals=4\n", "",
         "it lacks 'technique=clustered path=draft clustered.vals=4'"},
        {"100 technique", "much technique", "is no line of it"},
        {"100 technique", "-100 technique", "is no line of it"},
        {"100 technique", "0 technique", "is no line of it"},
        {"100 technique", "inf technique", "is no line of it"},
        {"100 technique", "nan technique", "is no line of it"},
        {"100 technique", "100\n100 technique", "is no line of it"},
        {"100 technique", "100 technique=clustered path=draft clustered.vals=4\n100 technique",
         "is there twice"},
    };
    struct costs costs = reversed(), read;
    char *path = write_table(&costs), *whole = file_read_text(path);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *text = replace(whole, cases[i].part, cases[i].by);
        check_ok("write", output_file_write(path, text, strlen(text)));
        *notes = '\0';
        costs_load(&read);
        printf("    %s\n", notes);
        assert_int_equal(read.count, 0);
        assert_non_null(strstr(notes, cases[i].says));
        assert_non_null(strstr(notes, "manylight tune measures anew"));
        free(text);
    }
    /* Torn, at any byte. */
    for (size_t size = 0; size < strlen(whole); size += 13) {
        check_ok("write", output_file_write(path, whole, size));
        costs_load(&read);
        assert_int_equal(read.count, 0);
    }
    char *large = mem_alloc(1 << 20, 1);
    check_ok("write", output_file_write(path, large, 1 << 20));
    costs_load(&read);
    assert_int_equal(read.count, 0);
    remove(path);
    free(large);
    free(whole);
    free(path);
    costs_free(&costs);
}

/* --- what goes by them ------------------------------------------------------------------------ */

static int run(const char *arguments, const char *picture) {
    char command[2048];
    snprintf(command, sizeof command,
             "XDG_CACHE_HOME=%s %s render scenes/cornell-box.glb -o %s --size 40x40 %s",
             scratch("cache"), binary_path(), picture, arguments);
    int status = run_command(command, output, sizeof output);
    printf("    %s\n    -> %d %s", arguments, status, output);
    return status;
}

/* What --max-error chooses follows the table, unless it is told not to; and pictures of a named quality do not. */
static void test_render(void **state) {
    (void)state;
    static const char *const error = "--max-error 90% --set vpls=64,vals=4";
    char shipped[256];
    struct costs costs = reversed();
    char *path = costs_path(), *draft = mem_strdup(scratch("draft.png")),
         *other = mem_strdup(scratch("other.png"));
    remove(path);
    assert_int_equal(run("--quality draft", draft), 0);
    assert_int_equal(run(error, other), 0);
    expect_text("path=draft clustered.vals=4, which errs");
    free(path);
    path = write_table(&costs);
    assert_int_equal(run(error, other), 0);
    expect_text("path=traced gather.interleave=2 gather.adaptive=1 picture.samples=16, which errs");
    snprintf(shipped, sizeof shipped, "%s --shipped-costs", error);
    assert_int_equal(run(shipped, other), 0);
    expect_text("path=draft clustered.vals=4, which errs");
    assert_int_equal(run("--quality draft", other), 0);
    struct file_bytes bytes[2];
    check_ok("read", file_read(&bytes[0], draft));
    check_ok("read", file_read(&bytes[1], other));
    assert_int_equal(bytes[0].size, bytes[1].size);
    assert_memory_equal(bytes[0].data, bytes[1].data, bytes[0].size);
    check_ok("write", output_file_write(path, "woof\n", 5));
    assert_int_equal(run(error, other), 0);
    expect_text("is ignored: it is no table of costs; manylight tune measures anew");
    expect_text("path=draft clustered.vals=4, which errs");
    remove(path);
    free(bytes[0].data);
    free(bytes[1].data);
    free(draft);
    free(other);
    free(path);
    costs_free(&costs);
}

/* The viewer's presets tell what they cost here. */
static void test_presets(void **state) {
    (void)state;
    struct costs costs = {0};
    costs_add(&costs, "technique=clustered", 10);
    costs_add(&costs, "technique=clustered path=draft", 2.5);
    costs_add(&costs, "technique=clustered path=traced", 34);
    static const char *const says[][2] = {
        {"draft", "x0.25 the time of Normal on this machine, and 1.4 to 2.7 times its error."},
        {"high", "x1.1 to x2.4 the time of Normal, and up to a quarter less error."},
        {"traced", "x3.4 the time of Normal on this machine, and up to a third"},
        {"fast", "For most scenes: the defaults."},
    };
    for (const struct preset *p = technique_default->presets; p->name; p++) {
        char help[PRESET_HELP_SIZE];
        preset_explain(p, &costs, help);
        printf("    %-8s %s\n", p->name, help);
        for (int i = 0; i < 4; i++)
            if (strcmp(says[i][0], p->name) == 0)
                assert_non_null(strstr(help, says[i][1]));
    }
    costs_free(&costs);
}

/* Tune leaves a table that is read, where it is told to, or in the cache. */
static void test_tune(void **state) {
    (void)state;
    char command[2048];
    struct costs read;
    char *path = costs_path();
    remove(path);
    const char *small = "tune scenes/cornell-box.glb --size 8x8 --frames 1";
    snprintf(command, sizeof command, "XDG_CACHE_HOME=%s %s %s", scratch("cache"), binary_path(),
             small);
    assert_int_equal(run_command(command, output, sizeof output), 0);
    expect_text("of normal  choice");
    expect_text("written to ");
    expect_text(path);
    *notes = '\0';
    costs_load(&read);
    assert_string_equal(notes, "");
    assert_true(read.count > 20);
    for (int i = 1; i < read.count; i++)
        assert_true(read.items[i].ms >= read.items[i - 1].ms);
    costs_free(&read);
    remove(path);
    static const struct {
        const char *arguments, *says;
        int status;
    } cases[] = {
        {"tune -o -", "name a file", 2},
        {"tune -o no-such-folder/x --size 8x8", "no-such-folder", 1},
        {"tune no-such-scene.glb -o build/x", "cannot open no-such-scene.glb", 1},
        {"tune --frames 0", "frames", 2},
        {"tune --help", "--max-error", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(run_program("%s", cases[i].arguments), cases[i].status);
        expect_text(cases[i].says);
    }
    free(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_order),      cmocka_unit_test(test_choices),
        cmocka_unit_test(test_round_trip), cmocka_unit_test(test_refused),
        cmocka_unit_test(test_render),     cmocka_unit_test(test_presets),
        cmocka_unit_test(test_tune),
    };
    return cmocka_run_group_tests_name("costs", tests, open_gl, close_gl);
}
