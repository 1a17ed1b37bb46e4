/* Textures with immutable storage. */
#ifndef GL_TEXTURE_H
#define GL_TEXTURE_H

#include "base/image.h"
#include "base/memory.h"
#include "gl/api.h"

#include <stdbool.h>
#include <stddef.h>

enum texture_filter {
    FILTER_NEAREST,
    FILTER_LINEAR,
    FILTER_TRILINEAR, /* GL_LINEAR_MIPMAP_LINEAR */
};

/* Zero selects the default in the comment. */
struct texture_desc {
    const char *label; /* name for debug output and memory counts; required */
    GLenum target;     /* default GL_TEXTURE_2D */
    GLenum format;     /* sized internal format; required */
    int width, height; /* pixels; width required; height 1 */
    int layers;        /* for arrays, the same at each level; 1 */
    int levels;        /* 1 */
    int samples;       /* for GL_TEXTURE_2D_MULTISAMPLE_ARRAY; 1 */
    enum texture_filter filter;
    GLenum wrap_s, wrap_t; /* GL_CLAMP_TO_EDGE */
};

struct texture {
    GLuint id;
    struct texture_desc desc; /* with defaults filled in; label is NULL */
    char label[40];
    size_t bytes;
};

/* Creates a texture. Error: out of GPU memory, or above a limit; names label and size or
 * samples. */
bool texture_init(struct texture *texture, const struct texture_desc *desc);
void texture_free(struct texture *texture);
#define textures_free(...) MEM_EACH(struct texture, texture_free, __VA_ARGS__)

/* Creates an RGBA8 texture of the picture with linear filter. Row 0 of the picture is the last row
 * of the texture. Error: as texture_init. */
bool texture_init_bitmap(struct texture *texture, const char *label, const struct bitmap *bitmap);

/* Fills an RGBA8 texture of the picture's size. Row 0 of the picture is its last row. */
void texture_write_bitmap(struct texture *texture, const struct bitmap *bitmap);

/* Copies an RGBA8 texture's first layer, row 0 at the top. The caller frees the bitmap. */
void texture_read_bitmap(const struct texture *texture, struct bitmap *bitmap);

/* Returns the levels of a full MIP chain. */
int texture_full_levels(int width, int height);

#endif
