/* Inputs that can be read only once: standard input, which is called "-", and pipes, such as a shell's <(...).
 *
 * The first use of a path reads the pipe to its end into memory without a name. Later uses of the path get
 * the same bytes. Only inputs that the user names are read so: names inside a scene are not. */
#ifndef BASE_FILE_PIPED_FILE_H
#define BASE_FILE_PIPED_FILE_H

#include "base/file/file.h"
#include "base/image.h"

/* Whether the path is "-" or leads to a pipe. */
bool piped_file_is(const char *path);

/* file_read of a file or a pipe. */
bool piped_file_read(struct file_bytes *bytes, const char *path);

/* image_read and image_read_layer of a file or a pipe. */
bool piped_image_read(struct image *image, const char *path);
bool piped_image_read_layer(struct image *image, const char *path, const char *layer,
                            int channels[3]);

#endif
