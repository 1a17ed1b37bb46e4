/* Reads inputs that can be read only once: standard input, named "-", and pipes such as <(...).
 *
 * The first use of a path reads the pipe to its end into unnamed memory. Later uses get the same
 * bytes. Only inputs that the user names are pipes; names inside a scene are not. */
#ifndef BASE_FILE_PIPED_FILE_H
#define BASE_FILE_PIPED_FILE_H

#include "base/file/file.h"
#include "base/image.h"

/* True if the path is "-" or a pipe. */
bool piped_file_is(const char *path);

/* Reads a file or a pipe, as file_read. */
bool piped_file_read(struct file_bytes *bytes, const char *path);

/* Read a picture from a file or a pipe, as image_read and image_read_layer. */
bool piped_image_read(struct image *image, const char *path);
bool piped_image_read_layer(struct image *image, const char *path, const char *layer,
                            int channels[3]);

#endif
