/* Whole files. */
#ifndef BASE_FILE_FILE_H
#define BASE_FILE_FILE_H

#include <stdbool.h>
#include <stddef.h>

struct file_bytes {
    unsigned char *data; /* free() frees */
    size_t size;         /* without the zero that follows the last byte */
};

/* Reads a whole regular file of less than 4 GiB, and no pointer of Git LFS to one. Error: names the
 * path and the reason; bytes are zeroed then. */
bool file_read(struct file_bytes *bytes, const char *path);

/* The same as text, to be freed by the caller; NULL on error. */
char *file_read_text(const char *path);

/* A regular file that is there, not forbidden, and no pointer of Git LFS. Error: names the path and the
 * reason. */
bool file_can_be_read(const char *path);

/* Tells whether a file was written since. Zeroed: it is not there, or no regular file. */
struct file_stamp {
    bool is_file;
    long long size, seconds, nanoseconds; /* of the last change */
};

struct file_stamp file_stamp_of(const char *path);
bool file_stamps_same(const struct file_stamp *a, const struct file_stamp *b);

/* A device or a pipe, which may have no end. */
bool file_is_stream(const char *path);

#endif
