/* Folders of the file system. */
#ifndef BASE_FILE_FOLDER_H
#define BASE_FILE_FOLDER_H

#include <stdbool.h>

/* Makes the folders on the way to a file, where they are missing. Error: names the first that
 * cannot be made. */
bool folder_make_for(const char *file_path);

/* The program's folder among the user's: "$variable/manylight", or "~/below_home/manylight"; the caller
 * frees it. NULL, and an error: neither variable nor HOME is set. */
char *folder_of_user(const char *variable, const char *below_home);

/* The path as a shell reads it: "~" and "~/..." begin in HOME; the caller frees it. */
char *path_of_user(const char *path);

#endif
