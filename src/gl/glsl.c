#include "gl/glsl.h"

#include "base/error.h"
#include "base/memory.h"
#include "gl/glsl_embedded.h"

#include <ctype.h>
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

static char *read_file(const char *name) {
    if (source_folder) {
        char *path = mem_printf("%s/%s", source_folder, name), *text = read_whole(path);
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

static void append_line_directive(char **text, int line, int file) {
    char directive[48];
    int length = snprintf(directive, sizeof directive, "#line %d %d\n", line, file);
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

char *glsl_explain(const struct glsl_source *source, const char *message) {
    /* Drivers write "2:17(5): error" or "2(17) : error": a source number at the line's start. */
    char *explained = mem_strdup("");
    for (const char *line = message, *end; *line; line = end) {
        end = line + strcspn(line, "\n");
        end += *end == '\n';
        char *rest = (char *)line;
        long number = isdigit((unsigned char)*line) ? strtol(line, &rest, 10) : -1;
        if (number >= 0 && number < source->file_count && (*rest == ':' || *rest == '(')) {
            append(&explained, source->files[number], strlen(source->files[number]));
            line = rest;
        }
        append(&explained, line, (size_t)(end - line));
    }
    return explained;
}
