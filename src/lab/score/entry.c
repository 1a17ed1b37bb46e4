#define _DEFAULT_SOURCE
#include "lab/score/entry.h"

#include "base/error.h"
#include "base/memory.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_exr(const struct dirent *file) {
    size_t length = strlen(file->d_name);
    return file->d_name[0] != '.' && length > 4 && strcmp(file->d_name + length - 4, ".exr") == 0;
}

static bool read_size(const char *text, int size[2]) {
    int end = 0;
    return sscanf(text, "%5dx%5d%n", &size[0], &size[1], &end) == 2 && text[end] == '\0' &&
           size[0] > 0 && size[1] > 0;
}

static bool read_frame(const char *text, int *frame) {
    int end = 0;
    return sscanf(text, "%8d%n", frame, &end) == 1 && text[end] == '\0' && *frame >= 0;
}

/* Cuts the text at its last full stop; what follows, NULL where there is none. */
static char *cut_end(char *text) {
    char *stop = strrchr(text, '.');
    if (stop)
        *stop = '\0';
    return stop ? stop + 1 : NULL;
}

static bool parse_name(struct entry_picture *picture, const char *file) {
    char *scene = mem_strdup(file);
    int size[2] = {0}, frame = NO_FRAME;
    cut_end(scene); /* .exr */
    char *end = cut_end(scene);
    bool ok = end && read_size(end, size);
    if (end && !ok) {
        char *before = read_frame(end, &frame) ? cut_end(scene) : NULL;
        ok = before && read_size(before, size);
    }
    if (!ok || !*scene) {
        free(scene);
        return false;
    }
    *picture = (struct entry_picture){mem_strdup(file), scene, size[0], size[1], frame};
    return true;
}

bool entry_list(struct entry *entry, const char *folder) {
    *entry = (struct entry){0};
    struct dirent **files;
    int count = scandir(folder, &files, is_exr, alphasort);
    if (count < 0)
        return error_set("cannot read the folder %s: %s", folder, strerror(errno));
    entry->pictures = mem_alloc((size_t)count, sizeof *entry->pictures);
    entry->others = mem_alloc((size_t)count, sizeof *entry->others);
    for (int i = 0; i < count; i++) {
        if (parse_name(&entry->pictures[entry->count], files[i]->d_name))
            entry->count++;
        else
            entry->others[entry->other_count++] = mem_strdup(files[i]->d_name);
        free(files[i]);
    }
    free(files);
    return true;
}

void entry_free(struct entry *entry) {
    for (int i = 0; i < entry->count; i++) {
        mem_free(entry->pictures[i].file, entry->pictures[i].scene);
    }
    for (int i = 0; i < entry->other_count; i++)
        free(entry->others[i]);
    mem_free(entry->pictures, entry->others);
    *entry = (struct entry){0};
}

const struct entry_picture *entry_find(const struct entry *entry, const char *file) {
    for (int i = 0; i < entry->count; i++)
        if (strcmp(entry->pictures[i].file, file) == 0)
            return &entry->pictures[i];
    return NULL;
}
