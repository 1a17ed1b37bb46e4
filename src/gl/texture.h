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

/* Zero means default. */
struct texture_desc {
    const char *label; /* for debug output and the memory ledger; required */
    GLenum target;     /* GL_TEXTURE_2D */
    GLenum format;     /* sized internal format; required */
    int width, height; /* width required; height 1 */
    int depth;         /* of GL_TEXTURE_3D, halved with each level: 1 */
    int layers;        /* of arrays, the same at each level: 1 */
    int levels;        /* 1 */
    int samples;       /* of GL_TEXTURE_2D_MULTISAMPLE_ARRAY: 1 */
    enum texture_filter filter;
    GLenum wrap_s, wrap_t, wrap_r; /* GL_CLAMP_TO_EDGE */
};

struct texture {
    GLuint id;
    struct texture_desc desc; /* resolved; without the label */
    char label[40];
    size_t bytes;
};

/* Error: out of GPU memory, or larger than the limits; names label and size, or samples. */
bool texture_init(struct texture *texture, const struct texture_desc *desc);
void texture_free(struct texture *texture);
#define textures_free(...) MEM_EACH(struct texture, texture_free, __VA_ARGS__)

/* The picture as an RGBA8 texture, filtered linearly, its row 0 the texture's last. Error: as above. */
bool texture_init_bitmap(struct texture *texture, const char *label, const struct bitmap *bitmap);

/* Fills an RGBA8 texture of the picture's size; the picture's row 0 is the texture's last. */
void texture_write_bitmap(struct texture *texture, const struct bitmap *bitmap);

/* Copies an RGBA8 texture's first layer, row 0 at the top; bitmap_free it. */
void texture_read_bitmap(const struct texture *texture, struct bitmap *bitmap);

/* Levels of a full MIP chain; depth 1 but for GL_TEXTURE_3D. */
int texture_full_levels(int width, int height, int depth);

#endif
