#include "gl/texture.h"

#include "base/error.h"
#include "base/memory.h"
#include "gl/memory.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

static size_t texel_bytes(GLenum format) {
    switch (format) {
    case GL_R8:
        return 1;
    case GL_R16:
    case GL_R16F:
    case GL_DEPTH_COMPONENT16:
        return 2;
    case GL_R32F:
    case GL_R32UI:
    case GL_R32I:
    case GL_RG16:
    case GL_RG16F:
    case GL_RGBA8:
    case GL_SRGB8_ALPHA8:
    case GL_DEPTH_COMPONENT32F:
        return 4;
    case GL_RGBA16:
    case GL_RGBA16F:
    case GL_RG32F:
    case GL_RG32UI:
        return 8;
    case GL_RGB32F:
        return 12;
    case GL_RGBA32F:
    case GL_RGBA32UI:
        return 16;
    default:
        assert(!"texture format without a size");
        return 0;
    }
}

static int at_least_one(int n) {
    return n > 1 ? n : 1;
}

static size_t storage_bytes(const struct texture_desc *desc) {
    size_t texels = 0;
    for (int level = 0; level < desc->levels; level++)
        texels += (size_t)at_least_one(desc->width >> level) *
                  (size_t)at_least_one(desc->height >> level) * (size_t)desc->layers;
    return texels * (size_t)desc->samples * texel_bytes(desc->format);
}

static struct texture_desc resolve(const struct texture_desc *desc) {
    struct texture_desc resolved = *desc;
    resolved.label = NULL; /* the caller's string need not live on */
    resolved.target = desc->target ? desc->target : GL_TEXTURE_2D;
    resolved.height = at_least_one(desc->height);
    resolved.layers = at_least_one(desc->layers);
    resolved.levels = at_least_one(desc->levels);
    resolved.samples = at_least_one(desc->samples);
    resolved.wrap_s = desc->wrap_s ? desc->wrap_s : GL_CLAMP_TO_EDGE;
    resolved.wrap_t = desc->wrap_t ? desc->wrap_t : GL_CLAMP_TO_EDGE;
    return resolved;
}

static bool fits_limits(const char *label, const struct texture_desc *desc) {
    GLint size, layers, samples;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    gl.GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
    gl.GetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &samples);
    if (desc->samples > samples)
        return error_set("texture '%s': %d samples are above the driver's limit of %d", label,
                         desc->samples, samples);
    if (desc->width <= size && desc->height <= size && desc->layers <= layers)
        return true;
    return error_set("texture '%s': %dx%dx%d is above the limit of %dx%dx%d", label, desc->width,
                     desc->height, desc->layers, size, size, layers);
}

static void allocate(GLuint id, const struct texture_desc *desc) {
    if (desc->target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY)
        gl.TextureStorage3DMultisample(id, desc->samples, desc->format, desc->width, desc->height,
                                       desc->layers, GL_TRUE);
    else if (desc->target == GL_TEXTURE_2D)
        gl.TextureStorage2D(id, desc->levels, desc->format, desc->width, desc->height);
    else
        gl.TextureStorage3D(id, desc->levels, desc->format, desc->width, desc->height,
                            desc->layers);
}

static void set_sampling(GLuint id, const struct texture_desc *desc) {
    static const GLint min_filters[] = {GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR};
    bool nearest = desc->filter == FILTER_NEAREST;
    gl.TextureParameteri(id, GL_TEXTURE_MIN_FILTER, min_filters[desc->filter]);
    gl.TextureParameteri(id, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    gl.TextureParameteri(id, GL_TEXTURE_WRAP_S, (GLint)desc->wrap_s);
    gl.TextureParameteri(id, GL_TEXTURE_WRAP_T, (GLint)desc->wrap_t);
}

bool texture_init(struct texture *texture, const struct texture_desc *desc) {
    assert(desc->label && desc->format && desc->width > 0);
    struct texture_desc resolved = resolve(desc);
    *texture = (struct texture){.desc = resolved};
    snprintf(texture->label, sizeof texture->label, "%s", desc->label);
    if (!fits_limits(texture->label, &resolved))
        return false;
    gl.CreateTextures(resolved.target, 1, &texture->id);
    while (gl.GetError() != GL_NO_ERROR) /* what follows must be this texture's own error */
        ;
    size_t bytes = storage_bytes(&resolved);
    bool fits = !gl.memory || bytes <= gl.memory;
    if (fits)
        allocate(texture->id, &resolved);
    if (!fits || gl.GetError() != GL_NO_ERROR) {
        texture_free(texture);
        return error_set_memory("texture '%s': out of GPU memory (%dx%dx%d, %.1f MiB)", desc->label,
                                resolved.width, resolved.height, resolved.layers,
                                (double)bytes / (1 << 20));
    }
    texture->bytes = bytes;
    gpu_memory_add(texture->label, (ptrdiff_t)bytes);
    gl.ObjectLabel(GL_TEXTURE, texture->id, -1, texture->label);
    if (resolved.target != GL_TEXTURE_2D_MULTISAMPLE_ARRAY)
        set_sampling(texture->id, &resolved);
    return true;
}

void texture_free(struct texture *texture) {
    if (texture->id)
        gl.DeleteTextures(1, &texture->id);
    if (texture->bytes)
        gpu_memory_add(texture->label, -(ptrdiff_t)texture->bytes);
    *texture = (struct texture){0};
}

int texture_full_levels(int width, int height) {
    int size = width > height ? width : height, levels = 1;
    while (size > 1) {
        size >>= 1;
        levels++;
    }
    return levels;
}

/* GL's row 0 is at the bottom. */
bool texture_init_bitmap(struct texture *texture, const char *label, const struct bitmap *bitmap) {
    if (!texture_init(texture, &(struct texture_desc){.label = label,
                                                      .format = GL_RGBA8,
                                                      .width = bitmap->width,
                                                      .height = bitmap->height,
                                                      .filter = FILTER_LINEAR}))
        return false;
    texture_write_bitmap(texture, bitmap);
    return true;
}

void texture_write_bitmap(struct texture *texture, const struct bitmap *bitmap) {
    for (int y = 0; y < bitmap->height; y++)
        gl.TextureSubImage2D(texture->id, 0, 0, bitmap->height - 1 - y, bitmap->width, 1, GL_RGBA,
                             GL_UNSIGNED_BYTE,
                             bitmap->rgba + (size_t)y * (size_t)bitmap->width * 4);
}

void texture_read_bitmap(const struct texture *texture, struct bitmap *bitmap) {
    int width = texture->desc.width, height = texture->desc.height;
    size_t row = (size_t)width * 4, bytes = row * (size_t)height;
    *bitmap = (struct bitmap){.width = width, .height = height, .rgba = mem_alloc(bytes, 1)};
    unsigned char *flipped = mem_alloc(bytes, 1);
    gl.GetTextureImage(texture->id, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLsizei)bytes, flipped);
    for (int y = 0; y < height; y++)
        memcpy(bitmap->rgba + (size_t)y * row, flipped + (size_t)(height - 1 - y) * row, row);
    free(flipped);
}
