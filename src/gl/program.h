/* Shader programs. */
#ifndef GL_PROGRAM_H
#define GL_PROGRAM_H

#include "gl/api.h"

#include <stdbool.h>

/* File names below glsl/; NULL = no such stage. */
struct program_desc {
    const char *vertex, *fragment, *compute;
    const char *defines;         /* "NAME VALUE;NAME VALUE", for all stages */
    const char *const *varyings; /* transform feedback, interleaved; null-terminated */
};

/* Compiles and links. Error: names file and line, with the driver's message. */
bool program_init(GLuint *program, const struct program_desc *desc);
void program_free(GLuint *program);

#endif
