#include "gl/glsl.h"

#include "base/error.h"
#include "base/memory.h"
#include "gl/glsl_embedded.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A setting of the process, as the log level is: which text the names below stand for. */
static const char *source_folder;

void glsl_set_folder(const char *folder) {
    source_folder = folder;
}

static char *read_whole(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file) {
        error_set("cannot open %s: %s", path, strerror(errno));
        return NULL;
    }
    char *text = NULL;
    size_t size = 0, got;
    do {
        text = mem_resize(text, size + 4096 + 1, 1);
        got = fread(text + size, 1, 4096, file);
        size += got;
    } while (got == 4096);
    text[size] = '\0';
    fclose(file);
    return text;
}

/* What belongs to one technique or direct method lies in its folder of src/. */
static char *path_of(const char *name) {
    bool owned = strncmp(name, "techniques/", 11) == 0 || strncmp(name, "direct/", 7) == 0;
    return mem_printf("%s%s/%s", source_folder, owned ? "/../src" : "", name);
}

static char *read_file(const char *name) {
    if (source_folder) {
        char *path = path_of(name), *text = read_whole(path);
        free(path);
        return text;
    }
    for (const struct glsl_file *file = glsl_embedded; file->name; file++)
        if (strcmp(file->name, name) == 0)
            return mem_strdup(file->text);
    error_set("no shader file '%s' is embedded", name);
    return NULL;
}

static void append(char **text, const char *more, size_t length) {
    size_t old = strlen(*text);
    *text = mem_resize(*text, old + length + 1, 1);
    memcpy(*text + old, more, length);
    (*text)[old + length] = '\0';
}

/* Line n of file f is told to drivers as line f * LINES_PER_FILE + n of one file: #line's own
 * source number is lost in Mesa's messages about all but syntax. */
enum { LINES_PER_FILE = 100000 };

static void append_line_directive(char **text, int line, int file) {
    char directive[48];
    int length = snprintf(directive, sizeof directive, "#line %d\n", file * LINES_PER_FILE + line);
    append(text, directive, (size_t)length);
}

/* Whether the line is #include "NAME"; NAME then goes into name. */
static bool parse_include(const char *line, char *name, size_t size) {
    static const char directive[] = "#include \"";
    if (strncmp(line, directive, sizeof directive - 1) != 0)
        return false;
    line += sizeof directive - 1;
    snprintf(name, size, "%.*s", (int)strcspn(line, "\"\n"), line);
    return true;
}

static bool expand(struct glsl_source *source, const char *name) {
    for (int i = 0; i < source->file_count; i++)
        if (strcmp(source->files[i], name) == 0)
            return true; /* once is enough: as #pragma once */
    if (source->file_count == GLSL_FILES_MAX)
        return error_set("more than %d shader files in one", GLSL_FILES_MAX);
    char *text = read_file(name);
    if (!text)
        return false;
    int number = source->file_count++, line_number = 0;
    source->files[number] = mem_strdup(name);
    append_line_directive(&source->text, 1, number);
    bool ok = true;
    for (const char *line = text, *end; ok && *line; line = end) {
        line_number++;
        end = line + strcspn(line, "\n");
        end += *end == '\n';
        char included[128];
        if (parse_include(line, included, sizeof included)) {
            ok = expand(source, included) || error_prefix("%s:%d", name, line_number);
            append_line_directive(&source->text, line_number + 1, number);
        } else {
            append(&source->text, line, (size_t)(end - line));
        }
    }
    free(text);
    return ok;
}

bool glsl_load(struct glsl_source *source, const char *file, const char *defines) {
    *source = (struct glsl_source){.text = mem_strdup("#version 450 core\n")};
    for (const char *define = defines ? defines : ""; *define;) {
        size_t length = strcspn(define, ";");
        append(&source->text, "#define ", 8);
        append(&source->text, define, length);
        append(&source->text, "\n", 1);
        define += length + (define[length] == ';');
    }
    if (expand(source, file))
        return true;
    glsl_free(source);
    return false;
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
    char *explained = mem_strdup("");
    for (const char *line = message, *end; *line; line = end) {
        end = line + strcspn(line, "\n");
        end += *end == '\n';
        const char *rest;
        int number = parse_place(line, &rest), file = number / LINES_PER_FILE;
        if (number >= 0 && file < source->file_count) {
            char *place = mem_printf("%s:%d", source->files[file], number % LINES_PER_FILE);
            append(&explained, place, strlen(place));
            free(place);
            line = rest;
        }
        append(&explained, line, (size_t)(end - line));
    }
    return explained;
}
