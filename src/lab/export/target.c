#include "lab/export/target.h"

#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

char *export_path(const struct export_target *target, const char *name) {
    return mem_printf("%s/%s", target->folder, name);
}

/* XML ends a comment at two hyphens. */
static void add_comment(struct text *text, const char *line, size_t length) {
    for (size_t i = 0; i < length; i++) {
        text_append(text, &line[i], 1);
        if (line[i] == '-' && line[i + 1] == '-')
            text_append(text, " ", 1);
    }
}

static void add_comments(struct text *text, const struct export_target *target, const char *before,
                         const char *after) {
    for (const char *line = target->notes.data; line && *line; line += strcspn(line, "\n") + 1) {
        text_print(text, "%s", before);
        add_comment(text, line, strcspn(line, "\n"));
        text_print(text, "%s\n", after);
    }
}

bool export_write(const struct export_target *target, const char *name, const char *before,
                  const char *after, const struct text *body) {
    struct text all = {0};
    char *path = export_path(target, name);
    add_comments(&all, target, before, after);
    text_append(&all, body->data, body->length);
    bool ok = output_file_write(path, all.data, all.length);
    mem_free(all.data, path);
    return ok;
}

void export_note(struct export_target *target, const char *format, ...) {
    char line[512];
    va_list args;
    va_start(args, format);
    vsnprintf(line, sizeof line - 1, format, args);
    va_end(args);
    strncat(line, "\n", sizeof line - strlen(line) - 1);
    if (target->notes.data && strstr(target->notes.data, line))
        return;
    text_print(&target->notes, "%s", line);
    log_note("%.*s", (int)strcspn(line, "\n"), line);
}

bool export_is_diffuse(const struct export_target *target, const struct material *material) {
    return target->materials == MATERIALS_DIFFUSE || material_is_diffuse(material);
}
