/* manylight bench, ended in the midst: the rows that were measured are on disk, the same command goes on from there, and what
 * comes out is what one run makes. Times are never compared. */
#define _GNU_SOURCE
#include "command_support.h"

#include "base/file/file.h"
#include "base/file/output_file.h"
#include "base/memory.h"

#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* --- a run ------------------------------------------------------------------------------------ */

#define SMALL "--size 24x16 --set map-size=16 --set rsm-size=64 --set shadow-size=64 --set vpls=64 "

/* Of each mode one, with the number of blocks after which it is ended. */
static const struct mode {
    const char *name, *arguments;
    int blocks;
} modes[] = {
    {"sweep",
     "sweep scenes/cornell-box.glb scenes/metaballs.glb --frames 1 --vary M=2,4,8 --variant fast "
     "--variant unshadowed --tracer --noise .1 " SMALL,
     7},
    {"budget", "budget scenes/cornell-box.glb --noise .1 " SMALL, 5},
    {"passes", "passes scenes/cornell-box.glb --passes 16 --noise .1 " SMALL, 2},
    {"quality", "quality scenes/cornell-box.glb --passes 4 --noise .1 " SMALL, 4},
    {"failures", "failures room contact thin-wall --noise .1 " SMALL, 1},
    {"temporal",
     "temporal scenes/moving-spot.glb scenes/metaballs.glb --frames 3 --variant fast " SMALL, 1},
};

enum { MODES = sizeof modes / sizeof *modes };

static void csv_of(const char *name, char path[512]) {
    snprintf(path, 512, "%s.csv", scratch(name));
}

static void command_of(const struct mode *mode, const char *csv, const char *more,
                       char command[2048]) {
    snprintf(command, 2048, "export XDG_CACHE_HOME=%s; exec %s bench %s --csv %s %s",
             scratch("resume-cache"), binary_path(), mode->arguments, csv, more);
}

static int run(const struct mode *mode, const char *csv, const char *more) {
    char command[2048];
    command_of(mode, csv, more, command);
    return run_command(command, output, sizeof output);
}

/* --- files ------------------------------------------------------------------------------------ */

static char *part_of(const char *csv) {
    return mem_printf("%s.part", csv);
}

static void remove_both(const char *csv) {
    char *part = part_of(csv);
    remove(csv);
    remove(part);
    free(part);
}

/* Behind so many lines "# end" of the text, of which the first ends what tells the run; NULL: it has fewer. */
static char *behind_blocks(char *text, int blocks) {
    for (int i = 0; text && i <= blocks; i++) {
        text = strstr(text, "# end\n");
        text += text ? strlen("# end\n") : 0;
    }
    return text;
}

static bool has_blocks(const char *part, int blocks) {
    if (access(part, F_OK) != 0)
        return false;
    char *text = file_read_text(part);
    bool has = text && behind_blocks(text, blocks);
    free(text);
    return has;
}

/* Leaves so many blocks, and half a row as a crash may. */
static void cut(const char *part, int blocks) {
    char *text = file_read_text(part);
    char *at = behind_blocks(text, blocks);
    assert_non_null(at);
    *at = '\0';
    char *torn = mem_printf("%s# of scene 0123456789abcdef\nsweep,cornell-box,36,24,\"fa", text);
    write_text(part, torn);
    mem_free(torn, text);
}

/* --- rows ------------------------------------------------------------------------------------- */

/* The cell of a line, without quotes of which the rows that count have none before it. */
static void cell_of(const char *line, int column, char cell[128]) {
    bool quoted = false;
    for (; column > 0; line++) {
        quoted ^= *line == '"';
        column -= *line == ',' && !quoted;
    }
    snprintf(cell, 128, "%.*s", (int)strcspn(line, ",\n"), line);
}

/* Times, what is made of them, and what the process holds. */
static bool is_time(const char *line) {
    static const char *const units[] = {"ms", "1/s", "x", "MiB"};
    static const char *const figures[] = {"of-first", "of-fastest", "gl-objects"};
    char what[128], unit[128];
    cell_of(line, 9, what);
    cell_of(line, 11, unit);
    bool is = false;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        is = is || strcmp(unit, units[i]) == 0;
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++)
        is = is || strcmp(what, figures[i]) == 0;
    return is;
}

/* A line up to the figures that are times, which begin with the column frame_ms; of a time without its value. */
static int length_that_counts(const char *line) {
    int columns = is_time(line) ? 12 : 18;
    const char *at = line;
    bool quoted = false;
    for (; columns > 0 && *at && *at != '\n'; at++) {
        quoted ^= *at == '"';
        columns -= *at == ',' && !quoted;
    }
    return (int)(at - line);
}

/* Returns how many rows there are. */
static int check_same(const char *csv, const char *whole) {
    char *texts[] = {file_read_text(csv), file_read_text(whole)};
    int rows = 0;
    assert_non_null(texts[0]);
    assert_non_null(texts[1]);
    for (const char *a = texts[0], *b = texts[1]; *a || *b; rows++) {
        int length = length_that_counts(a);
        if (length != length_that_counts(b) || strncmp(a, b, (size_t)length) != 0)
            fail_msg("row %d is\n%.*s\nnot\n%.*s", rows, (int)strcspn(a, "\n"), a,
                     (int)strcspn(b, "\n"), b);
        a += strcspn(a, "\n") + 1;
        b += strcspn(b, "\n") + 1;
    }
    mem_free(texts[0], texts[1]);
    return rows - 1;
}

/* --- ended and taken up ------------------------------------------------------------------------- */

/* Starts the run, and ends it by the signal when the blocks are there. Its messages are dropped. */
static void run_until(const struct mode *mode, const char *csv, int blocks, int number) {
    char command[2048], *part = part_of(csv);
    command_of(mode, csv, "</dev/null >/dev/null 2>&1", command);
    char *arguments[] = {"sh", "-c", command, NULL};
    pid_t process;
    int status;
    fflush(NULL);
    assert_int_equal(posix_spawn(&process, "/bin/sh", NULL, NULL, arguments, environ), 0);
    bool ended = false;
    while (!ended && !has_blocks(part, blocks)) {
        siginfo_t info = {0};
        nanosleep(&(struct timespec){0, 2000000}, NULL);
        waitid(P_PID, (id_t)process, &info, WEXITED | WNOHANG | WNOWAIT);
        ended = info.si_pid == process;
    }
    assert_false(ended);
    kill(process, number);
    assert_int_equal(waitpid(process, &status, 0), process);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == number);
    assert_int_equal(access(csv, F_OK), -1);
    free(part);
}

/* As one run, whichever signal ends it. The rows that were there are not measured again: they keep a mark. */
static void check_mode(const struct mode *mode, int number) {
    char whole[512], *csv, *part;
    csv_of(mode->name, whole);
    csv = mem_printf("%s.ended", whole);
    part = part_of(csv);
    if (access(whole, F_OK) != 0)
        run(mode, whole, "");
    remove_both(csv);
    run_until(mode, csv, mode->blocks, number);
    cut(part, mode->blocks);
    run(mode, csv, ""); /* fails where pictures do not hold what is promised of larger ones */
    expect_text(" subjects of a run that was broken off");
    int rows = check_same(csv, whole);
    printf("    %s after %d blocks by %s: %d rows as in one run\n", mode->name, mode->blocks,
           strsignal(number), rows);
    assert_true(rows > 5);
    assert_int_equal(access(part, F_OK), -1);
    mem_free(csv, part);
}

static void remove_whole(void) {
    for (int i = 0; i < MODES; i++) {
        char whole[512];
        csv_of(modes[i].name, whole);
        remove_both(whole);
    }
}

static void test_modes(void **state) {
    (void)state;
    remove_whole();
    for (int i = 0; i < MODES; i++)
        if (is_tried_here((size_t)i, 5))
            check_mode(&modes[i], SIGKILL);
}

static void test_signals(void **state) {
    (void)state;
    check_mode(&modes[0], SIGTERM);
    if (is_long_run())
        check_mode(&modes[0], SIGINT);
}

/* The journal of a sweep that was ended, in the file that csv_of tells. */
static void make_part(const char *name, char csv[512]) {
    char *part;
    csv_of(name, csv);
    part = part_of(csv);
    remove_both(csv);
    run_until(&modes[0], csv, 2, SIGKILL);
    cut(part, 2);
    free(part);
}

/* What was measured is taken as it is: a value that no run measures comes through. */
static void test_not_measured_again(void **state) {
    (void)state;
    char csv[512];
    make_part("marked", csv);
    char *part = part_of(csv), *text = file_read_text(part);
    char *row = strstr(text, ",relative-rmse,path,%,");
    assert_non_null(row);
    row += strlen(",relative-rmse,path,%,");
    char *marked = mem_printf("%.*s4321.5%s", (int)(row - text), text, row + strcspn(row, ","));
    write_text(part, marked);
    assert_int_equal(run(&modes[0], csv, ""), 0);
    expect_text("4321.50");
    char *rows = file_read_text(csv);
    assert_non_null(strstr(rows, ",relative-rmse,path,%,4321.5,"));
    mem_free(rows, marked, text, part);
}

/* Changes a text within the journal. */
static void change(const char *csv, const char *from, const char *to) {
    char *part = part_of(csv), *text = file_read_text(part), *at = strstr(text, from);
    assert_non_null(at);
    char *changed = mem_printf("%.*s%s%s", (int)(at - text), text, to, at + strlen(from));
    write_text(part, changed);
    mem_free(changed, text, part);
}

static void check_not_resumed(const char *csv, const char *more, const char *message) {
    char *part = part_of(csv), *before = file_read_text(part);
    int status = run(&modes[0], csv, more);
    const char *error = strstr(output, "manylight bench sweep: ");
    printf("    %d %s", status, error ? error : output);
    assert_int_equal(status, 1);
    expect_text(message);
    char *after = file_read_text(part);
    /* But for the half row. */
    assert_memory_equal(before, after, strlen(after));
    assert_true(!before[strlen(after)] ||
                strncmp(before + strlen(after), "# of scene 01", 13) == 0);
    assert_int_equal(access(csv, F_OK), -1);
    mem_free(before, after, part);
}

/* Other settings, another machine, commit or scene: the rows stay where they are, until they are dropped. */
static void test_others(void **state) {
    (void)state;
    char csv[512];
    make_part("others", csv);
    check_not_resumed(csv, "--frames 2", "\"frames 1\" there, \"frames 2\" here; --restart");
    check_not_resumed(csv, "--variant lightcuts", "\"variant lightcuts\" here");
    check_not_resumed(csv, "scenes/door.glb", "\"of scenes/door.glb\" here");
    change(csv, "\n# cpu ", "\n# cpu Another ");
    check_not_resumed(csv, "", "\"cpu Another ");
    change(csv, "# cpu Another ", "# cpu ");
    change(csv, "\n# commit ", "\n# commit another-");
    check_not_resumed(csv, "", "\"commit another-");
    change(csv, "# commit another-", "# commit ");
    change(csv, "# end\n# of scene ", "# end\n# of scene f");
    check_not_resumed(csv, "", "cornell-box as it was before it changed; --restart");
    assert_int_equal(run(&modes[0], csv, "--frames 2 --restart"), 0);
    assert_null(strstr(output, "broken off"));
    assert_int_equal(access(csv, F_OK), 0);
}

/* Screen passes run as they did, whichever way is faster now. */
static void test_screen_passes(void **state) {
    (void)state;
    static const char *const ways[] = {"fragment", "compute"};
    char csv[512];
    for (int i = is_long_run() ? 0 : 1; i < 2; i++) {
        make_part("way", csv);
        char *part = part_of(csv), *text = file_read_text(part);
        bool is_first = strstr(text, "\n# screen passes fragment\n");
        char *from = mem_printf("# screen passes %s\n", ways[is_first ? 0 : 1]);
        char *to = mem_printf("# screen passes %s\n", ways[i]);
        change(csv, from, to);
        assert_int_equal(run(&modes[0], csv, ""), 0);
        expect_text("broken off");
        mem_free(from, to, text, part);
    }
}

/* What is not whole rows, not a journal, or in use. */
static void test_bad_files(void **state) {
    (void)state;
    char csv[512];
    make_part("bad", csv);
    char *part = part_of(csv);
    change(csv, ",clock,,ms,", ",clock,,ms,much");
    check_not_resumed(csv, "", "no whole block of rows; --restart");
    write_text(part, "a text of somebody's\n");
    check_not_resumed(csv, "", "is not of manylight bench");
    check_not_resumed(csv, "--restart", "is not of manylight bench");
    write_text(part, "");
    struct output_journal journal;
    check_ok("open", output_journal_open(&journal, part));
    check_not_resumed(csv, "", "another process is writing it");
    output_journal_close(&journal);
    assert_int_equal(run(&modes[0], csv, ""), 0);
    free(part);
}

/* A run that fails after its first scene keeps that one's rows. One that measures nothing leaves nothing. */
static void test_failing(void **state) {
    (void)state;
    const struct mode second = {"",
                                "sweep scenes/cornell-box.glb no-such-scene.glb --frames 1 "
                                "--variant fast " SMALL,
                                0},
                      first = {"", "sweep no-such-scene.glb --frames 1 --variant fast " SMALL, 0};
    char csv[512];
    csv_of("failing", csv);
    char *part = part_of(csv);
    remove_both(csv);
    assert_int_equal(run(&first, csv, ""), 1);
    assert_int_equal(access(part, F_OK), -1);
    assert_int_equal(run(&second, csv, ""), 1);
    expect_text("keeps what is measured");
    assert_true(has_blocks(part, 1));
    assert_int_equal(access(csv, F_OK), -1);
    remove_both(csv);
    free(part);
}

/* --- the file that grows ------------------------------------------------------------------------ */

static void test_journal(void **state) {
    (void)state;
    const char *path = scratch("journal");
    struct output_journal journal, second;
    remove(path);
    check_ok("make", output_journal_open(&journal, path));
    assert_string_equal(journal.text, "");
    assert_false(output_journal_open(&second, path));
    check_ok("append", output_journal_append(&journal, "first\n", 6));
    check_ok("append", output_journal_append(&journal, "second\n", 7));
    output_journal_close(&journal);
    check_ok("open", output_journal_open(&journal, path));
    assert_string_equal(journal.text, "first\nsecond\n");
    check_ok("cut", output_journal_cut(&journal, 6));
    check_ok("append", output_journal_append(&journal, "third\n", 6));
    char *text = file_read_text(path);
    assert_string_equal(text, "first\nthird\n");
    free(text);
    check_ok("remove", output_journal_remove(&journal));
    assert_int_equal(access(path, F_OK), -1);
    output_journal_close(&journal);
    assert_int_equal(mkfifo(path, 0600), 0);
    assert_false(output_journal_open(&journal, path));
    remove(path);
    assert_false(output_journal_open(&journal, "no-such-folder/journal"));
    assert_false(output_journal_open(&journal, scratch("")));
}

int main(void) {
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_journal),       cmocka_unit_test(test_modes),
        cmocka_unit_test(test_signals),       cmocka_unit_test(test_not_measured_again),
        cmocka_unit_test(test_others),        cmocka_unit_test(test_bad_files),
        cmocka_unit_test(test_screen_passes), cmocka_unit_test(test_failing),
    };
    return cmocka_run_group_tests_name("resume", tests, NULL, NULL);
}
