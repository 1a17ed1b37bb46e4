/* The bytes of a glTF file and of the files that it names. */
#ifndef SCENE_GLTF_FILE_H
#define SCENE_GLTF_FILE_H

#include "base/file/file.h"

#include <stdbool.h>
#include <stddef.h>

/* Why a named file is not read. */
enum file_lack { FILE_FOUND, FILE_MISSING, FILE_OUTSIDE };

/* In place of the folder of a scene that came through a pipe: it can name no files. */
extern const char file_no_folder[];

/* The path, without links, of a file that a scene in the folder names; free() frees. folder is "" or
 * ends in a slash. The name may be absolute, lead upward and go through links; backslashes are slashes
 * where there is no such file otherwise, and "?v=2" is cut off. The file lies below the root: that of scene/read_rules.h, or
 * the parent of the folder, or the folder itself where the parent is "/". NULL and an error: lack tells
 * which. An absolute name that leads out of the root counts as missing: it is of another machine. */
char *file_find_named(const char *folder, const char *name, enum file_lack *lack);

/* Reads it, and gives its path, NULL where that fails. A file that cannot be read counts as missing. */
bool file_read_named(struct file_bytes *bytes, const char *folder, const char *name, char **path,
                     enum file_lack *lack);

/* Whether the bytes begin like a .glb. */
bool glb_is(const struct file_bytes *bytes);

struct glb_chunks {
    const char *json, *bin;
    size_t json_size, bin_size; /* bin_size = 0: there is no BIN chunk */
    size_t tail;                /* bytes after the last chunk, which are ignored */
    bool is_uneven;             /* a chunk's size is no multiple of 4 */
    char length[80];            /* which length in the file is wrong, in words; "" = none */
    bool is_cut;                /* it is the file that is too short */
};

/* Checks the container of a .glb, header and chunks, and finds JSON and BIN. */
bool glb_check(const struct file_bytes *bytes, struct glb_chunks *chunks);

#endif
