#define _XOPEN_SOURCE 700
#include "command_support.h"

char output[1 << 16];

/* Whether the % at that place of the line is a word, and no part of a number or a name. */
static bool is_word(const char *line, const char *at) {
    return (at == line || strchr(" (\"'", at[-1])) && at[1] == ' ';
}

int run_line(const char *line) {
    char command[8192] = "(";
    char *folder = realpath(scratch(""), NULL), *binary = realpath(binary_path(), NULL);
    size_t used = 1;
    assert_true(folder && binary);
    for (const char *at = line; *at && used + 1 < sizeof command; at++) {
        const char *put = *at == '@' ? folder : *at == '%' && is_word(line, at) ? binary : NULL;
        used += (size_t)snprintf(command + used, sizeof command - used, put ? "%s" : "%.1s",
                                 put ? put : at);
    }
    assert_true(used + 1 < sizeof command);
    command[used] = ')';
    mem_free(folder, binary);
    int status = run_command(command, output, sizeof output);
    printf("    %s\n    -> %d %.300s\n", line, status, output);
    return status;
}

void expect(int status, const char *line) {
    int actual = run_line(line);
    if (actual != status)
        fail_msg("exit status %d, expected %d: %s", actual, status, output);
}

void expect_command(int status, const char *command, const char *arguments) {
    const char *line = form("%% %s %s", command, arguments);
    expect(status, line);
}

void expect_text(const char *text) {
    expect_in(output, text);
}

void expect_refusals(int status, const char *command, const char *const (*rows)[2]) {
    for (; **rows; rows++) {
        expect_command(status, command, rows[0][0]);
        expect_text(rows[0][1]);
    }
}

int count_text(const char *where, const char *text) {
    int count = 0;
    for (const char *at = where; (at = strstr(at, text)); at++)
        count++;
    return count;
}

void expect_in(const char *where, const char *text) {
    if (!strstr(where, text))
        fail_msg("'%s' is not in: %s", text, where);
}

void need_default_build(void) {
    if (strcmp(binary_path(), "./manylight") != 0) {
        printf("    skipped: only the default build is installed\n");
        skip();
    }
}

static bool has_module;

int build_module(void **state) {
    (void)state;
    has_module = run_line("test -e Makefile && test/python/find") == 0;
    return !has_module ||
                   run_line("flock -o " BUILD
                            "/module.lock make -s python PYTHON=$(test/python/find) BUILD=" BUILD
                            " -o " BUILD "/lib/libmanylight.so.*.* -o " BUILD
                            "/openimageio/libmanylight-openimageio.so") == 0
               ? 0
               : -1;
}

void need_module(void) {
    if (has_module)
        return;
    printf("    skipped: python3-dev, python3-cffi, python3-numpy or the source is not here\n");
    skip();
}
