/* Completions for zsh: a function of each command calls _arguments with a row of each option. */
#include "apps/manual/shells.h"
#include "apps/manual/value.h"

#include "apps/bench/bench.h"
#include "apps/subcommands.h"

#include <stdlib.h>
#include <string.h>

/* Text of a row in single quotes, where brackets and colons have a meaning. */
static void put_escaped(FILE *out, const char *text) {
    for (; *text; text++)
        if (*text == '\'')
            fprintf(out, "'\\''");
        else
            fprintf(out, strchr("[]:\\", *text) ? "\\%c" : "%c", *text);
}

static void put_case(FILE *out, const char *name, const char *words) {
    if (*words)
        fprintf(out, "        %s) compadd -- %s ;;\n", name, words);
}

static void put_key(FILE *out, const char *name, const char *words) {
    (void)words;
    fprintf(out, " %s", name);
}

static void begin(FILE *out) {
    fprintf(out, "#compdef manylight\n"
                 "# Completions of manylight for zsh, made by manylight manual.\n\n"
                 "_manylight_settings() {\n"
                 "    local key=${PREFIX%%%%=*}\n"
                 "    if compset -P 1 '*='; then\n"
                 "        case $key in\n");
    value_each_setting(out, put_case);
    fprintf(out, "        esac\n    else\n        compadd -S = -q --");
    value_each_setting(out, put_key);
    fprintf(out, "\n    fi\n}\n\n");
}

static void put_action(FILE *out, const struct option *option) {
    struct value value = value_of_option(option);
    fprintf(out, ":");
    put_escaped(out, option_value_word(option));
    if (value.kind == VALUE_WORDS)
        fprintf(out, ":(%s)", value.words.data);
    else
        fprintf(out, ":%s",
                value.kind == VALUE_FILE      ? "_files"
                : value.kind == VALUE_FOLDER  ? "_files -/"
                : value.kind == VALUE_SETTING ? "_manylight_settings"
                                              : "");
    value_free(&value);
}

/* "*" lets an option come again; "=" lets a value follow that sign or in a word of its own. */
static void put_row(FILE *out, const struct option *option, const char *name) {
    bool has_value = option->type != OPTION_FLAG;
    char *help = value_short_help(option);
    fprintf(out, " \\\n        '%s%s%s[", option->type == OPTION_LIST ? "*" : "", name,
            !has_value       ? ""
            : name[1] == '-' ? "="
                             : "+");
    put_escaped(out, help);
    fprintf(out, "]");
    if (has_value)
        put_action(out, option);
    fprintf(out, "'");
    free(help);
}

static void write_command(FILE *out, const struct command *command) {
    fprintf(out, "_manylight_%s() {\n    _arguments -s -S", shell_function_name(command));
    for (const struct option *o = command->table; o->name; o++) {
        char name[64];
        snprintf(name, sizeof name, "--%s", o->name);
        put_row(out, o, name);
        if (o->letter) {
            snprintf(name, sizeof name, "-%c", o->letter);
            put_row(out, o, name);
        }
    }
    fprintf(out, " \\\n        '*:file:_files'\n}\n\n");
}

static void end(FILE *out) {
    fprintf(out, "_manylight_bench() {\n"
                 "    if ((CURRENT == 2)); then\n        compadd -- --help");
    for (const struct bench_mode *const *mode = bench_modes; *mode; mode++)
        fprintf(out, " %s", (*mode)->name);
    fprintf(out, "\n    elif (($+functions[_manylight_bench_$words[2]])); then\n"
                 "        local mode=$words[2]\n"
                 "        shift words\n        ((CURRENT--))\n"
                 "        _manylight_bench_$mode\n    fi\n}\n\n"
                 "_manylight() {\n"
                 "    local -a commands=(\n");
    for (const struct subcommand *s = subcommands; s->name; s++) {
        fprintf(out, "        '%s:", s->name);
        put_escaped(out, s->help);
        fprintf(out, "'\n");
    }
    fprintf(out, "    )\n"
                 "    if ((CURRENT == 2)); then\n"
                 "        _describe command commands\n"
                 "        compadd -- --help --version\n"
                 "    elif (($+functions[_manylight_$words[2]])); then\n"
                 "        local command=$words[2]\n"
                 "        shift words\n        ((CURRENT--))\n"
                 "        _manylight_$command\n    fi\n}\n\n"
                 "_manylight \"$@\"\n");
}

const struct shell_writer zsh_writer = {"_manylight", begin, write_command, end};
