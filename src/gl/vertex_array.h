/* Vertex arrays: the sources of a program's vertex attributes. */
#ifndef GL_VERTEX_ARRAY_H
#define GL_VERTEX_ARRAY_H

#include "gl/buffer.h"

/* Layout of an attribute in a buffer. Integers are normalised by the maximum of their type. */
struct vertex_attribute {
    const struct buffer *buffer;
    GLint count;
    GLenum type;
    GLsizei stride; /* bytes */
    size_t offset;  /* bytes */
};

/* Attaches an attribute to a location. */
void vertex_array_attribute(GLuint vertices, GLuint location,
                            const struct vertex_attribute *attribute);

/* Deletes the vertex array. Accepts 0. */
void vertex_array_free(GLuint *vertices);

#endif
