#include "apps/arguments.h"

#include "base/error.h"
#include "base/events.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/words.h"
#include "scene/read_rules.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

static const struct option common_options[] = {
    {"help", 'h', OPTION_FLAG, offsetof(struct common_values, help),
     .help = "print this help and exit"},
    {"help-all", 0, OPTION_FLAG, offsetof(struct common_values, help_all),
     .help = "print all options and settings, and exit"},
    {"quiet", 'q', OPTION_FLAG, offsetof(struct common_values, quiet),
     .help = "no notes, no progress"},
    {"verbose", 'v', OPTION_FLAG, offsetof(struct common_values, verbose), .help = "more notes"},
    {NULL},
};

static const struct option scene_options[] = {
    {"strict", 0, OPTION_FLAG, offsetof(struct common_values, strict),
     .help = "refuse files with defects; without it defects are repaired or replaced, with a note",
     .rare = true},
    {"root", 0, OPTION_TEXT, offsetof(struct common_values, root), .value_name = "DIR",
     .help = "folder that must contain all files of a scene [parent of the scene's folder]",
     .rare = true},
    {NULL},
};

static const char *const progress_names[] = {"text", "json", NULL};

static const struct option progress_options[] = {
    {"progress", 0, OPTION_CHOICE, offsetof(struct common_values, progress),
     .choices = progress_names,
     .help = "form of progress, notes and errors on standard error;\n"
             "json: an object a line, for other programs",
     .rare = true},
    {NULL},
};

enum { TABLES = 4 };

static size_t row_count(const struct option *table) {
    size_t count = 0;
    while (table[count].name)
        count++;
    return count;
}

static const struct option *tables_of(const struct arguments *arguments, int n) {
    const struct option *const tables[TABLES] = {
        arguments->options, arguments->opens_scenes ? scene_options : NULL,
        arguments->shows_progress ? progress_options : NULL, common_options};
    return tables[n];
}

/* The subcommand's own rows come first; the caller frees the table. */
static struct option *join_tables(const struct arguments *arguments) {
    size_t count = 0;
    struct option *table = mem_alloc(1, sizeof *table);
    for (int n = 0; n < TABLES; n++) {
        const struct option *rows = tables_of(arguments, n);
        size_t more = rows ? row_count(rows) : 0;
        table = mem_resize(table, count + more + 1, sizeof *table);
        if (more > 0)
            memcpy(table + count, rows, more * sizeof *table);
        count += more;
    }
    table[count] = (struct option){NULL};
    return table;
}

bool arguments_is_help(const char *argument) {
    return strcmp(argument, "--help") == 0 || strcmp(argument, "--help-all") == 0 ||
           strcmp(argument, "-h") == 0;
}

/* Help wins over any mistake beside it: who asks for it may have made one. */
static bool asks_for_help(int argc, char **argv, struct common_values *common) {
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        common->help_all |= strcmp(argv[i], "--help-all") == 0;
        common->help |= arguments_is_help(argv[i]);
    }
    return common->help;
}

static void print_help(const struct arguments *arguments, const struct option *table,
                       const char *name, const void *values) {
    bool all = ((const struct common_values *)values)->help_all;
    printf("usage: manylight %s %s\n\n%s\n\n", name, arguments->synopsis, arguments->summary);
    int left_out = options_print_help(stdout, table, "--", all);
    if (arguments->print_more)
        arguments->print_more(stdout, values);
    if (left_out > 0)
        printf("\nmanylight %s --help-all lists all options and settings.\n", name);
}

bool arguments_check_use(const struct common_values *common, const struct option_use *uses) {
    for (const struct option_use *use = uses; use->options; use++)
        for (int i = 0; i < common->given.count; i++)
            for (struct word word = {.at = use->options}; !use->applies && word_next(&word);)
                if (word_is(&word, common->given.items[i]))
                    return error_set("--%s is for %s", common->given.items[i], use->place);
    return true;
}

/* Of the options that all subcommands have. */
static bool check_common(const struct common_values *common) {
    return arguments_check_use(
        common, (struct option_use[]){{"verbose", !common->quiet, "runs without --quiet"}, {NULL}});
}

static void end_without_memory(int number) {
    (void)number;
    event_tell_last("manylight: too little memory for the work and the OpenGL driver, by ulimit");
    _exit(STATUS_FAILED);
}

/* Turns the signals that end a driver or a library without memory into one message. */
static void expect_lack_of_memory(void) {
    static const int ends[] = {SIGABRT, SIGBUS, SIGILL, SIGSEGV, SIGTRAP};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        signal(ends[i], end_without_memory);
}

static bool apply(const struct arguments *arguments, const struct common_values *common) {
    if (mem_is_scarce())
        expect_lack_of_memory();
    if (arguments->shows_progress && common->progress == 1)
        events_choose_json();
    if (common->quiet)
        log_set_level(LOG_QUIET);
    else if (common->verbose)
        log_set_level(LOG_VERBOSE);
    return !arguments->opens_scenes || read_rules_set(common->strict, common->root) ||
           error_prefix("--root");
}

bool arguments_parse(const struct arguments *arguments, void *values, int argc, char **argv,
                     const char **positional, int *positional_count, int *status) {
    for (int i = 0; i < arguments->max_positional; i++)
        positional[i] = NULL;
    struct option *table = join_tables(arguments);
    struct common_values *common = values;
    options_set_defaults(table, values);
    bool go_on = false;
    if (asks_for_help(argc, argv, values)) {
        options_parse_arguments(table, values, argc, argv, positional, arguments->max_positional,
                                positional_count, NULL);
        print_help(arguments, table, argv[0], values);
        *status = STATUS_OK;
    } else if (!options_parse_arguments(table, values, argc, argv, positional,
                                        arguments->max_positional, positional_count,
                                        &common->given) ||
               !check_common(common)) {
        *status = arguments_misuse(argv[0]);
    } else if (*positional_count < arguments->min_positional) {
        error_set("arguments are missing: %s", arguments->synopsis);
        *status = arguments_misuse(argv[0]);
    } else if (!apply(arguments, values)) {
        *status = arguments_fail(argv[0]);
    } else {
        go_on = true;
    }
    free(table);
    return go_on;
}

int arguments_fail(const char *name) {
    /* Libraries do not always say that it was memory. */
    char *text = mem_printf("manylight %s: %s%s", name, error_get(),
                            mem_is_limited() ? " (ulimit -d bounds its memory)" : "");
    if (events_are_json())
        event_tell("error", text);
    else
        fprintf(stderr, "%s\n", text);
    free(text);
    return STATUS_FAILED;
}

int arguments_misuse(const char *name) {
    arguments_fail(name);
    return STATUS_USAGE;
}
