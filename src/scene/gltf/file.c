#define _XOPEN_SOURCE 700
#include "scene/gltf/file.h"

#include "base/error.h"
#include "base/memory.h"
#include "scene/read_rules.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char file_no_folder[] = "-";

/* The name for messages: shortened, and without what could upset a terminal. */
static const char *shown(char text[80], const char *name) {
    snprintf(text, 80, "%s", name);
    for (char *c = text; *c; c++)
        if ((unsigned char)*c < 32 || *c == 127)
            *c = '?';
    return text;
}

/* Without a trailing slash, but for "/". */
static bool is_below(const char *root, const char *path) {
    size_t length = strlen(root);
    return strncmp(root, path, length) == 0 && (length == 1 || path[length] == '/');
}

/* Folder and name together, where "." and ".." are taken as text: the meaning of a URI, whether its
 * folders exist or not [RFC 3986, 5.2.4]. */
static char *join_as_text(const char *folder, const char *name) {
    char *path = mem_printf("%s/%s", *name == '/' ? "" : folder, name), *to = path;
    for (const char *from = path; *from;) {
        size_t length = strcspn(from, "/");
        bool up = length == 2 && strncmp(from, "..", 2) == 0;
        if (up)
            while (to > path && *--to != '/') {
            }
        else if (length > 0 && !(length == 1 && *from == '.')) {
            *to++ = '/';
            memmove(to, from, length);
            to += length;
        }
        from += length + strspn(from + length, "/");
    }
    *to = '\0';
    return path;
}

/* The folder below which all files lie; the caller frees it. */
static char *find_root(const char *folder) {
    const char *given = read_rules_root();
    char *root = mem_strdup(given ? given : folder), *slash = strrchr(root, '/');
    if (!given && slash > root)
        *slash = '\0';
    return root;
}

/* The file where the name leads, if that is below the root. Whether a file lies outside is not
 * told. */
static enum file_lack resolve(const char *folder, const char *root, const char *name, char **real) {
    char *as_text = join_as_text(folder, name), *path = mem_printf("%s/%s", folder, name);
    *real = realpath(*name == '/' ? name : path, NULL);
    if (!*real)
        *real = realpath(as_text, NULL);
    enum file_lack lack = FILE_FOUND;
    if (!is_below(root, *real ? *real : as_text))
        lack = FILE_OUTSIDE;
    else if (!*real)
        lack = FILE_MISSING;
    if (lack != FILE_FOUND) {
        free(*real);
        *real = NULL;
    }
    free(as_text);
    free(path);
    return lack;
}

/* The name as a path: without "file://"; the caller frees it. NULL: another URL, or nothing. */
static char *as_path(const char *name) {
    const char *after = strstr(name, "://");
    if (strncmp(name, "file:/", 6) == 0) {
        name += strncmp(name, "file:///", 8) == 0             ? 7
                : strncmp(name, "file://localhost/", 17) == 0 ? 16
                                                              : 5;
        after = NULL;
    }
    if (!*name || (after && strcspn(name, "/") == (size_t)(after - name) + 1))
        return NULL;
    return mem_strdup(name);
}

/* The same; NULL also in a scene without a folder. Error: why there is no path. */
static char *path_of(const char *folder, const char *name) {
    char text[80], *path = as_path(name);
    if (!*name)
        error_set("its name is empty");
    else if (!path)
        error_set("'%s' is a URL, which is not fetched", shown(text, name));
    else if (strcmp(folder, file_no_folder) == 0)
        error_set("cannot find '%s': the scene came through a pipe, which has no folder; give the "
                  "scene's path, or a .glb that holds all",
                  shown(text, name));
    else
        return path;
    free(path);
    return NULL;
}

static void slashes_for_backslashes(char *path) {
    for (; *path; path++)
        if (*path == '\\')
            *path = '/';
}

char *file_find_named(const char *folder, const char *name, enum file_lack *lack) {
    char text[80], *path = path_of(folder, name), *found = NULL;
    *lack = FILE_MISSING;
    if (!path)
        return NULL;
    char *base = realpath(*folder ? folder : ".", NULL), *root = find_root(base ? base : "/");
    *lack = base ? resolve(base, root, path, &found) : FILE_MISSING;
    if (*lack != FILE_FOUND && strchr(path, '\\')) {
        slashes_for_backslashes(path);
        *lack = base ? resolve(base, root, path, &found) : FILE_MISSING;
    }
    if (*lack == FILE_MISSING)
        error_set("cannot open %s%s: %s", *path == '/' ? "" : folder, shown(text, path),
                  strerror(ENOENT));
    else if (*lack == FILE_OUTSIDE)
        error_set("'%s' leads out of the folder %s (--root DIR names another)", shown(text, name),
                  root);
    free(path);
    free(base);
    free(root);
    return found;
}

bool file_read_named(struct file_bytes *bytes, const char *folder, const char *name, char **path,
                     enum file_lack *lack) {
    *path = file_find_named(folder, name, lack);
    *bytes = (struct file_bytes){0};
    if (!*path || file_read(bytes, *path))
        return *path != NULL;
    *lack = FILE_MISSING;
    free(*path);
    *path = NULL;
    return false;
}

static uint32_t word_at(const struct file_bytes *bytes, size_t at) {
    uint32_t word;
    memcpy(&word, bytes->data + at, sizeof word);
    return word;
}

bool glb_is(const struct file_bytes *bytes) {
    return bytes->size >= 4 && memcmp(bytes->data, "glTF", 4) == 0;
}

/* A chunk at an offset, of which at least type and size are there. */
static bool check_chunk(int chunk, uint32_t type, size_t size, size_t left) {
    enum { JSON = 0x4E4F534A };
    if (size > left && chunk <= 1)
        return error_set("chunk %d: %zu bytes, but only %zu are left", chunk, size, left);
    if ((chunk == 0) != (type == JSON))
        return error_set("chunk %d: type 0x%08X is %s", chunk, type,
                         chunk == 0 ? "not JSON" : "JSON, which comes first alone");
    return true;
}

/* glTF 2.0, 4.4: a header of 12 bytes, then chunks of length, type and data: JSON, then BIN, then
 * any others, which are ignored. */
bool glb_check(const struct file_bytes *bytes, struct glb_chunks *chunks) {
    enum { BIN = 0x004E4942 };
    if (bytes->size < 20)
        return error_set("truncated: %zu bytes are no GLB file", bytes->size);
    if (word_at(bytes, 4) != 2)
        return error_set("glTF version %u; 2.0 is read", word_at(bytes, 4));
    size_t end = word_at(bytes, 8), at = 12;
    if (end > bytes->size || end < 20)
        return error_set("%s: the header says %zu bytes, there are %zu",
                         end > bytes->size ? "truncated" : "wrong length", end, bytes->size);
    *chunks = (struct glb_chunks){.json = (const char *)bytes->data + 20};
    for (int chunk = 0; end - at >= 8; chunk++) {
        size_t size = word_at(bytes, at);
        uint32_t type = word_at(bytes, at + 4);
        if (!check_chunk(chunk, type, size, end - at - 8))
            return false;
        if (size > end - at - 8)
            break; /* padding behind JSON and BIN, which the header counts */
        chunks->is_uneven |= size % 4 != 0;
        if (chunk == 0) {
            chunks->json_size = size;
        } else if (type == BIN && !chunks->bin) {
            chunks->bin = (const char *)bytes->data + at + 8;
            chunks->bin_size = size;
        }
        at += 8 + size;
    }
    chunks->tail = bytes->size - at;
    return true;
}
