/* The bytes of a glTF file and of the files that it names. */
#ifndef SCENE_GLTF_FILE_H
#define SCENE_GLTF_FILE_H

#include "base/file/file.h"

#include <stdbool.h>
#include <stddef.h>

/* In place of the folder of a scene that came through a pipe: it can name no files. */
extern const char file_no_folder[];

/* The path of a file that a glTF names by a relative path; free() frees. folder is "" or ends in a slash.
 * A name that leads out of the folder is refused, be it by ".." or by a symbolic link: NULL and an
 * error. */
char *file_find_named(const char *folder, const char *name);

/* Reads such a file. */
bool file_read_named(struct file_bytes *bytes, const char *folder, const char *name);

/* Whether the bytes begin like a .glb. */
bool glb_is(const struct file_bytes *bytes);

struct glb_chunks {
    const char *json;
    size_t json_size, bin_size; /* bin_size = 0: there is no BIN chunk */
};

/* Checks the container of a .glb, header and chunks, and finds the JSON. */
bool glb_check(const struct file_bytes *bytes, struct glb_chunks *chunks);

#endif
