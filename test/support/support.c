#define _GNU_SOURCE
#include "support.h"

#include "base/file/output_file.h"
#include "base/log.h"

#include <assert.h>
#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* The tests of all files that a program links, in no order. */
static struct added {
    const char *file;
    int line;
    struct CMUnitTest test;
} added[1024];
static int added_count;

void add_test(const char *file, int line, const struct CMUnitTest *test) {
    assert(added_count < (int)(sizeof added / sizeof *added));
    added[added_count++] = (struct added){file, line, *test};
}

static int by_line(const void *a, const void *b) {
    return ((const struct added *)a)->line - ((const struct added *)b)->line;
}

int be_quiet(void **state) {
    (void)state;
    log_set_level(LOG_QUIET);
    return 0;
}

int run_file(const char *file, CMFixtureFunction setup, CMFixtureFunction teardown) {
    struct CMUnitTest tests[64];
    int count = 0;
    qsort(added, added_count, sizeof *added, by_line);
    for (int i = 0; i < added_count; i++)
        if (strcmp(added[i].file, file) == 0) {
            assert(count < (int)(sizeof tests / sizeof *tests));
            tests[count++] = added[i].test;
        }
    return _cmocka_run_group_tests(file, tests, count, setup, teardown);
}

void check_near(const char *what, double value, double expected, double tolerance) {
    printf("    %-48s %.6g, expected %.6g within %.3g\n", what, value, expected, tolerance);
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s: %.9g is not within %.3g of %.9g", what, value, tolerance, expected);
}

void check_at_most(const char *what, double value, double bound) {
    printf("    %-48s %.6g, at most %.6g\n", what, value, bound);
    if (!(value <= bound))
        fail_msg("%s: %.9g is above %.9g", what, value, bound);
}

void check_ok(const char *what, bool ok) {
    if (!ok)
        fail_msg("%s: %s", what, error_get());
}

void check_vector(const char *what, const float value[3], double x, double y, double z,
                  double tolerance) {
    check_near(what, value[0], x, tolerance);
    check_near(what, value[1], y, tolerance);
    check_near(what, value[2], z, tolerance);
}

void check_refused(bool done, const char *message) {
    assert_false(done);
    printf("    %s\n", error_get());
    if (!strstr(error_get(), message))
        fail_msg("expected '%s'", message);
}

bool is_long_run(void) {
    const char *text = getenv("MANYLIGHT_LONG");
    return text && strcmp(text, "1") == 0;
}

bool is_tried_here(size_t index, size_t step) {
    return is_long_run() || index % step == 0;
}

char *form(const char *format, ...) {
    static char *texts[1000];
    static int next;
    char **text = &texts[next++ % 1000];
    va_list arguments;
    va_start(arguments, format);
    free(*text);
    assert_true(vasprintf(text, format, arguments) >= 0);
    va_end(arguments);
    return *text;
}

/* The length of a string in quotes, of a word, or of a number, which has no quotes to get. */
static size_t token_length(const char *text) {
    if (*text != '"' && *text != '\'')
        return strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789.+-");
    const char *end = text + 1;
    while (*end && *end != *text)
        end += *end == '\\' && end[1] ? 2 : 1;
    return (size_t)(end - text) + (*end != '\0');
}

static bool lacks_quotes(const char *word, size_t length) {
    static const char *const bare[] = {"true", "false", "null", "NaN"};
    for (size_t i = 0; i < sizeof bare / sizeof *bare; i++)
        if (strlen(bare[i]) == length && strncmp(word, bare[i], length) == 0)
            return false;
    return isalpha((unsigned char)*word) || *word == '_';
}

size_t quote_words(const char *text, char *json, size_t size) {
    size_t used = 0;
    for (size_t length; *text; text += length) {
        size_t token = token_length(text);
        length = token ? token : 1;
        bool in_quotes = *text == '\'', bare = token && lacks_quotes(text, length);
        const char *quote = in_quotes || bare ? "\"" : "";
        used += (size_t)snprintf(json + used, size - used, "%s%.*s%s", quote,
                                 (int)length - 2 * in_quotes, text + in_quotes, quote);
        assert_true(used < size);
    }
    return used;
}

int run_command(const char *command, char *output, size_t output_size) {
    char line[4096];
    snprintf(line, sizeof line, "%s 2>&1 </dev/null", command);
    FILE *pipe = popen(line, "r");
    assert_non_null(pipe);
    size_t used = 0;
    char chunk[4096];
    for (size_t got; (got = fread(chunk, 1, sizeof chunk, pipe)) > 0;) {
        size_t room = output_size - 1 - used, take = got < room ? got : room;
        memcpy(output + used, chunk, take);
        used += take;
    }
    output[used] = '\0';
    int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

char notes[4096];

static void hear(void *context, bool is_warning, const char *message) {
    (void)context, (void)is_warning;
    size_t used = strlen(notes);
    snprintf(notes + used, sizeof notes - used, "%s\n", message);
}

void hear_notes(void) {
    *notes = '\0';
    log_set_listener(hear, NULL);
}

void end_notes(void) {
    log_set_listener(NULL, NULL);
}

const char *scratch(const char *file_name) {
    static char paths[8][512];
    static int next;
    const char *build = getenv("MANYLIGHT_BUILD");
    char folder[256];
    snprintf(folder, sizeof folder, "%s/scratch", build ? build : "build");
    mkdir(folder, 0777);
    size_t length = strlen(folder);
    snprintf(folder + length, sizeof folder - length, "/%s", program_invocation_short_name);
    mkdir(folder, 0777);
    char *path = paths[next++ % 8];
    snprintf(path, sizeof paths[0], "%s/%s", folder, file_name);
    return path;
}

void write_text(const char *path, const char *text) {
    check_ok(path, output_file_write(path, text, strlen(text)));
}

void write_json(const char *path, const char *text) {
    size_t size = 2 * strlen(text) + 1; /* a word of one letter in quotes and what parts it */
    char *json = mem_alloc(size, 1);
    quote_words(text, json, size);
    write_text(path, json);
    free(json);
}

int count_files(const char *folder) {
    DIR *directory = opendir(folder);
    assert_non_null(directory);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(directory));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0) {
            printf("    %s/%s\n", folder, entry->d_name);
            count++;
        }
    closedir(directory);
    return count;
}

void in_scratch(char *to, size_t size, const char *text) {
    const char *folder = scratch("");
    size_t length = strlen(folder) - 1; /* without the slash */
    for (; *text && size > length + 1; text++) {
        size_t step = *text == '@' ? length : 1;
        memcpy(to, *text == '@' ? folder : text, step);
        to += step;
        size -= step;
    }
    *to = '\0';
}

bool knows_format(const char *extension) {
    char name[32];
    snprintf(name, sizeof name, "a.%s", extension);
    return image_name_tells_format(name);
}

void need_all_formats(void) {
    if (knows_format("tif"))
        return;
    printf("    skipped: this build knows few picture formats\n");
    skip();
}

void need_command(const char *command) {
    char output[256];
    if (run_command(command, output, sizeof output) == 0)
        return;
    printf("    skipped: '%s' does not run here\n", command);
    skip();
}

void need_file(const char *path) {
    if (access(path, F_OK) == 0)
        return;
    printf("    skipped: %s is not here\n", path);
    skip();
}

const char *binary_path(void) {
    const char *binary = getenv("MANYLIGHT_BINARY");
    return binary ? binary : "./manylight";
}

const char *shared_path(void) {
    return access("../shared/scenes/cornell-box.glb", R_OK) == 0 ? "../shared" : NULL;
}

const char *shared_case(const char *file) {
    static char path[512];
    snprintf(path, sizeof path, "../shared/cases/%s", file);
    return access(path, R_OK) == 0 ? path : NULL;
}
