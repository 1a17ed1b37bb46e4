#define _XOPEN_SOURCE 700
#include "scene/gltf/file.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/shell.h"
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

/* The deepest folder that holds both. */
static char *common_folder(const char *folder, const char *path) {
    char *common = mem_strdup(folder);
    while (!is_below(common, path)) {
        char *slash = strrchr(common, '/');
        slash[slash == common] = '\0';
    }
    return common;
}

/* Where the name leads: the file without links, if that is below the root. place: the file, or the
 * place outside; NULL where a file is missing. The place outside is that of the name as text, so
 * that none can tell whether a file is there; it is that of links where the text stays in
 * the root. */
static enum file_lack resolve(const char *folder, const char *root, const char *name,
                              char **place) {
    char *as_text = join_as_text(folder, name), *path = mem_printf("%s/%s", folder, name);
    *place = realpath(*name == '/' ? name : path, NULL);
    if (!*place)
        *place = realpath(as_text, NULL);
    enum file_lack lack = *place ? FILE_FOUND : FILE_MISSING;
    if (!is_below(root, *place ? *place : as_text)) {
        lack = FILE_OUTSIDE;
        if (!is_below(root, as_text)) {
            free(*place);
            *place = mem_strdup(as_text);
        }
    }
    mem_free(as_text, path);
    return lack;
}

/* The error names the root that would allow it, but not all of the machine. */
static void refuse_outside(const char *folder, const char *root, const char *place,
                           const char *name) {
    char text[80], *common = common_folder(folder, place), *word = shell_quote(common);
    if (strcmp(common, "/") == 0)
        error_set("'%s' leads out of the folder %s (--root DIR names another)", shown(text, name),
                  root);
    else
        error_set("'%s' leads out of the folder %s (--root %s allows it)", shown(text, name), root,
                  word);
    mem_free(word, common);
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

/* "a.png?v=2" asks a server for a.png. */
static void cut_query(char *path) {
    path[strcspn(path, "?#")] = '\0';
}

/* The same of a name as it is, else with slashes for backslashes, else without a query besides. */
static enum file_lack resolve_either(const char *folder, const char *root, char *path,
                                     char **place) {
    static void (*const changes[])(char *) = {slashes_for_backslashes, cut_query};
    enum file_lack lack = resolve(folder, root, path, place);
    for (int i = 0; i < 2 && lack != FILE_FOUND; i++) {
        free(*place);
        changes[i](path);
        lack = resolve(folder, root, path, place);
    }
    return lack;
}

char *file_find_named(const char *folder, const char *name, enum file_lack *lack) {
    char text[80], *path = path_of(folder, name), *place = NULL;
    *lack = FILE_MISSING;
    if (!path)
        return NULL;
    char *base = realpath(*folder ? folder : ".", NULL), *root = find_root(base ? base : "/");
    if (base)
        *lack = resolve_either(base, root, path, &place);
    if (*lack == FILE_MISSING)
        error_set("cannot open %s%s: %s", *path == '/' ? "" : folder, shown(text, path),
                  strerror(ENOENT));
    else if (*lack == FILE_OUTSIDE) {
        refuse_outside(base, root, place, name);
        free(place);
        place = NULL;
        *lack = *path == '/' ? FILE_MISSING : FILE_OUTSIDE;
    }
    mem_free(path, base, root);
    return place;
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

enum { GLB_JSON = 0x4E4F534A, GLB_BIN = 0x004E4942 };

/* The lengths that a file tells of itself, and its own. */
struct glb_sizes {
    size_t told, file;
};

static void tell_header(char text[80], const struct glb_sizes *sizes) {
    snprintf(text, 80, "the header says %zu bytes, there are %zu", sizes->told, sizes->file);
}

static void tell_chunk(char text[80], int chunk, size_t size, size_t left) {
    snprintf(text, 80, "chunk %d: %zu bytes, but only %zu are left", chunk, size, left);
}

/* Errors of the first chunk, and of a second one of its kind. */
static bool check_chunk(int chunk, uint32_t type, size_t size, size_t left,
                        const struct glb_sizes *sizes) {
    char text[80];
    if ((chunk == 0) != (type == GLB_JSON))
        return error_set("chunk %d: type 0x%08X is %s", chunk, type,
                         chunk == 0 ? "not JSON" : "JSON, which comes first alone");
    if (chunk > 0 || size <= left)
        return true;
    if (sizes->told > sizes->file)
        tell_header(text, sizes);
    else
        tell_chunk(text, chunk, size, left);
    return error_set("truncated: %s", text);
}

/* glTF 2.0, 4.4: a header of 12 bytes, then chunks of length, type and data: JSON, then BIN, then
 * any others, which are ignored. The chunks tell where the file ends: past the length in the header
 * only BIN counts. */
bool glb_check(const struct file_bytes *bytes, struct glb_chunks *chunks) {
    if (bytes->size < 20)
        return error_set("truncated: %zu bytes are no GLB file", bytes->size);
    if (word_at(bytes, 4) != 2)
        return error_set("glTF version %u; 2.0 is read", word_at(bytes, 4));
    const struct glb_sizes sizes = {word_at(bytes, 8), bytes->size};
    size_t at = 12;
    *chunks = (struct glb_chunks){.json = (const char *)bytes->data + 20};
    for (int chunk = 0; bytes->size - at >= 8; chunk++) {
        size_t size = word_at(bytes, at), left = bytes->size - at - 8;
        uint32_t type = word_at(bytes, at + 4);
        bool is_bin = type == GLB_BIN && !chunks->bin;
        if (chunk > 0 && !is_bin && (at >= sizes.told || size > left))
            break; /* padding, which the header may count, or bytes behind */
        if (!check_chunk(chunk, type, size, left, &sizes))
            return false;
        chunks->is_uneven |= size % 4 != 0;
        if (size > left) {
            tell_chunk(chunks->length, chunk, size, left);
            chunks->is_cut = true;
            size = left;
        }
        if (chunk == 0)
            chunks->json_size = size;
        else if (is_bin) {
            chunks->bin = (const char *)bytes->data + at + 8;
            chunks->bin_size = size;
        }
        at += 8 + size;
    }
    chunks->tail = bytes->size - at;
    if (sizes.told > bytes->size || sizes.told < at)
        tell_header(chunks->length, &sizes);
    chunks->is_cut |= sizes.told > bytes->size;
    return true;
}
