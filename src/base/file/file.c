#define _XOPEN_SOURCE 700
#include "base/file/file.h"

#include "base/error.h"
#include "base/memory.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool find(const char *path, struct stat *status) {
    if (stat(path, status) != 0)
        return error_set("cannot open %s: %s", path, strerror(errno));
    return S_ISREG(status->st_mode) || error_set("cannot read %s: not a file", path);
}

bool file_can_be_read(const char *path) {
    struct stat status;
    return find(path, &status) &&
           (access(path, R_OK) == 0 || error_set("cannot open %s: %s", path, strerror(errno)));
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
    if (good)
        return true;
    free(bytes->data);
    *bytes = (struct file_bytes){0};
    return error_set("cannot read %s", path);
}

char *file_read_text(const char *path) {
    struct file_bytes bytes;
    return file_read(&bytes, path) ? (char *)bytes.data : NULL;
}

bool file_is_stream(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}
