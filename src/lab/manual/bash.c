/* Completions for bash. A function of each command answers by the word before the cursor. */
#include "lab/manual/bash.h"
#include "lab/manual/value.h"

#include "apps/subcommands.h"
#include "lab/bench/bench.h"

#include <string.h>

/* "bench times" as a part of a function's name: "bench_times". */
static void put_function_name(FILE *out, const char *name) {
    for (; *name; name++)
        fputc(*name == ' ' ? '_' : *name, out);
}

/* --- what all commands use -------------------------------------------------------------------- */

/* The words are split anew: bash splits KEY=VALUE at "=", and puts only what follows it in place.
 * Without -r, read takes "a\\ b" as one word. File names in quotes are left to bash. */
static const char helpers[] =
    "_manylight_words() {\n"
    "    COMPREPLY=($(compgen -W \"$1\" -- \"$cur\"))\n"
    "    [[ $COMP_WORDBREAKS == *=* ]] || COMPREPLY=(\"${COMPREPLY[@]/#/$head}\")\n"
    "}\n\n"
    "_manylight_files() {\n"
    "    if [[ $line == *[\\\"\\']* ]]; then\n"
    "        compopt -o default 2>/dev/null\n"
    "        return\n"
    "    fi\n"
    "    compopt -o filenames 2>/dev/null\n"
    "    mapfile -t COMPREPLY < <(compgen \"${1:--f}\" -- \"$cur\")\n"
    "}\n\n";

static void put_case(FILE *out, const char *name, const char *words) {
    fprintf(out, "    %s=*)\n        head=${head}%s= cur=${cur#*=}\n", name, name);
    if (*words)
        fprintf(out, "        _manylight_words \"%s\" ;;\n", words);
    else
        fprintf(out, "        ;;\n");
}

static void put_key(FILE *out, const char *name, const char *words) {
    (void)words;
    fprintf(out, " %s=", name);
}

void bash_begin(FILE *out) {
    fprintf(out, "# Completions of manylight for bash, made by manylight manual.\n\n%s", helpers);
    fprintf(out, "_manylight_settings() {\n    case $cur in\n");
    value_each_setting(out, put_case);
    fprintf(out, "    *)\n        compopt -o nospace 2>/dev/null\n        _manylight_words \"");
    value_each_setting(out, put_key);
    fprintf(out, "\" ;;\n    esac\n}\n\n");
}

/* --- a command -------------------------------------------------------------------------------- */

static void write_option(FILE *out, const struct option *option) {
    struct value value = value_of_option(option);
    if (value.kind != VALUE_NONE) {
        fprintf(out, "    --%s", option->name);
        if (option->letter)
            fprintf(out, " | -%c", option->letter);
        fprintf(out, ")\n");
    }
    if (value.kind == VALUE_WORDS)
        fprintf(out, "        _manylight_words \"%s\"\n", value.words.data);
    else if (value.kind == VALUE_FILE)
        fprintf(out, "        _manylight_files -f\n");
    else if (value.kind == VALUE_FOLDER)
        fprintf(out, "        _manylight_files -d\n");
    else if (value.kind == VALUE_SETTING)
        fprintf(out, "        _manylight_settings\n");
    if (value.kind != VALUE_NONE)
        fprintf(out, "        return ;;\n");
    value_free(&value);
}

void bash_write_command(FILE *out, const struct command *command) {
    fprintf(out, "_manylight_");
    put_function_name(out, command->name);
    fprintf(out, "() {\n    case $previous in\n");
    for (const struct option *o = command->table; o->name; o++)
        write_option(out, o);
    fprintf(out, "    esac\n    if [[ $cur == -* ]]; then\n        _manylight_words \"");
    for (const struct option *o = command->table; o->name; o++)
        fprintf(out, o->letter ? " --%s -%c" : " --%s", o->name, o->letter);
    fprintf(out, "\"\n    else\n        _manylight_files -f\n    fi\n}\n\n");
}

/* --- all of it -------------------------------------------------------------------------------- */

static const char dispatch[] =
    "    local line=${COMP_LINE:0:COMP_POINT} cur previous head= function\n"
    "    local -a words\n"
    "    read -a words <<<\"$line\"\n"
    "    [[ $line == *[[:space:]] && $line != *\\\\[[:space:]] ]] && words+=(\"\")\n"
    "    COMPREPLY=()\n"
    "    cur=${words[${#words[@]} - 1]} previous=${words[${#words[@]} - 2]}\n"
    "    if [[ $cur == --*=* ]]; then\n"
    "        previous=${cur%%=*} head=${cur%%=*}= cur=${cur#*=}\n"
    "    fi\n"
    "    if ((${#words[@]} < 3)); then\n"
    "        _manylight_words \"$commands\"\n"
    "        return\n"
    "    fi\n"
    "    function=_manylight_${words[1]}\n"
    "    if [[ ${words[1]} == bench ]]; then\n"
    "        if ((${#words[@]} < 4)); then\n"
    "            _manylight_words \"$modes\"\n"
    "            return\n"
    "        fi\n"
    "        function+=_${words[2]}\n"
    "    fi\n"
    "    declare -F \"$function\" >/dev/null && \"$function\"\n"
    "}\n\n"
    "complete -F _manylight manylight\n";

void bash_end(FILE *out) {
    fprintf(out, "_manylight() {\n    local commands=\"--help --version");
    for (const struct subcommand *s = subcommands; s->name; s++)
        fprintf(out, " %s", s->name);
    fprintf(out, "\"\n    local modes=\"--help");
    for (const struct bench_mode *const *mode = bench_modes; *mode; mode++)
        fprintf(out, " %s", (*mode)->name);
    fprintf(out, "\"\n%s", dispatch);
}
