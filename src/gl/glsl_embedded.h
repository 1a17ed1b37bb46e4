/* Shader files that the Makefile embeds. The list ends with a NULL name. */
#ifndef GL_GLSL_EMBEDDED_H
#define GL_GLSL_EMBEDDED_H

struct glsl_file {
    const char *name; /* path below glsl/ or src/ */
    const char *text;
};

extern const struct glsl_file glsl_embedded[];

#endif
