/* Folders of the file system. */
#ifndef BASE_FILE_FOLDER_H
#define BASE_FILE_FOLDER_H

#include <stdbool.h>

/* Returns the n-th folder of the program's own files, in search order: the working folder, the
 * binary's, PREFIX/share/manylight for a binary in PREFIX/bin. The path is "" or ends in a slash.
 * The caller frees it. NULL: no more. */
char *folder_of_program(int n);

/* Returns the path of a file of the program, such as "scenes/door.glb", in the first of these
 * folders that has it, else the name. The caller frees it. */
char *folder_find_own(const char *name);

/* Makes the missing folders above a file. Error: names the first that cannot be made. */
bool folder_make_for(const char *file_path);

/* Returns the program's folder of the user: "$variable/manylight", or "~/below_home/manylight". The
 * caller frees it. Error, and NULL: neither variable nor HOME is set. */
char *folder_of_user(const char *variable, const char *below_home);

/* Returns the path with "~" or "~/" replaced by HOME. The caller frees it. */
char *path_of_user(const char *path);

/* Returns the part after the last slash, or the path if it has none. */
const char *path_name(const char *path);

#endif
