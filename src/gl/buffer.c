#include "gl/buffer.h"

#include "base/error.h"
#include "gl/memory.h"

bool buffer_init(struct buffer *buffer, const char *label, size_t size, const void *data) {
    *buffer = (struct buffer){.label = label};
    gl.CreateBuffers(1, &buffer->id);
    while (gl.GetError() != GL_NO_ERROR) /* what follows must be this buffer's own error */
        ;
    size_t stored = size ? size : 16;
    bool fits = !gl.memory || stored <= gl.memory;
    if (fits)
        gl.NamedBufferStorage(buffer->id, (GLsizeiptr)stored, size ? data : NULL,
                              GL_DYNAMIC_STORAGE_BIT);
    if (!fits || gl.GetError() != GL_NO_ERROR) {
        buffer_free(buffer);
        return error_set_memory("buffer '%s': out of GPU memory (%.1f MiB)", label,
                                (double)stored / (1 << 20));
    }
    buffer->size = stored;
    gpu_memory_add(label, (ptrdiff_t)stored);
    gl.ObjectLabel(GL_BUFFER, buffer->id, -1, label);
    return true;
}

bool buffer_init_texels(struct buffer *buffer, GLenum format, const char *label, size_t size,
                        const void *data) {
    if (!buffer_init(buffer, label, size, data))
        return false;
    gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &buffer->texels);
    gl.TextureBuffer(buffer->texels, format, buffer->id);
    return true;
}

void buffer_free(struct buffer *buffer) {
    if (buffer->texels)
        gl.DeleteTextures(1, &buffer->texels);
    if (buffer->id)
        gl.DeleteBuffers(1, &buffer->id);
    if (buffer->size)
        gpu_memory_add(buffer->label, -(ptrdiff_t)buffer->size);
    *buffer = (struct buffer){0};
}

void buffer_write(const struct buffer *buffer, size_t offset, size_t size, const void *data) {
    if (size)
        gl.NamedBufferSubData(buffer->id, (GLintptr)offset, (GLsizeiptr)size, data);
}

void buffer_read(const struct buffer *buffer, size_t offset, size_t size, void *data) {
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT); /* after what shaders stored */
    gl.GetNamedBufferSubData(buffer->id, (GLintptr)offset, (GLsizeiptr)size, data);
}
