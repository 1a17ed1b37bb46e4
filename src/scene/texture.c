#include "scene/texture.h"

#include "base/memory.h"
#include "base/parallel.h"

#include <math.h>

static float decode_srgb(float value) {
    return value <= 0.04045f ? value / 12.92f : powf((value + 0.055f) / 1.055f, 2.4f);
}

void texture_decode_table(float srgb_to_linear[256]) {
    for (int i = 0; i < 256; i++)
        srgb_to_linear[i] = decode_srgb((float)i / 255);
}

/* x modulo n, in [0, n) for negative x too. */
static int wrap_around(int x, int n) {
    int rest = x % n;
    return rest < 0 ? rest + n : rest;
}

static int wrap(int x, int n, enum texture_wrap mode) {
    switch (mode) {
    case TEXTURE_WRAP_REPEAT:
        return wrap_around(x, n);
    case TEXTURE_WRAP_MIRROR:
        x = wrap_around(x, 2 * n);
        return x < n ? x : 2 * n - 1 - x;
    case TEXTURE_WRAP_CLAMP:
        break;
    }
    return x < 0 ? 0 : x < n ? x : n - 1;
}

static float decode(const struct scene_texture *texture, const float srgb_to_linear[256],
                    unsigned char byte) {
    return texture->linear ? (float)byte / 255 : srgb_to_linear[byte];
}

static vec4s texel(const struct scene_texture *texture, const float srgb_to_linear[256], int x,
                   int y) {
    const struct bitmap *bitmap = &texture->bitmap;
    x = wrap(x, bitmap->width, texture->wrap_u);
    y = wrap(y, bitmap->height, texture->wrap_v);
    const unsigned char *rgba = &bitmap->rgba[4 * ((size_t)y * (size_t)bitmap->width + (size_t)x)];
    return (vec4s){{decode(texture, srgb_to_linear, rgba[0]),
                    decode(texture, srgb_to_linear, rgba[1]),
                    decode(texture, srgb_to_linear, rgba[2]), (float)rgba[3] / 255}};
}

/* Integers stay exact and far from overflow; a picture is at most 2^14 wide. */
static float in_texels(float coordinate, int size) {
    float x = coordinate * (float)size;
    return isfinite(x) ? fminf(fmaxf(x, -1e9f), 1e9f) : 0;
}

vec4s texture_lookup(const struct scene_texture *texture, const float srgb_to_linear[256],
                     vec2s uv) {
    float x = in_texels(uv.x, texture->bitmap.width);
    float y = in_texels(uv.y, texture->bitmap.height);
    if (texture->nearest)
        return texel(texture, srgb_to_linear, (int)floorf(x), (int)floorf(y));
    float left = floorf(x - 0.5f), top = floorf(y - 0.5f);
    int i = (int)left, j = (int)top;
    vec4s above = glms_vec4_lerp(texel(texture, srgb_to_linear, i, j),
                                 texel(texture, srgb_to_linear, i + 1, j), x - 0.5f - left);
    vec4s below = glms_vec4_lerp(texel(texture, srgb_to_linear, i, j + 1),
                                 texel(texture, srgb_to_linear, i + 1, j + 1), x - 0.5f - left);
    return glms_vec4_lerp(above, below, y - 0.5f - top);
}

/* --- a smaller picture ------------------------------------------------------------------------ */

static float encode_srgb(float value) {
    return value <= 0.0031308F ? value * 12.92F : 1.055F * powf(value, 1 / 2.4F) - 0.055F;
}

struct shrinking {
    const struct scene_texture *from;
    struct bitmap to;
    float srgb_to_linear[256];
};

/* The first of `from` texels that texel `at` of `to` covers. */
static int first_covered(int at, int from, int to) {
    return (int)((int64_t)at * from / to);
}

static vec4s mean_covered(const struct shrinking *shrinking, int x, int y) {
    const struct bitmap *from = &shrinking->from->bitmap, *to = &shrinking->to;
    int left = first_covered(x, from->width, to->width);
    int right = first_covered(x + 1, from->width, to->width);
    int top = first_covered(y, from->height, to->height);
    int bottom = first_covered(y + 1, from->height, to->height);
    vec4s sum = {{0, 0, 0, 0}};
    for (int j = top; j < bottom; j++)
        for (int i = left; i < right; i++)
            sum = glms_vec4_add(sum, texel(shrinking->from, shrinking->srgb_to_linear, i, j));
    return glms_vec4_scale(sum, 1 / (float)((right - left) * (bottom - top)));
}

static void shrink_row(void *context, size_t row) {
    const struct shrinking *shrinking = context;
    const struct bitmap *to = &shrinking->to;
    unsigned char *out = to->rgba + 4 * row * (size_t)to->width;
    for (int x = 0; x < to->width; x++, out += 4) {
        vec4s mean = mean_covered(shrinking, x, (int)row);
        for (int c = 0; c < 4; c++)
            out[c] = (unsigned char)lrintf(
                255 * (shrinking->from->linear || c == 3 ? mean.raw[c] : encode_srgb(mean.raw[c])));
    }
}

void texture_shrink(struct scene_texture *texture, int most) {
    struct bitmap *from = &texture->bitmap;
    struct shrinking shrinking = {.from = texture, .to = {from->width, from->height, NULL}};
    struct bitmap *to = &shrinking.to;
    if (from->width <= most && from->height <= most)
        return;
    to->width = to->width < most ? to->width : most;
    to->height = to->height < most ? to->height : most;
    to->rgba = mem_alloc((size_t)to->width * (size_t)to->height, 4);
    texture_decode_table(shrinking.srgb_to_linear);
    parallel_for((size_t)to->height, 0, shrink_row, &shrinking);
    bitmap_free(from);
    *from = *to;
}
