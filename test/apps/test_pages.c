/* Each technique and direct method has a page, of the same shape, that names its own settings. The
 * page of all settings is the one that the program's help makes. */
#include "base/file/file.h"
#include "command_support.h"
#include "direct/direct.h"
#include "techniques/technique.h"

static void check_says(const char *path, const char *text, const char *words) {
    if (!strstr(text, words))
        fail_msg("%s does not say '%s'", path, words);
}

/* The part that belongs to it alone is called as it is; shared ones are named by their owner. */
static void check_page(const char *kind, const char *name,
                       const struct settings_part *const *parts) {
    static const char *const headings[] = {"# ",          "## Citation",
                                           "## Pipeline", "## Deviations from the paper",
                                           "## Settings", "## Known artefacts"};
    char words[128];
    const char *path = form("src/%s/%s/README.md", kind, name);
    char *text = file_read_text(path);
    if (!text)
        fail_msg("%s is missing: write it with the headings of the array above, as "
                 "src/techniques/unshadowed/README.md",
                 path);
    const char *at = text;
    for (size_t i = 0; i < sizeof headings / sizeof *headings; i++) {
        at = strstr(at, headings[i]);
        if (!at)
            fail_msg("%s: no heading '%s' after '%s'", path, headings[i],
                     i ? headings[i - 1] : "the start");
    }
    int named = 0;
    for (; *parts; parts++) {
        bool own = strcmp((*parts)->owner, name) == 0;
        snprintf(words, sizeof words, "`%s", (*parts)->owner);
        check_says(path, text, words);
        for (const struct option *option = (*parts)->table; own && option->name; option++) {
            snprintf(words, sizeof words, "`%s.%s`", (*parts)->owner, option->name);
            check_says(path, text, words);
            named++;
        }
    }
    printf("    %s: %d settings of its own\n", path, named);
    free(text);
}

TEST(techniques) {
    for (const struct technique *const *t = techniques; *t; t++)
        check_page("techniques", (*t)->name, (*t)->parts);
}

TEST(direct_methods) {
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        check_page("direct", (*d)->name, (*d)->parts);
}

/* The page of settings is written by a script from the help of the program. */
TEST(settings_page) {
    expect(0, "docs/settings-page % >@/settings.md");
    assert_string_equal(output, "");
    expect(0, "diff -u docs/user/06-settings.md @/settings.md"); /* else renew the page so */
}

RUN_TESTS(NULL, NULL)
