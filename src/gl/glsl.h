/* Loads GLSL sources, embedded in the binary or read from a folder (--glsl DIR).
 *
 * A name such as "lib/view.glsl", "shared/light.h" or "fullscreen.vert" is a path below the folder.
 * Other names are paths below src/, beside the folder. Files have no #version line. Loading adds
 * the version and the defines and expands #include "lib/...". #line directives keep file and line
 * of each source line. glsl_explain replaces a driver's numbers by them. */
#ifndef GL_GLSL_H
#define GL_GLSL_H

#include <stdbool.h>

enum { GLSL_FILES_MAX = 128 };

struct glsl_source {
    char *text;
    char *files[GLSL_FILES_MAX]; /* in order of first use */
    int file_count;
};

/* Sets the folder for later loads; NULL: embedded sources. The string is not copied. */
void glsl_set_folder(const char *folder);

/* Loads a file with its includes. defines: "NAME VALUE;NAME VALUE", or NULL. Error: names the file
 * and the file that includes it. */
bool glsl_load(struct glsl_source *source, const char *file, const char *defines);
void glsl_free(struct glsl_source *source);

/* Returns the driver's message with positions as FILE:LINE. The caller frees it. */
char *glsl_explain(const struct glsl_source *source, const char *message);

#endif
