#define _XOPEN_SOURCE 700
#include "scene/gltf/file.h"

#include "base/error.h"
#include "base/memory.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char file_no_folder[] = "-";

/* Whether the name is a path downward: not absolute, no URL, no "..". */
static bool leads_down(const char *name) {
    if (!*name || *name == '/' || *name == '\\' || strchr(name, ':'))
        return false;
    for (const char *part = name;; part++) {
        size_t length = strcspn(part, "/\\");
        if (length == 2 && part[0] == '.' && part[1] == '.')
            return false;
        part += length;
        if (!*part)
            return true;
    }
}

/* The name for messages: shortened, and without what could upset a terminal. */
static const char *shown(char text[80], const char *name) {
    snprintf(text, 80, "%s", name);
    for (char *c = text; *c; c++)
        if ((unsigned char)*c < 32 || *c == 127)
            *c = '?';
    return text;
}

char *file_find_named(const char *folder, const char *name) {
    char text[80];
    if (strcmp(folder, file_no_folder) == 0) {
        error_set("cannot find '%s': the scene came through a pipe, which has no folder; give the "
                  "scene's path, or a .glb that holds all",
                  shown(text, name));
        return NULL;
    }
    if (!leads_down(name)) {
        error_set("'%s' is not a path inside the file's folder", shown(text, name));
        return NULL;
    }
    char *path = mem_printf("%s%s", folder, name);
    char *root = realpath(*folder ? folder : ".", NULL), *real = realpath(path, NULL);
    bool good = false;
    size_t length = root ? strlen(root) : 0;
    if (!root || !real)
        error_set("cannot open %s%s: %s", folder, shown(text, name), strerror(errno));
    else if (strncmp(root, real, length) != 0 || (length > 1 && real[length] != '/'))
        error_set("'%s' is a link out of the file's folder", shown(text, name));
    else
        good = true;
    if (!good)
        free(path);
    free(root);
    free(real);
    return good ? path : NULL;
}

bool file_read_named(struct file_bytes *bytes, const char *folder, const char *name) {
    *bytes = (struct file_bytes){0};
    char *path = file_find_named(folder, name);
    bool good = path && file_read(bytes, path);
    free(path);
    return good;
}

static uint32_t word_at(const struct file_bytes *bytes, size_t at) {
    uint32_t word;
    memcpy(&word, bytes->data + at, sizeof word);
    return word;
}

bool glb_is(const struct file_bytes *bytes) {
    return bytes->size >= 4 && memcmp(bytes->data, "glTF", 4) == 0;
}

/* glTF 2.0, 4.4: a header of 12 bytes, then chunks of length, type and data: JSON, then BIN, then
 * any others. tinygltf would read beyond the end of a truncated chunk. */
bool glb_check(const struct file_bytes *bytes, struct glb_chunks *chunks) {
    enum { JSON = 0x4E4F534A, BIN = 0x004E4942 };
    if (bytes->size < 20)
        return error_set("truncated: %zu bytes are no GLB file", bytes->size);
    if (word_at(bytes, 4) != 2)
        return error_set("GLB version %u, not 2", word_at(bytes, 4));
    if (word_at(bytes, 8) != bytes->size)
        return error_set("%s: the header says %u bytes, there are %zu",
                         word_at(bytes, 8) > bytes->size ? "truncated" : "wrong length",
                         word_at(bytes, 8), bytes->size);
    *chunks = (struct glb_chunks){.json = (const char *)bytes->data + 20};
    size_t at = 12;
    for (int chunk = 0; at < bytes->size; chunk++) {
        if (bytes->size - at < 8)
            return error_set("chunk %d: its header is truncated", chunk);
        uint32_t size = word_at(bytes, at), type = word_at(bytes, at + 4);
        size_t left = bytes->size - at - 8;
        if (size > left)
            return error_set("chunk %d: %u bytes, but only %zu are left", chunk, size, left);
        if (size % 4 != 0)
            return error_set("chunk %d: %u bytes are not a multiple of 4", chunk, size);
        if (chunk < 2 && type != (chunk == 0 ? (uint32_t)JSON : (uint32_t)BIN))
            return error_set("chunk %d: type 0x%08X is not %s", chunk, type,
                             chunk == 0 ? "JSON" : "BIN");
        if (chunk < 2)
            *(chunk == 0 ? &chunks->json_size : &chunks->bin_size) = size;
        at += 8 + (size_t)size;
    }
    return true;
}
