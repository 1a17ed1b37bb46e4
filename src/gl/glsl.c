#include "gl/glsl.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "gl/glsl_embedded.h"

#include <stdio.h>
#include <string.h>

/* A setting of the process, as the log level is: which text the names below stand for. */
static const char *source_folder;

void glsl_set_folder(const char *folder) {
    source_folder = folder;
}

/* Shaders lie beside the C that draws with them, in src/; what many include lies in glsl/. */
static char *path_of(const char *name) {
    bool common = strncmp(name, "shared/", 7) == 0 || strncmp(name, "lib/", 4) == 0;
    bool rooted = strchr(name, '/') == NULL;
    return mem_printf("%s%s/%s", source_folder, common || rooted ? "" : "/../src", name);
}

static char *read_file(const char *name) {
    if (source_folder) {
        char *path = path_of(name), *text = file_read_text(path);
        free(path);
        return text;
    }
    for (const struct glsl_file *file = glsl_embedded; file->name; file++)
        if (strcmp(file->name, name) == 0)
            return mem_strdup(file->text);
    error_set("no shader file '%s' is embedded", name);
    return NULL;
}

/* Line n of file f is told to drivers as line f * LINES_PER_FILE + n of one file: #line's own
 * source number is lost in Mesa's messages about all but syntax. */
enum { LINES_PER_FILE = 100000 };

/* Whether the line may end a group that the compiler skips, and skips #line in as well. */
static bool ends_group(const char *line) {
    line += strspn(line, " \t");
    if (*line++ != '#')
        return false;
    line += strspn(line, " \t");
    return strncmp(line, "el", 2) == 0 || strncmp(line, "endif", 5) == 0;
}

/* A source in the making. */
struct writer {
    struct glsl_source *source;
    struct text text;
    bool open[GLSL_FILES_MAX]; /* the file is begun and not ended */
};

static const char *next_define(const char *define) {
    define += strcspn(define, ";");
    return define + (*define == ';');
}

/* Returns true and the file for #include "FILE". Ignores <FILE> of shared headers. */
static bool parse_include(const char *line, char *file, size_t size) {
    static const char directive[] = "#include \"";
    if (strncmp(line, directive, sizeof directive - 1) != 0)
        return false;
    line += sizeof directive - 1;
    snprintf(file, size, "%.*s", (int)strcspn(line, "\"\n"), line);
    return true;
}

static void tell_place(struct writer *writer, int file, int line) {
    text_print(&writer->text, "#line %d\n", file * LINES_PER_FILE + line);
}

/* The file's number, by the order of first lines; -1: there are too many. */
static int number_of(struct glsl_source *source, const char *name) {
    for (int i = 0; i < source->file_count; i++)
        if (strcmp(source->files[i], name) == 0)
            return i;
    if (source->file_count == GLSL_FILES_MAX) {
        error_set("more than %d shader files in one", GLSL_FILES_MAX);
        return -1;
    }
    source->files[source->file_count] = mem_strdup(name);
    return source->file_count++;
}

static bool write_file(struct writer *writer, const char *name);

static bool write_lines(struct writer *writer, int number, const char *text) {
    const char *name = writer->source->files[number];
    int line_number = 0;
    for (const char *line = text, *end; *line; line = end) {
        line_number++;
        end = line + strcspn(line, "\n");
        end += *end == '\n';
        char included[128];
        bool includes = parse_include(line, included, sizeof included);
        if (includes && !write_file(writer, included))
            return error_prefix("%s:%d", name, line_number);
        if (!includes)
            text_append(&writer->text, line, (size_t)(end - line));
        if (includes || ends_group(line))
            tell_place(writer, number, line_number + 1);
    }
    return true;
}

/* A file is written wherever it is included, for the compiler to skip all but the first that no
 * #if hides: what the loader reads it cannot know. */
static bool write_file(struct writer *writer, const char *name) {
    int number = number_of(writer->source, name);
    if (number < 0 || writer->open[number])
        return number >= 0;
    char *text = read_file(name);
    if (!text)
        return false;
    writer->open[number] = true;
    text_print(&writer->text, "#ifndef INCLUDED_%d // %s\n#define INCLUDED_%d\n", number, name,
               number);
    tell_place(writer, number, 1);
    bool ok = write_lines(writer, number, text);
    text_print(&writer->text, "#endif\n");
    writer->open[number] = false;
    free(text);
    return ok;
}

bool glsl_load(struct glsl_source *source, const char *file, const char *defines) {
    *source = (struct glsl_source){0};
    struct writer writer = {.source = source};
    text_print(&writer.text, "#version 450 core\n");
    for (const char *define = defines ? defines : ""; *define; define = next_define(define))
        text_print(&writer.text, "#define %.*s\n", (int)strcspn(define, ";"), define);
    bool ok = write_file(&writer, file);
    source->text = writer.text.data;
    if (!ok)
        glsl_free(source);
    return ok;
}

void glsl_free(struct glsl_source *source) {
    free(source->text);
    for (int i = 0; i < source->file_count; i++)
        free(source->files[i]);
    *source = (struct glsl_source){0};
}

/* The line number in a driver's message, which begins with "0:17(5): error", "0(17) : error" or
 * "ERROR: 0:17:", and what follows it; -1 where there is none. */
static int parse_place(const char *line, const char **rest) {
    int source, number, length = 0;
    line += strncmp(line, "ERROR: ", 7) == 0 ? 7 : 0;
    if (sscanf(line, "%d:%d%n", &source, &number, &length) == 2)
        *rest = line + length;
    else if (sscanf(line, "%d(%d)%n", &source, &number, &length) == 2 && length)
        *rest = line + length;
    else
        return -1;
    return number;
}

char *glsl_explain(const struct glsl_source *source, const char *message) {
    struct text explained = {0};
    text_append(&explained, "", 0);
    for (const char *line = message, *end; *line; line = end) {
        end = line + strcspn(line, "\n");
        end += *end == '\n';
        const char *rest;
        int number = parse_place(line, &rest), file = number / LINES_PER_FILE;
        if (number >= 0 && file < source->file_count) {
            text_print(&explained, "%s:%d", source->files[file], number % LINES_PER_FILE);
            line = rest;
        }
        text_append(&explained, line, (size_t)(end - line));
    }
    return explained.data;
}
