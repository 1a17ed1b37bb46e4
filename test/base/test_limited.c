/* --max-memory: every run works, or ends with one message and status 1, whatever the driver does. */
#define _GNU_SOURCE
#include "command_support.h"

#include "base/memory.h"

#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Lines that are no notes. */
static int count_messages(const char *text) {
    int count = 0;
    for (const char *line = text; *line; line += strcspn(line, "\n"), line += *line == '\n')
        count += strncmp(line, "manylight: note", 15) != 0;
    return count;
}

static void check_run(const char *arguments, const char *gib) {
    char command[1024];
    snprintf(command, sizeof command, "(%s %s --max-memory %s 2>&1 >/dev/null)", binary_path(),
             arguments, gib);
    int status = run_command(command, output, sizeof output);
    int messages = count_messages(output);
    printf("%s GiB: status %d, %d messages %.100s\n", gib, status, messages, output);
    assert_true(status == 0 || status == 1);
    assert_int_equal(messages, status);
    assert_null(strstr(output, "LLVM"));
}

/* From too little for anything to enough. */
static void test_bounds(void **state) {
    (void)state;
#ifdef __SANITIZE_ADDRESS__
    return; /* the sanitizer's own memory counts, terabytes */
#endif
    static const char *const bounds[] = {".01", ".12", ".15", ".18", ".2",  ".22",
                                         ".25", ".28", ".3",  ".33", ".36", "1"};
    char render[512], reference[512];
    snprintf(reference, sizeof reference, "reference scenes/sphere.glb -o %s --size 16x16 --spp 1",
             scratch("limited-r.exr"));
    snprintf(render, sizeof render, "render scenes/sphere.glb -o %s --size 16x16",
             scratch("limited.exr"));
    for (size_t i = 0; i < sizeof bounds / sizeof *bounds; i++)
        check_run(render, bounds[i]);
    assert_int_equal(access(scratch("limited.exr"), R_OK), 0); /* 1 GiB was enough */
    for (size_t i = 0; i < 3; i++)
        check_run("info scenes/sphere.glb", bounds[3 * i]);
    check_run("bench times scenes/sphere.glb --size 16x16", ".2");
    check_run(reference, ".12");
}

/* The status, what is printed and what is refused are those of the work. */
static void test_passes_on(void **state) {
    (void)state;
#ifdef __SANITIZE_ADDRESS__
    return;
#endif
    assert_int_equal(run_program("info scenes/sphere.glb --max-memory 1"), 0);
    expect_text("materials  ");
    assert_int_equal(run_program("info no-such.glb --max-memory 1"), 1);
    expect_text("no-such.glb");
    assert_int_equal(count_messages(output), 1);
    assert_int_equal(run_program("info --max-memory 1 --no-such"), 2);
}

/* Who ends the parent ends the work: a signal that asks is passed on. */
static void test_signal(void **state) {
    (void)state;
#ifdef __SANITIZE_ADDRESS__
    return;
#endif
    char command[1024];
    snprintf(command, sizeof command,
             "exec %s render scenes/sphere.glb --size 64x64 --frames 0..9999 -o %s --max-memory 2 "
             ">/dev/null 2>%s",
             binary_path(), scratch("limited.####.png"), scratch("limited.log"));
    char *arguments[] = {"sh", "-c", command, NULL};
    pid_t process;
    int status;
    remove(scratch("limited.0001.png")); /* of a run before */
    assert_int_equal(posix_spawn(&process, "/bin/sh", NULL, NULL, arguments, environ), 0);
    for (int i = 0; i < 3000 && access(scratch("limited.0001.png"), F_OK) != 0; i++)
        nanosleep(&(struct timespec){0, 20000000}, NULL);
    assert_int_equal(kill(process, SIGTERM), 0);
    assert_int_equal(waitpid(process, &status, 0), process);
    FILE *log = fopen(scratch("limited.log"), "r");
    assert_non_null(log);
    output[fread(output, 1, sizeof output - 1, log)] = '\0';
    fclose(log);
    printf("%s", output);
    expect_text("stopped before frame");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bounds),
        cmocka_unit_test(test_passes_on),
        cmocka_unit_test(test_signal),
    };
    return cmocka_run_group_tests_name("limited", tests, NULL, NULL);
}
