/* Completions for fish: a line of each option. */
#include "apps/manual/shells.h"
#include "apps/manual/value.h"

#include "apps/bench/bench.h"
#include "apps/subcommands.h"
#include "base/words.h"

#include <stdlib.h>
#include <string.h>

/* In single quotes, of which a backslash escapes the next. */
static void put_quoted(FILE *out, const char *text) {
    fputc('\'', out);
    for (; *text; text++)
        fprintf(out, strchr("'\\", *text) ? "\\%c" : "%c", *text);
    fputc('\'', out);
}

/* A word for the key, and one for each value that is a word. */
static void put_words(FILE *out, const char *name, const char *words) {
    fprintf(out, "        %s=", name);
    for (struct word word = {.at = words}; word_next(&word);)
        fprintf(out, " %s=%.*s", name, word.length, word.at);
    fprintf(out, " \\\n");
}

static const char helpers[] =
    "# Whether the command line begins with these words after the program.\n"
    "function __manylight_in\n"
    "    set -l words (commandline -opc)\n"
    "    set -l last (math 1 + (count $argv))\n"
    "    test (count $words) -ge $last\n"
    "    and test \"$words[2..$last]\" = \"$argv\"\n"
    "end\n\n"
    "function __manylight_is_first\n"
    "    test (count (commandline -opc)) -eq $argv[1]\n"
    "end\n\n";

static void begin(FILE *out) {
    fprintf(out,
            "# Completions of manylight for fish, made by manylight manual.\n\n%s"
            "function __manylight_settings\n    printf '%%s\\n' \\\n",
            helpers);
    value_each_setting(out, put_words);
    fprintf(out, "        path=\nend\n\n"
                 "complete -c manylight -n '__manylight_is_first 1' -f -l version -d 'print the "
                 "version'\n"
                 "complete -c manylight -n '__manylight_is_first 1' -f -l help -d 'print help'\n");
    for (const struct subcommand *s = subcommands; s->name; s++) {
        fprintf(out, "complete -c manylight -n '__manylight_is_first 1' -f -a %s -d ", s->name);
        put_quoted(out, s->help);
        fputc('\n', out);
    }
    for (const struct bench_mode *const *mode = bench_modes; *mode; mode++) {
        fprintf(out,
                "complete -c manylight -n '__manylight_is_first 2; and __manylight_in bench' -f "
                "-a %s\n",
                (*mode)->name);
    }
}

static void write_option(FILE *out, const struct command *command, const struct option *option) {
    struct value value = value_of_option(option);
    char *help = value_short_help(option);
    fprintf(out, "complete -c manylight -n '__manylight_in %s' -l %s", command->name, option->name);
    if (option->letter)
        fprintf(out, " -s %c", option->letter);
    if (value.kind == VALUE_WORDS)
        fprintf(out, " -x -a '%s'", value.words.data);
    else if (value.kind == VALUE_FILE)
        fprintf(out, " -r -F");
    else if (value.kind == VALUE_FOLDER)
        fprintf(out, " -x -a '(__fish_complete_directories)'");
    else if (value.kind == VALUE_SETTING)
        fprintf(out, " -x -a '(__manylight_settings)'");
    else if (value.kind == VALUE_FREE)
        fprintf(out, " -x");
    fprintf(out, " -d ");
    put_quoted(out, help);
    fputc('\n', out);
    free(help);
    value_free(&value);
}

static void write_command(FILE *out, const struct command *command) {
    fprintf(out, "\n# %s\n", command->name);
    for (const struct option *o = command->table; o->name; o++)
        write_option(out, command, o);
}

static void end(FILE *out) {
    (void)out;
}

const struct shell_writer fish_writer = {"manylight.fish", begin, write_command, end};
