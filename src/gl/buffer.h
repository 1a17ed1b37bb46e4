/* Buffers of vertices, indices, uniforms, storage and transform feedback. */
#ifndef GL_BUFFER_H
#define GL_BUFFER_H

#include "base/memory.h"
#include "gl/api.h"

#include <stdbool.h>
#include <stddef.h>

struct buffer {
    GLuint id, texels; /* texels: buffer texture over the buffer; 0: none */
    size_t size;
    const char *label; /* string literal */
};

/* Creates a buffer of size bytes, filled from data unless NULL. Size 0 makes 16 bytes, because
 * OpenGL has no empty buffers. Error: out of GPU memory; names label and size. */
bool buffer_init(struct buffer *buffer, const char *label, size_t size, const void *data);
/* Creates a buffer and a buffer texture of this format over it. */
bool buffer_init_texels(struct buffer *buffer, GLenum format, const char *label, size_t size,
                        const void *data);
void buffer_free(struct buffer *buffer);
#define buffers_free(...) MEM_EACH(struct buffer, buffer_free, __VA_ARGS__)

void buffer_write(const struct buffer *buffer, size_t offset, size_t size, const void *data);
void buffer_read(const struct buffer *buffer, size_t offset, size_t size, void *data);

#endif
