/* Folders of the file system. */
#ifndef BASE_FILE_FOLDER_H
#define BASE_FILE_FOLDER_H

#include <stdbool.h>

/* The folders that may hold the program's own files, in the order to look: the working folder, the
 * binary's, and PREFIX/share/manylight of a binary in PREFIX/bin. "" or with a slash at the end; free() frees.
 * NULL: there are no more. */
char *folder_of_program(int n);

/* The path of a file of the program's own, such as "scenes/door.glb", in the first of these folders that has it;
 * the name itself where none has. free() frees. */
char *folder_find_own(const char *name);

/* Makes the folders on the way to a file, where they are missing. Error: names the first that
 * cannot be made. */
bool folder_make_for(const char *file_path);

/* The program's folder among the user's: "$variable/manylight", or "~/below_home/manylight"; the caller
 * frees it. NULL, and an error: neither variable nor HOME is set. */
char *folder_of_user(const char *variable, const char *below_home);

/* The path as a shell reads it: "~" and "~/..." begin in HOME; the caller frees it. */
char *path_of_user(const char *path);

/* What follows the last slash of a path; the path itself where it has none. */
const char *path_name(const char *path);

#endif
