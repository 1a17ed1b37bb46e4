/* Vertex arrays: where a program's attributes come from. */
#ifndef GL_VERTEX_ARRAY_H
#define GL_VERTEX_ARRAY_H

#include "gl/buffer.h"

/* How an attribute lies in a buffer, bytes. Integers are fractions of their type's greatest. */
struct vertex_attribute {
    const struct buffer *buffer;
    GLint count;
    GLenum type;
    GLsizei stride;
    size_t offset;
};

void vertex_array_attribute(GLuint vertices, GLuint location,
                            const struct vertex_attribute *attribute);

/* Accepts 0. */
void vertex_array_free(GLuint *vertices);

#endif
