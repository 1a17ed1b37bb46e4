/* Reads whole files. */
#ifndef BASE_FILE_FILE_H
#define BASE_FILE_FILE_H

#include <stdbool.h>
#include <stddef.h>

struct file_bytes {
    unsigned char *data; /* owned; the caller frees it */
    size_t size;         /* bytes, without the zero after the last byte */
};

/* Reads a regular file of less than 4 GiB. Error: names path and reason, also for a Git LFS
 * pointer; bytes are zeroed then. */
bool file_read(struct file_bytes *bytes, const char *path);

/* Reads a file as text, which the caller frees; NULL on error. */
char *file_read_text(const char *path);

/* Checks that the path is a readable regular file and no Git LFS pointer. Error: names path and
 * reason. */
bool file_can_be_read(const char *path);

/* Size and time of a file's last change, to detect changes. Zeroed: no regular file. */
struct file_stamp {
    bool is_file;
    long long size, seconds, nanoseconds; /* time of the last change */
};

struct file_stamp file_stamp_of(const char *path);
bool file_stamps_same(const struct file_stamp *a, const struct file_stamp *b);

/* True for a device or a pipe, which may have no end. */
bool file_is_stream(const char *path);

#endif
