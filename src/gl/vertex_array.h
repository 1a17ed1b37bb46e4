/* Vertex arrays: where a program's attributes come from. */
#ifndef GL_VERTEX_ARRAY_H
#define GL_VERTEX_ARRAY_H

#include "gl/buffer.h"

/* Feeds the attribute from a buffer of its own, `stride` bytes apart. Integers are fractions of
 * their type's greatest. */
void vertex_array_attribute(GLuint vertices, GLuint location, const struct buffer *buffer,
                            GLint count, GLenum type, GLsizei stride);

/* Accepts 0. */
void vertex_array_free(GLuint *vertices);

#endif
