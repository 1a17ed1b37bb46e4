/* Writes RGBA as PNG, not compressed, alpha and all: the program's own pictures are opaque. */
#ifndef TEST_TINY_PNG_H
#define TEST_TINY_PNG_H

#include "support.h"

struct tiny_png {
    unsigned char *bytes;
    size_t size;
};

static inline void tiny_png_add(struct tiny_png *png, const void *bytes, size_t size) {
    png->bytes = realloc(png->bytes, png->size + size);
    assert_non_null(png->bytes);
    memcpy(png->bytes + png->size, bytes, size);
    png->size += size;
}

static inline void tiny_png_number(struct tiny_png *png, uint32_t x) {
    unsigned char big[4] = {(unsigned char)(x >> 24), (unsigned char)(x >> 16),
                            (unsigned char)(x >> 8), (unsigned char)x};
    tiny_png_add(png, big, sizeof big);
}

/* Length, type, data, and the CRC of the last two. */
static inline void tiny_png_chunk(struct tiny_png *png, const char *type,
                                  const struct tiny_png *data) {
    uint32_t crc = ~0U;
    tiny_png_number(png, (uint32_t)data->size);
    size_t first = png->size;
    tiny_png_add(png, type, 4);
    if (data->size)
        tiny_png_add(png, data->bytes, data->size);
    for (size_t i = first; i < png->size; i++) {
        crc ^= png->bytes[i];
        for (int bit = 0; bit < 8; bit++)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320U : 0);
    }
    tiny_png_number(png, ~crc);
}

/* Rows as blocks that are stored, and their Adler sum. */
static inline void tiny_png_rows(struct tiny_png *data, const unsigned char *rgba, int width,
                                 int height) {
    uint32_t a = 1, b = 0;
    unsigned length = 4 * (unsigned)width + 1;
    tiny_png_add(data, "\x78\x01", 2);
    for (int y = 0; y < height; y++) {
        unsigned char head[6] = {(unsigned char)(y == height - 1), (unsigned char)length,
                                 (unsigned char)(length >> 8),     (unsigned char)~length,
                                 (unsigned char)(~length >> 8),    0};
        const unsigned char *row = rgba + (size_t)y * (length - 1);
        tiny_png_add(data, head, sizeof head);
        tiny_png_add(data, row, length - 1);
        b = (b + a) % 65521; /* the filter's byte, 0 */
        for (unsigned i = 0; i + 1 < length; i++) {
            a = (a + row[i]) % 65521;
            b = (b + a) % 65521;
        }
    }
    tiny_png_number(data, b << 16 | a);
}

/* At most 16383 wide. */
static inline void write_tiny_png(const char *path, const unsigned char *rgba, int width,
                                  int height) {
    struct tiny_png png = {0}, head = {0}, data = {0}, none = {0};
    tiny_png_number(&head, (uint32_t)width);
    tiny_png_number(&head, (uint32_t)height);
    tiny_png_add(&head, "\x08\x06\0\0\0", 5);
    tiny_png_rows(&data, rgba, width, height);
    tiny_png_add(&png, "\x89PNG\r\n\x1a\n", 8);
    tiny_png_chunk(&png, "IHDR", &head);
    tiny_png_chunk(&png, "IDAT", &data);
    tiny_png_chunk(&png, "IEND", &none);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_true(fwrite(png.bytes, 1, png.size, file) == png.size);
    assert_true(fclose(file) == 0);
    free(png.bytes);
    free(head.bytes);
    free(data.bytes);
}

#endif
