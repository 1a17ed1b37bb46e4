/* Bytes of a glTF file and of the files that it names. */
#ifndef SCENE_GLTF_FILE_H
#define SCENE_GLTF_FILE_H

#include "base/file/file.h"

#include <stdbool.h>
#include <stddef.h>

/* Reason why a named file is not read. */
enum file_lack { FILE_FOUND, FILE_MISSING, FILE_OUTSIDE };

/* Folder of a scene from a pipe, which can name no files. */
extern const char file_no_folder[];

/* Returns the path, without links, of a file that a scene in `folder` names. The caller frees it.
 * folder: "" or ends in a slash. The name may be absolute, lead upward and follow links.
 * Backslashes count as slashes if no such file exists; "?v=2" is cut off. The file must be below
 * the root: that of scene/read_rules.h, or the parent of `folder`, or `folder` if the parent is
 * "/". Error, NULL: `lack` has the reason. An absolute name outside the root counts as missing:
 * another machine wrote it. */
char *file_find_named(const char *folder, const char *name, enum file_lack *lack);

/* Reads the file of file_find_named and returns its path in *path, NULL after an error. An
 * unreadable file counts as missing. */
bool file_read_named(struct file_bytes *bytes, const char *folder, const char *name, char **path,
                     enum file_lack *lack);

/* True if the bytes begin like a .glb. */
bool glb_is(const struct file_bytes *bytes);

struct glb_chunks {
    const char *json, *bin;
    size_t json_size, bin_size; /* bin_size 0: no BIN chunk */
    size_t tail;                /* bytes after the last chunk, ignored */
    bool is_uneven;             /* some chunk's size is not a multiple of 4 */
    char length[80];            /* description of a wrong length; "": none */
    bool is_cut;                /* the file is too short */
};

/* Checks header and chunks of a .glb and finds JSON and BIN. */
bool glb_check(const struct file_bytes *bytes, struct glb_chunks *chunks);

#endif
