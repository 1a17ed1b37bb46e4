/* Buffers: vertices, indices, uniforms, transform feedback. */
#ifndef GL_BUFFER_H
#define GL_BUFFER_H

#include "base/memory.h"
#include "gl/api.h"

#include <stdbool.h>
#include <stddef.h>

struct buffer {
    GLuint id, texels; /* a buffer texture, or 0 */
    size_t size;
    const char *label; /* a literal */
};

/* size bytes, filled from data unless NULL. A size of 0 makes a buffer of 16 bytes, as GL has no
 * empty ones. Error: out of GPU memory; names label and size. */
bool buffer_init(struct buffer *buffer, const char *label, size_t size, const void *data);
/* The same with a buffer texture over it. */
bool buffer_init_texels(struct buffer *buffer, GLenum format, const char *label, size_t size,
                        const void *data);
void buffer_free(struct buffer *buffer);
#define buffers_free(...) MEM_EACH(struct buffer, buffer_free, __VA_ARGS__)

void buffer_write(const struct buffer *buffer, size_t offset, size_t size, const void *data);
void buffer_read(const struct buffer *buffer, size_t offset, size_t size, void *data);

#endif
