#include "lab/manual/man_page.h"

#include "apps/options.h"
#include "apps/subcommands.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "version.h"

#include <stdlib.h>
#include <string.h>

/* --- text ------------------------------------------------------------------------------------- */

/* The escape of a character that roff would set as another, or NULL. */
static const char *escape_of(char c) {
    static const char *const rows[] = {"-\\-", "\\\\e", "'\\(aq", "`\\(ga", "^\\(ha", "~\\(ti"};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (rows[i][0] == c)
            return rows[i] + 1;
    return NULL;
}

/* Characters that a user types, as they are. The number of bytes. */
static int put_word(FILE *out, const char *word, int length) {
    int bytes = 0;
    for (int i = 0; i < length; i++) {
        const char *escape = escape_of(word[i]);
        bytes += escape ? fprintf(out, "%s", escape) : fprintf(out, "%c", word[i]);
    }
    return bytes;
}

static void put(FILE *out, const char *text) {
    put_word(out, text, (int)strlen(text));
}

/* Whether roff would take a line for a request that begins so. */
static bool is_request(const char *line) {
    return *line == '.' || *line == '\'';
}

/* Lines as they are. */
static void put_lines(FILE *out, const char *text) {
    for (int length; *text; text += length) {
        length = (int)strcspn(text, "\n");
        length += text[length] == '\n';
        fprintf(out, is_request(text) ? "\\&" : "");
        put_word(out, text, length);
    }
}

/* Words in lines of their own length, as pages are checked for. */
static void put_filled(FILE *out, const char *text, int length) {
    enum { WIDTH = 72 };
    const char *end = text + length;
    for (int column = 0; text < end;) {
        int word = (int)strcspn(text, " \n");
        if (word > end - text)
            word = (int)(end - text);
        if (column > 0 && (column + word >= WIDTH || is_request(text))) {
            fputc('\n', out);
            column = 0;
        } else if (column > 0) {
            column += fprintf(out, " ");
        }
        column += is_request(text) ? fprintf(out, "\\&") : 0;
        column += put_word(out, text, word);
        text += word + strspn(text + word, " \n");
    }
    fputc('\n', out);
}

/* A line break before a space keeps its line as it is; other lines flow together. */
static void put_paragraphs(FILE *out, const char *text) {
    while (*text) {
        const char *end = text;
        bool indented = *text == ' ';
        while (*end && (*end == ' ') == indented) {
            end += strcspn(end, "\n");
            end += *end == '\n';
        }
        if (indented) {
            fprintf(out, ".nf\n");
            put_word(out, text, (int)(end - text));
            fprintf(out, end[-1] == '\n' ? ".fi\n" : "\n.fi\n");
        } else {
            put_filled(out, text, (int)(end - text));
        }
        text = end;
    }
}

/* --- rows ------------------------------------------------------------------------------------- */

static void put_help(FILE *out, const struct option *option) {
    char range[512];
    option_describe_range(option, range, sizeof range);
    char *text = mem_printf("%s%s%s%s", option->help, option->needs ? "; with " : "",
                            option->needs ? option->needs : "", range);
    put_filled(out, text, (int)strlen(text));
    free(text);
}

static void put_option(FILE *out, const struct option *option) {
    const char *word = option_value_word(option);
    fprintf(out, ".TP\n");
    if (option->letter)
        fprintf(out, "\\fB\\-%c\\fR, ", option->letter);
    fprintf(out, "\\fB\\-\\-");
    put(out, option->name);
    fprintf(out, "\\fR");
    if (*word) {
        fprintf(out, " \\fI");
        put(out, word);
        fprintf(out, "\\fR");
    }
    fputc('\n', out);
    put_help(out, option);
}

static void put_row(FILE *out, const char *name, const char *help) {
    fprintf(out, ".TP\n\\fB");
    put(out, name);
    fprintf(out, "\\fR\n");
    put_filled(out, help, (int)strlen(help));
}

/* --- settings --------------------------------------------------------------------------------- */

static void put_techniques(FILE *out) {
    fprintf(out, ".SH TECHNIQUES\nValues of\n.BR \\-\\-technique :\n");
    for (const struct technique *const *t = techniques; *t; t++)
        put_row(out, (*t)->name, (*t)->help);
    fprintf(out, ".SH DIRECT LIGHT\nValues of\n.BR \\-\\-direct :\n");
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        put_row(out, (*d)->name, (*d)->help);
}

static void put_presets(FILE *out) {
    fprintf(out, ".SH PRESETS\nOther settings override them.\n");
    for (const struct technique *const *t = techniques; *t; t++)
        for (const struct preset *p = (*t)->presets; p && p->name; p++) {
            char *name = mem_printf("path=%s (%s)", p->name, (*t)->name);
            put_row(out, name, p->help);
            free(name);
        }
}

static void put_settings(FILE *out) {
    struct settings settings;
    renderer_settings_init(&settings);
    fprintf(out, ".SH SETTINGS\nNames for\n.BI \\-\\-set\\  NAME=VALUE\\fR.\n"
                 "A name's last word suffices if no other name has it.\n"
                 "Brackets hold the default and the range.\n");
    for (int i = 0; i < settings.part_count; i++) {
        const struct settings_part *part = settings.parts[i];
        fprintf(out, ".SS ");
        put(out, part->title);
        fputc('\n', out);
        for (const struct option *o = part->table; o->name; o++) {
            char name[SETTING_NAME_SIZE];
            setting_name(&(struct setting){part, o}, name);
            fprintf(out, ".TP\n\\fB");
            put(out, name);
            fprintf(out, "\\fR\n");
            put_help(out, o);
        }
    }
}

/* --- pages ------------------------------------------------------------------------------------ */

static void put_title(FILE *out, const char *name, const char *help) {
    fprintf(out, ".\\\" Made by manylight manual: change the help of the program, not this page.\n"
                 ".TH \"MANYLIGHT");
    for (const char *c = name; *c; c++)
        fputc(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c, out);
    fprintf(out, "\" 1 %s \"manylight %s\" \"User Commands\"\n", MANYLIGHT_DATE, MANYLIGHT_VERSION);
    fprintf(out, ".SH NAME\nmanylight");
    put(out, name);
    fprintf(out, " \\- ");
    put(out, help);
    fputc('\n', out);
}

void man_page_begin(FILE *out, const char *name, const char *help) {
    char *full = mem_printf("-%s", name);
    put_title(out, full, help);
    free(full);
    if (strcmp(name, "bench") == 0)
        fprintf(out, ".SH DESCRIPTION\nMeasures times and errors of frames.\n"
                     "Each mode has its own options.\n");
}

/* Of a mode of bench all is in one section of the mode's name. */
static void put_heading(FILE *out, const struct command *command, const char *title) {
    bool is_mode = strchr(command->name, ' ');
    fprintf(out, is_mode ? ".PP\n" : ".SH %s\n", title);
}

static void put_more(FILE *out, const struct command *command) {
    struct output_text more;
    output_text_init(&more);
    command->arguments->print_more(more.stream, command->values);
    if (fflush(more.stream) == 0) {
        put_heading(out, command, "NOTES");
        fprintf(out, ".nf\n");
        put_lines(out, *more.data == '\n' ? more.data + 1 : more.data);
        fprintf(out, ".fi\n");
    }
    output_text_free(&more);
}

/* The first line of a mode is a title, without a full stop. */
static void put_summary(FILE *out, const struct command *command) {
    const char *summary = command->arguments->summary;
    size_t title = strchr(command->name, ' ') ? strcspn(summary, "\n") : 0;
    if (summary[title] == '\n') {
        put_filled(out, summary, (int)title);
        fprintf(out, ".PP\n");
        title++;
    }
    put_paragraphs(out, summary + (summary[title] ? title : 0));
}

void man_page_write_command(FILE *out, const struct command *command) {
    const struct arguments *arguments = command->arguments;
    bool has_settings = option_find(command->table, "set"),
         is_render = strcmp(command->name, "render") == 0;
    if (strchr(command->name, ' '))
        fprintf(out, ".SH \"MODE %s\"\n", strchr(command->name, ' ') + 1);
    else
        fprintf(out, ".SH SYNOPSIS\n");
    fprintf(out, ".B manylight ");
    put(out, command->name);
    fputc('\n', out);
    put(out, arguments->synopsis);
    fputc('\n', out);
    put_heading(out, command, "DESCRIPTION");
    put_summary(out, command);
    if (!strchr(command->name, ' '))
        put_heading(out, command, "OPTIONS");
    for (const struct option *o = command->table; o->name; o++)
        put_option(out, o);
    if (is_render) {
        put_techniques(out);
        put_presets(out);
        put_settings(out);
    } else if (has_settings) {
        put_heading(out, command, "SETTINGS");
        fprintf(out, "The page\n.BR manylight\\-render (1)\nlists techniques and settings.\n");
    }
    if (arguments->print_more && !option_find(command->table, "direct"))
        put_more(out, command);
}

/* Every page but its own. */
static void put_see_also(FILE *out, const char *own) {
    fprintf(out, ".SH SEE ALSO\n");
    if (*own)
        fprintf(out, ".BR manylight (1),\n");
    const char *before = NULL;
    for (const struct subcommand *s = subcommands; s->name; s++) {
        if (strcmp(s->name, own) == 0)
            continue;
        if (before)
            fprintf(out, ".BR manylight\\-%s (1),\n", before);
        before = s->name;
    }
    fprintf(out, ".BR manylight\\-%s (1)\n", before);
}

void man_page_end(FILE *out, const char *name) {
    fprintf(out, ".SH EXIT STATUS\n0: done; 1: failed, with a message on standard error; 2: wrong "
                 "usage.\n");
    put_see_also(out, name);
}

void man_page_write_overview(FILE *out) {
    put_title(out, "", "renders real-time global illumination by many lights");
    fprintf(out, ".SH SYNOPSIS\n.B manylight\nSUBCOMMAND ...\n.br\n"
                 ".B manylight \\-\\-version\n"
                 ".SH DESCRIPTION\nRenders scenes in glTF with direct and indirect light, and\n"
                 "measures the result against its own path tracer.\n"
                 ".SH SUBCOMMANDS\n");
    for (const struct subcommand *s = subcommands; s->name; s++)
        put_row(out, s->name, s->help);
    fprintf(out, ".SH ENVIRONMENT\n");
    put_row(out, "XDG_CACHE_HOME", "folder of cached references [~/.cache]");
    man_page_end(out, "");
}
