#define _XOPEN_SOURCE 700
#include "viewer/files/recent.h"

#include "base/file/file.h"
#include "base/file/folder.h"
#include "base/file/output_file.h"
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* NULL: the user has no folder for it. */
static char *list_path(void) {
    char *folder = folder_of_user("XDG_STATE_HOME", ".local/state");
    char *path = folder ? mem_printf("%s/recent", folder) : NULL;
    free(folder);
    return path;
}

void recent_read(struct recent *recent) {
    char *path = list_path(), *text = path ? file_read_text(path) : NULL;
    recent_free(recent);
    for (char *line = text; line && *line && recent->count < RECENT_MAX;) {
        size_t length = strcspn(line, "\n");
        char *rest = line + length + (line[length] == '\n');
        line[length] = '\0';
        if (access(line, R_OK) == 0)
            recent->paths[recent->count++] = mem_strdup(line);
        line = rest;
    }
    free(text);
    free(path);
}

static void write_list(const struct recent *recent) {
    char *path = list_path();
    struct output_text text;
    if (path && folder_make_for(path)) {
        output_text_init(&text);
        for (int i = 0; i < recent->count; i++)
            fprintf(text.stream, "%s\n", recent->paths[i]);
        output_text_end(&text, path);
    }
    free(path);
}

void recent_add(struct recent *recent, const char *path) {
    char *whole = realpath(path, NULL);
    if (!whole || strchr(whole, '\n')) {
        free(whole);
        return;
    }
    int at = 0;
    while (at < recent->count && strcmp(recent->paths[at], whole) != 0)
        at++;
    if (at == RECENT_MAX)
        at--;
    if (at < recent->count)
        free(recent->paths[at]);
    else
        recent->count++;
    memmove(recent->paths + 1, recent->paths, (size_t)at * sizeof *recent->paths);
    recent->paths[0] = whole;
    write_list(recent);
}

void recent_free(struct recent *recent) {
    for (int i = 0; i < recent->count; i++)
        free(recent->paths[i]);
    *recent = (struct recent){0};
}
