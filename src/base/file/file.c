#define _XOPEN_SOURCE 700
#include "base/file/file.h"

#include "base/error.h"
#include "base/memory.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static bool find(const char *path, struct stat *status) {
    if (stat(path, status) != 0)
        return error_set("cannot open %s: %s", path, strerror(errno));
    return S_ISREG(status->st_mode) || error_set("cannot read %s: not a file", path);
}

static const char pointer_text[] = "version https://git-lfs.github.com/spec/";

/* Git LFS leaves a few lines of text in place of a large file that was not fetched. */
static bool check_content(const void *bytes, size_t size, const char *path) {
    bool is_pointer = size >= sizeof pointer_text - 1 &&
                      memcmp(bytes, pointer_text, sizeof pointer_text - 1) == 0;
    return !is_pointer ||
           error_set("%s: a Git LFS pointer; git lfs pull fetches the file itself", path);
}

struct file_stamp file_stamp_of(const char *path) {
    struct stat status;
    if (stat(path, &status) != 0 || !S_ISREG(status.st_mode))
        return (struct file_stamp){0};
    return (struct file_stamp){true, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

bool file_stamps_same(const struct file_stamp *a, const struct file_stamp *b) {
    return a->is_file == b->is_file && a->size == b->size && a->seconds == b->seconds &&
           a->nanoseconds == b->nanoseconds;
}

bool file_can_be_read(const char *path) {
    struct stat status;
    char start[sizeof pointer_text];
    if (!find(path, &status))
        return false;
    FILE *file = fopen(path, "rb");
    if (!file)
        return error_set("cannot open %s: %s", path, strerror(errno));
    size_t size = fread(start, 1, sizeof start, file);
    fclose(file);
    return check_content(start, size, path);
}

bool file_read(struct file_bytes *bytes, const char *path) {
    *bytes = (struct file_bytes){0};
    struct stat status;
    if (!find(path, &status))
        return false;
    if (status.st_size >= (off_t)UINT32_MAX)
        return error_set("cannot read %s: 4 GiB or more", path);
    FILE *file = fopen(path, "rb");
    if (!file)
        return error_set("cannot open %s: %s", path, strerror(errno));
    bytes->size = (size_t)status.st_size;
    bytes->data = mem_alloc(bytes->size + 1, 1);
    bool good = fread(bytes->data, 1, bytes->size, file) == bytes->size;
    fclose(file);
    if (!good)
        error_set("cannot read %s", path);
    if (good && check_content(bytes->data, bytes->size, path))
        return true;
    free(bytes->data);
    *bytes = (struct file_bytes){0};
    return false;
}

char *file_read_text(const char *path) {
    struct file_bytes bytes;
    return file_read(&bytes, path) ? (char *)bytes.data : NULL;
}

bool file_is_stream(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}
