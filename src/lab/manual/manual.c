/* manylight manual: man pages, and completions for bash, of the tables that parse command lines. */
#define _POSIX_C_SOURCE 200809L
#include "lab/bench/bench.h"
#include "lab/manual/man_page.h"
#include "lab/manual/bash.h"
#include "apps/subcommands.h"

#include "base/error.h"
#include "base/file/output_file.h"
#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

struct values {
    struct common_values common;
    const char *output;
};

static const struct option options[] = {
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FOLDER",
     .help = "folder to make; an error if it exists"},
    {NULL},
};

static const struct arguments arguments = {
    .synopsis = "-o FOLDER",
    .summary = "Writes a man page for each subcommand, and completions for bash (manylight.bash).\n"
               "make install installs them.",
    .options = options,
};

struct manual {
    const char *folder;
    struct output_text page; /* of the present subcommand */
    struct output_text completions;
};

static bool write_text(const struct manual *manual, struct output_text *text, const char *file) {
    char *path = mem_printf("%s/%s", manual->folder, file);
    bool ok = output_text_end(text, path);
    free(path);
    return ok;
}

static void read_command(void *user, const char *name, const struct arguments *read,
                         const struct option *table, const void *values) {
    struct manual *manual = user;
    const struct command command = {name, read, table, values};
    man_page_write_command(manual->page.stream, &command);
    bash_write_command(manual->completions.stream, &command);
}

static void read_modes(const struct subcommand *bench) {
    for (const struct bench_mode *const *mode = bench_modes; *mode; mode++) {
        char name[] = "bench", mode_name[32], *words[] = {name, mode_name, NULL};
        snprintf(mode_name, sizeof mode_name, "%s", (*mode)->name);
        bench->run(2, words);
    }
}

/* The subcommands give their tables away as they would parse them. */
static void read_tables(struct manual *manual, const struct subcommand *subcommand) {
    char name[32], *words[] = {name, NULL};
    snprintf(name, sizeof name, "%s", subcommand->name);
    arguments_set_reader(read_command, manual);
    if (subcommand->run == app_bench)
        read_modes(subcommand);
    else
        subcommand->run(1, words);
    arguments_set_reader(NULL, NULL);
}

static bool write_page(struct manual *manual, const struct subcommand *subcommand) {
    char *file = mem_printf("manylight-%s.1", subcommand->name);
    output_text_init(&manual->page);
    man_page_begin(manual->page.stream, subcommand->name, subcommand->help);
    read_tables(manual, subcommand);
    man_page_end(manual->page.stream, subcommand->name);
    bool ok = write_text(manual, &manual->page, file);
    free(file);
    return ok;
}

static bool write_overview(struct manual *manual) {
    output_text_init(&manual->page);
    man_page_write_overview(manual->page.stream);
    return write_text(manual, &manual->page, "manylight.1");
}

static bool write_all(struct manual *manual) {
    output_text_init(&manual->completions);
    bash_begin(manual->completions.stream);
    bool ok = write_overview(manual);
    for (const struct subcommand *s = subcommands; ok && s->name; s++)
        ok = !s->run || write_page(manual, s);
    bash_end(manual->completions.stream);
    ok = ok && write_text(manual, &manual->completions, "manylight.bash");
    output_text_free(&manual->completions);
    return ok;
}

int app_manual(int argc, char **argv) {
    struct values values = {0};
    int status, count;
    if (!arguments_parse(&arguments, &values, argc, argv, NULL, &count, &status))
        return status;
    if (!values.output) {
        error_set("-o FOLDER is missing");
        return arguments_misuse(argv[0]);
    }
    char *folder = output_folder_begin(values.output);
    struct manual manual = {.folder = folder};
    bool ok = folder && output_folder_end(folder, values.output, write_all(&manual));
    return ok ? STATUS_OK : arguments_fail(argv[0]);
}
