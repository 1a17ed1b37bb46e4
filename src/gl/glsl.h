/* GLSL sources: embedded in the binary, or read from a folder (--glsl DIR).
 *
 * A file's name is its path below the folder, as "lib/view.glsl"; "techniques/NAME/FILE" and
 * "direct/NAME/FILE" lie in src/ beside the folder.
 * Files have no #version line; the version, the defines and #include "lib/..." are put in here. #include NAME takes
 * the file that the define NAME has: so a pass chooses among files that keep one contract.
 * #line directives tell the place of each line, and glsl_explain turns the numbers of a driver's
 * message into file names and lines.
 */
#ifndef GL_GLSL_H
#define GL_GLSL_H

#include <stdbool.h>

enum { GLSL_FILES_MAX = 128 };

struct glsl_source {
    char *text;
    char *files[GLSL_FILES_MAX]; /* in the order of their first lines */
    int file_count;
};

/* Reads shaders from this folder from now on; NULL = embedded. The string is not copied. */
void glsl_set_folder(const char *folder);

/* defines: "NAME VALUE;NAME VALUE", or NULL. Error: names the file and who includes it. */
bool glsl_load(struct glsl_source *source, const char *file, const char *defines);
void glsl_free(struct glsl_source *source);

/* The driver's message with the places of mistakes as FILE:LINE; to be freed by the caller. */
char *glsl_explain(const struct glsl_source *source, const char *message);

#endif
