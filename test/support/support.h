/* What every test program uses: cmocka, checks that print their values, and headers that most tests
 * need. */
#ifndef TEST_SUPPORT_H
#define TEST_SUPPORT_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/memory.h"

/* Whether `make test-long` runs, which tries all rows of each test; `make test` tries a few of each
 * kind. */
bool is_long_run(void);

/* Defines a test, TEST(name) { ... }, which RUN_TESTS runs after the tests above it. */
#define TEST(name) TEST_WITH(name, NULL, NULL)

/* The same between a set-up and a tear-down of its own. */
#define TEST_WITH(name, setup, teardown) ADD_TEST(true, name, setup, teardown)

/* Defines a test of the long run alone. */
#define LONG_TEST(name) ADD_TEST(is_long_run(), name, NULL, NULL)

#define ADD_TEST(is_run, name, setup, teardown)                                                    \
    static void test_##name(void **state);                                                         \
    __attribute__((constructor)) static void add_test_##name(void) {                               \
        const struct CMUnitTest test = {"test_" #name, test_##name, setup, teardown, NULL};        \
        if (is_run)                                                                                \
            add_test(__FILE__, __LINE__, &test);                                                   \
    }                                                                                              \
    static void test_##name(__attribute__((unused)) void **state)

/* Stands at the end of a file: the program runs the file's tests between set-up and tear-down. */
#define RUN_TESTS(setup, teardown)                                                                 \
    int main(void) {                                                                               \
        return run_file(__FILE__, setup, teardown);                                                \
    }

/* A set-up: the program's notes are not printed. */
int be_quiet(void **state);

void add_test(const char *file, int line, const struct CMUnitTest *test);
int run_file(const char *file, CMFixtureFunction setup, CMFixtureFunction teardown);

/* Declares a struct that x_free frees where the scope ends: OWNED(image) drawn = draw(...); */
#define OWNED(x) __attribute__((cleanup(x##_free))) struct x

/* A struct of these members: &FILLED(camera, .eye = {0, 0, 1}, .fov_y = 1). */
#define FILLED(type, ...) ((struct type){__VA_ARGS__})

/* Fails with both values when |value - expected| > tolerance; prints them either way. */
void check_near(const char *what, double value, double expected, double tolerance);

/* Fails unless value <= bound; prints both either way. NaN fails. */
void check_at_most(const char *what, double value, double bound);

/* Fails unless call returned true; prints the error message. */
void check_ok(const char *what, bool ok);

/* Fails unless all three coordinates are near; prints them. */
void check_vector(const char *what, const float value[3], double x, double y, double z,
                  double tolerance);

/* Fails where it was done, or the error message has not that text; prints the message. */
void check_refused(bool done, const char *message);

/* Whether this run tries the row of that index: one in step of them, or all. */
bool is_tried_here(size_t index, size_t step);

/* The text of printf. It is kept for the next 1000 texts. */
char *form(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Adds quotes to words of JSON, {name: one, uri: 'a b.png'}. Returns the length. */
size_t quote_words(const char *text, char *json, size_t size);

/* Runs a shell command; its exit status, its stdout and stderr together in output (truncated). */
int run_command(const char *command, char *output, size_t output_size);

/* Notes and warnings of the program between the two calls, a line each. */
extern char notes[4096];
void hear_notes(void);
void end_notes(void);

/* A file of the test's own folder below the build folder; the folder is made. Static buffer ring
 * of 8. */
const char *scratch(const char *file_name);

void write_text(const char *path, const char *text);

/* Writes JSON from text without quotes. */
void write_json(const char *path, const char *text);

/* Files and folders in it. */
int count_files(const char *folder);

/* Copies text, with the test's own folder for each @. */
void in_scratch(char *to, size_t size, const char *text);

/* Whether this build writes pictures of that extension, and reads all that OpenImageIO does: `make
 * bundle` builds with smaller libraries, which know few formats. */
bool knows_format(const char *extension);

/* Skips the test, with the reason, where this build has the smaller libraries; where a command
 * fails; where a file or a folder is not there. */
void need_all_formats(void);
void need_command(const char *command);
void need_file(const char *path);

/* The manylight binary under test. */
const char *binary_path(void);

/* ../shared when it is there, else NULL: such tests are skipped. */
const char *shared_path(void);

/* A file of ../shared/cases when it is there, else NULL. Static buffer. */
const char *shared_case(const char *file);

#endif
