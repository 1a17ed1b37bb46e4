/* docs/manual: each option that --help-all lists has its line in the man page and in bash's
 * completions, and so has each setting. Checkers of man pages find nothing. Bash completes. */
#include "command_support.h"

#include "base/file/file.h"
#include "renderer/renderer.h"

#include <ctype.h>

static char *bash;

static int write_manual(void **state) {
    (void)state;
    if (run_line("test ! -e docs/manual || ! python3 -c 1") == 0)
        return 0;
    if (run_line("rm -rf @/manual && docs/manual % @/manual 2026-01-01") != 0)
        return -1;
    bash = file_read_text(scratch("manual/manylight.bash"));
    return bash ? 0 : -1;
}

static int free_manual(void **state) {
    (void)state;
    free(bash);
    return 0;
}

static void need_manual(void) {
    need_file("docs/manual");
    need_command("python3 -c 1");
}

/* --- lines ------------------------------------------------------------------------------------ */

/* The page as it is read, without roff's backslashes; to be freed. */
static char *read_page(const char *command) {
    const char *file = form("manual/manylight-%.*s.1", (int)strcspn(command, " "), command);
    char *page = file_read_text(scratch(file)), *to = page;
    assert_non_null(page);
    for (const char *from = page; *from; from++)
        if (*from != '\\')
            *to++ = *from;
    *to = '\0';
    return page;
}

/* The function of the command in a completion, to be freed. */
static char *function_of(const char *script, const char *command) {
    char *head = form("_manylight_%s() {\n", command);
    for (char *c = head; *c != '('; c++)
        if (*c == ' ')
            *c = '_';
    const char *begin = strstr(script, head);
    if (!begin)
        fail_msg("no function %s", head);
    const char *end = strstr(begin, "\n}\n");
    assert_non_null(end);
    char *text = calloc(1, (size_t)(end - begin) + 1);
    memcpy(text, begin, (size_t)(end - begin));
    return text;
}

static void check_option(const char *page, const char *in_bash, const char *name) {
    expect_in(page, form("fB--%sfR", name));
    expect_in(in_bash, form(" --%s", name));
}

/* "  -o, --output FILE" and "  --size WxH": the name behind the dashes, or NULL. */
static const char *option_of_line(const char *line, char name[64]) {
    if (strncmp(line, "  -", 3) != 0)
        return NULL;
    const char *at = line + 2;
    at += strncmp(at + 1, "-", 1) != 0 && at[2] == ',' ? 4 : 0;
    if (strncmp(at, "--", 2) != 0)
        return NULL;
    int length = (int)strspn(at + 2, "abcdefghijklmnopqrstuvwxyz-");
    snprintf(name, 64, "%.*s", length, at + 2);
    return name;
}

static void check_command(const char *command) {
    char name[64];
    int count = 0;
    expect_command(0, command, "--help-all");
    char *page = read_page(command), *in_bash = function_of(bash, command);
    for (const char *line = output; line; line = strchr(line, '\n')) {
        line += *line == '\n';
        if (option_of_line(line, name)) {
            check_option(page, in_bash, name);
            count++;
        }
    }
    printf("    %s: %d options\n", command, count);
    assert_true(count >= 5);
    mem_free(page, in_bash);
}

/* Rows of two spaces, a name and a help; others, which begin otherwise, are no names. */
static int names_of_help(const char *command, char names[][32], int most) {
    int count = 0;
    expect_command(0, command, "--help");
    for (const char *line = output; line && count < most; line = strchr(line, '\n')) {
        line += *line == '\n';
        if (strncmp(line, "  ", 2) == 0 && islower((unsigned char)line[2]))
            sscanf(line, " %31s", names[count++]);
    }
    return count;
}

TEST(options) {
    need_manual();
    char names[32][32], modes[32][32];
    int count = names_of_help("", names, 32), mode_count = names_of_help("bench", modes, 32);
    assert_true(count >= 9 && mode_count >= 9);
    for (int i = 0; i < count; i++)
        if (strcmp(names[i], "bench") != 0)
            check_command(names[i]);
    for (int i = 0; i < mode_count; i++)
        if (is_tried_here((size_t)i, 4)) {
            const char *command = form("bench %s", modes[i]);
            check_command(command);
        }
}

TEST(settings) {
    need_manual();
    struct settings settings;
    char *page = read_page("render"), name[SETTING_NAME_SIZE];
    int count = 0;
    renderer_settings_init(&settings);
    for (struct setting s = {0}; settings_next(&settings, &s); count++) {
        setting_name(&s, name);
        expect_in(page, form("fB%sfR\n", name));
        expect_in(bash, form(" %s= ", name));
    }
    printf("    %d settings\n", count);
    free(page);
}

/* --- checkers --------------------------------------------------------------------------------- */

TEST(groff) {
    need_manual();
    need_command("command -v groff");
    expect(0, "for page in @/manual/*.1; do groff -ww -z -man -Tutf8 $page; done");
    assert_string_equal(output, "");
}

/* Characters of commands are shown as they are typed: roff has hyphens, quotes, hats and tildes of
 * its own. A hyphen at the end of a line divides a word. */
TEST(characters) {
    need_manual();
    need_command("command -v groff");
    expect(0, "for page in @/manual/*.1; do groff -man -Tutf8 -P-cbou $page; done >@/pages");
    expect(1, "grep -e '‐.' -e '‘' -e '’' -e 'ˆ' -e '˜' @/pages");
    expect(0, "grep -F -e '~/.cache' @/pages && grep -F -e ')^2' @/pages");
    expect(0, "grep -F -c -e \"the paper's\" @/pages");
}

/* Titles of modes do not run into the next sentence. */
TEST(titles) {
    need_manual();
    char *page = read_page("bench");
    expect_in(page, "Tables 1 and 2\n.PP\nWithout SCENE");
    free(page);
}

TEST(mandoc) {
    need_manual();
    need_command("command -v mandoc");
    expect(0, "mandoc -T lint -W warning @/manual/*.1");
}

/* --- shells ----------------------------------------------------------------------------------- */

/* A command line, a completion of its last word, and a word that is none. */
static const struct completion {
    const char *line, *has, *lacks;
} completions[] = {
    {"manylight re", "reference", "bench"},
    {"manylight bench t", "temporal", "sweep"},
    {"manylight render --tech", "--technique", "--time"},
    {"manylight render --technique imp", "imperfect-volume", "clustered"},
    {"manylight render --layer ", "indirect", "normal"},
    {"manylight compare -l indirect.", "indirect.specular", "albedo"},
    {"manylight bench times --scr", "--screen-passes", "--size"},
    {"manylight render scenes/cornell-b", "scenes/cornell-box.glb", "scenes/atrium.glb"},
};

enum { COMPLETIONS = sizeof completions / sizeof *completions };

static void check_completions(const char *command) {
    for (int i = 0; i < COMPLETIONS; i++) {
        expect(0, form(command, completions[i].line));
        expect_text(completions[i].has);
        assert_null(strstr(output, completions[i].lacks));
    }
}

TEST(bash) {
    need_manual();
    check_completions("test/lab/complete.bash @/manual '%s'");
    expect(0, "test/lab/complete.bash @/manual 'manylight render --set clustered.visibility=p'");
    assert_string_equal(output, "pcss\n");
    expect(0, "test/lab/complete.bash @/manual 'manylight view --technique=row'");
    assert_string_equal(output, "row-column\n");
    expect(0, "test/lab/complete.bash @/manual 'manylight render --set clustered.visibility-b'");
    assert_string_equal(output, "clustered.visibility-block=\n");
    expect(0,
           "rm -rf @/odd && mkdir @/odd && touch '@/odd/a scene.glb' '@/odd/b*.glb' @/odd/bc.glb");
    expect(0, "test/lab/complete.bash @/manual 'manylight render @/odd/a\\ sc'");
    expect_text("odd/a scene.glb\n");
    expect(0, "test/lab/complete.bash @/manual 'manylight render @/odd/b\\*'");
    assert_null(strstr(output, "bc.glb")); /* readline is to complete it */
    expect(0, "test/lab/complete.bash @/manual 'manylight render @/odd/b'");
    expect_text("odd/b*.glb\n");
    assert_int_equal(count_text(output, "\n"), 2);
    expect(0, "test/lab/complete.bash @/manual 'manylight render \"@/odd/a sc'");
    assert_string_equal(output, "\n"); /* left to bash */
    expect(0, "test/lab/complete.bash @/manual 'manylight render --glsl sc'");
    assert_string_equal(output, "scenes\n");
}

/* --- refusals --------------------------------------------------------------------------------- */

TEST(refusals) {
    need_manual();
    expect(1, "docs/manual % @/manual");
    expect_text("manual MANYLIGHT FOLDER DATE");
    expect(1, "docs/manual % @/manual 2026-01-01");
    expect_text("manual: [Errno 17] File exists");
}

RUN_TESTS(write_manual, free_manual)
