/* The compute shader that does the work of a full-screen fragment shader (gl/screen.h). */
#ifndef GL_SCREEN_GLSL_H
#define GL_SCREEN_GLSL_H

#include "gl/program.h"

enum { SCREEN_GROUP = 8 }; /* pixels a side of a workgroup */

/* From the fragment shader's full text, as glsl_load has it; places in messages stay right. For free(). */
char *screen_glsl(const char *text, const struct screen_desc *desc);

#endif
