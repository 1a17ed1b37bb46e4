#include "png.h"

#include <assert.h>
#include <stdint.h>
#include <stdlib.h>

static void append_big_endian(struct text *to, uint32_t value) {
    text_append(
        to, (unsigned char[]){value >> 24 & 255, value >> 16 & 255, value >> 8 & 255, value & 255},
        4);
}

/* The CRC-32 of ISO 3309, by bits. */
static uint32_t check_sum(const char *bytes, size_t size) {
    uint32_t sum = UINT32_MAX;
    for (size_t i = 0; i < size; i++) {
        sum ^= (unsigned char)bytes[i];
        for (int bit = 0; bit < 8; bit++)
            sum = sum & 1 ? sum >> 1 ^ 0xedb88320u : sum >> 1;
    }
    return ~sum;
}

static void append_chunk(struct text *to, const char name[4], const void *bytes, size_t size) {
    append_big_endian(to, (uint32_t)size);
    size_t begin = to->length;
    text_append(to, name, 4);
    text_append(to, bytes, size);
    append_big_endian(to, check_sum(to->data + begin, to->length - begin));
}

/* A zlib stream of one block that is stored as it is. */
static void append_stream(struct text *to, const struct text *bytes) {
    uint32_t a = 1, b = 0;
    uint16_t size = (uint16_t)bytes->length, rest = (uint16_t)~size;
    assert(bytes->length <= UINT16_MAX);
    text_append(to, (unsigned char[]){0x78, 1, 1, size & 255, size >> 8, rest & 255, rest >> 8}, 7);
    text_append(to, bytes->data, bytes->length);
    for (size_t i = 0; i < bytes->length; i++) {
        a = (a + (unsigned char)bytes->data[i]) % 65521;
        b = (b + a) % 65521;
    }
    append_big_endian(to, b << 16 | a);
}

void png_append(struct text *to, int width, int height, const unsigned char *rgba) {
    struct text header = {0}, rows = {0}, stream = {0};
    assert(width <= PNG_SIDE_MOST && height <= PNG_SIDE_MOST);
    append_big_endian(&header, (uint32_t)width);
    append_big_endian(&header, (uint32_t)height);
    text_append(&header, (unsigned char[]){8, 6, 0, 0, 0}, 5); /* bits, RGBA, all defaults */
    for (int y = 0; y < height; y++) {
        text_append(&rows, "", 1); /* unfiltered */
        text_append(&rows, rgba + 4 * y * width, 4 * (size_t)width);
    }
    append_stream(&stream, &rows);
    text_append(to, "\x89PNG\r\n\x1a\n", 8);
    append_chunk(to, "IHDR", header.data, header.length);
    append_chunk(to, "IDAT", stream.data, stream.length);
    append_chunk(to, "IEND", "", 0);
    free(header.data);
    free(rows.data);
    free(stream.data);
}
