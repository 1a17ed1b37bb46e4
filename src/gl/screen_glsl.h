/* Turns a screen shader into a compute shader (gl/screen.h). */
#ifndef GL_SCREEN_GLSL_H
#define GL_SCREEN_GLSL_H

#include "gl/program.h"

enum { SCREEN_GROUP = 8 }; /* pixels per side of a workgroup */

/* Returns the compute shader for the text of a fragment shader as glsl_load returns it. Line
 * numbers in messages stay right. The caller frees the text. */
char *screen_glsl(const char *text, const struct screen_desc *desc);

#endif
