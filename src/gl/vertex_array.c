#include "gl/vertex_array.h"

void vertex_array_attribute(GLuint vertices, GLuint location,
                            const struct vertex_attribute *attribute) {
    GLenum type = attribute->type;
    gl.VertexArrayVertexBuffer(vertices, location, attribute->buffer->id,
                               (GLintptr)attribute->offset, attribute->stride);
    gl.VertexArrayAttribFormat(vertices, location, attribute->count, type, type != GL_FLOAT, 0);
    gl.VertexArrayAttribBinding(vertices, location, location);
    gl.EnableVertexArrayAttrib(vertices, location);
}

void vertex_array_free(GLuint *vertices) {
    if (*vertices)
        gl.DeleteVertexArrays(1, vertices);
    *vertices = 0;
}
