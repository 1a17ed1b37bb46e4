#include "gl/vertex_array.h"

void vertex_array_attribute(GLuint vertices, GLuint location, const struct buffer *buffer,
                            GLint count, GLenum type, GLsizei stride) {
    gl.VertexArrayVertexBuffer(vertices, location, buffer->id, 0, stride);
    gl.VertexArrayAttribFormat(vertices, location, count, type, type != GL_FLOAT, 0);
    gl.VertexArrayAttribBinding(vertices, location, location);
    gl.EnableVertexArrayAttrib(vertices, location);
}

void vertex_array_free(GLuint *vertices) {
    if (*vertices)
        gl.DeleteVertexArrays(1, vertices);
    *vertices = 0;
}
