/* Files of floats that need no library: the portable float map and Radiance's RGBE. */
#include "base/file/small/small.h"

#include "base/error.h"
#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct cursor {
    const unsigned char *at, *end;
};

static size_t left_of(const struct cursor *cursor) {
    return (size_t)(cursor->end - cursor->at);
}

/* The next line without its end; false: there is none, or it is too long. */
static bool next_line(struct cursor *cursor, char *line, size_t size) {
    const unsigned char *end = memchr(cursor->at, '\n', left_of(cursor));
    if (!end || (size_t)(end - cursor->at) >= size)
        return false;
    size_t length = (size_t)(end - cursor->at);
    memcpy(line, cursor->at, length);
    line[length] = '\0';
    cursor->at = end + 1;
    return true;
}

static bool open_rgb(struct image *image, int width, int height) {
    if (!check_picture_size(width, height) || !image_fits(width, height, 3))
        return false;
    image_init(image, width, height, "R G B");
    image->display = image->data = (struct image_window){0, 0, width, height};
    return true;
}

/* --- portable float map ----------------------------------------------------------------------- */

/* Rows from the bottom up, little-endian: the sign of the scale says so. */
bool pfm_read(struct image *image, const unsigned char *bytes, size_t size) {
    struct cursor cursor = {bytes, bytes + size};
    char kind[4], shape[64], order[64];
    int width = 0, height = 0;
    if (!next_line(&cursor, kind, sizeof kind) || !next_line(&cursor, shape, sizeof shape) ||
        !next_line(&cursor, order, sizeof order) || strcmp(kind, "PF") != 0 ||
        sscanf(shape, "%d %d", &width, &height) != 2 || strtod(order, NULL) != -1)
        return error_set(
            "not a little-endian PFM in colour without a scale, which this build reads "
            "alone");
    if (!check_picture_size(width, height) || !image_fits(width, height, 3))
        return false;
    size_t row = 3 * sizeof(float) * (size_t)width;
    if (left_of(&cursor) < row * (size_t)height)
        return error_set("ends too soon");
    if (!open_rgb(image, width, height))
        return false;
    for (int y = height - 1; y >= 0; y--, cursor.at += row)
        memcpy(image_at(image, 0, y), cursor.at, row);
    return true;
}

void pfm_write(struct text *file, const struct image *image, const int channels[3]) {
    text_print(file, "PF\n%d %d\n-1.0\n", image->width, image->height);
    for (int y = image->height - 1; y >= 0; y--)
        for (int x = 0; x < image->width; x++)
            for (int c = 0; c < 3; c++)
                text_append(file, image_at(image, x, y) + channels[c], sizeof(float));
}

/* --- Radiance --------------------------------------------------------------------------------- */

enum { RGBE = 4, EXPONENT_BIAS = 128 + 8, RUN_WIDTH_MIN = 8, RUN_WIDTH_MAX = 32767 };

/* Of a run that is told as one; of one told at once, and of values told one by one. */
enum { RUN_MIN = 4, RUN_MAX = 127, VALUES_MAX = 128 };

static bool read_hdr_header(struct cursor *cursor, int *width, int *height) {
    char line[256];
    bool is_rgbe = false;
    if (!next_line(cursor, line, sizeof line) || strncmp(line, "#?", 2) != 0)
        return error_set("not a Radiance picture");
    while (next_line(cursor, line, sizeof line) && line[0])
        if (strncmp(line, "FORMAT=", 7) == 0)
            is_rgbe = strcmp(line + 7, "32-bit_rle_rgbe") == 0;
    if (!is_rgbe)
        return error_set("a Radiance picture that is not RGBE, which this build does not read");
    if (!next_line(cursor, line, sizeof line))
        return error_set("ends too soon");
    if (sscanf(line, "-Y %d +X %d", height, width) != 2)
        return error_set("a Radiance picture that is turned ('%s'), which this build does not read",
                         line);
    return check_picture_size(*width, *height);
}

/* One byte of each pixel after another, as runs: above 128 a run of one value, else so many values. */
static bool read_runs(struct cursor *cursor, unsigned char *row, int width) {
    for (int c = 0; c < RGBE; c++)
        for (int x = 0; x < width;) {
            if (left_of(cursor) < 2)
                return error_set("ends too soon");
            int count = *cursor->at++;
            bool is_run = count > 128;
            count = is_run ? count - 128 : count;
            if (count == 0 || count > width - x)
                return error_set("a run of pixels leaves its row");
            if (left_of(cursor) < (is_run ? 1 : (size_t)count))
                return error_set("ends too soon");
            for (int i = 0; i < count; i++)
                row[RGBE * (x + i) + c] = cursor->at[is_run ? 0 : i];
            cursor->at += is_run ? 1 : count;
            x += count;
        }
    return true;
}

static bool read_hdr_row(struct cursor *cursor, unsigned char *row, int width) {
    size_t size = RGBE * (size_t)width;
    bool may_run = width >= RUN_WIDTH_MIN && width <= RUN_WIDTH_MAX && left_of(cursor) >= RGBE;
    const unsigned char *at = cursor->at;
    if (may_run && at[0] == 2 && at[1] == 2 && at[2] < 128) {
        if ((at[2] << 8 | at[3]) != width)
            return error_set("a row of %d pixels, and not of %d", at[2] << 8 | at[3], width);
        cursor->at += RGBE;
        return read_runs(cursor, row, width);
    }
    if (left_of(cursor) < size)
        return error_set("ends too soon");
    memcpy(row, cursor->at, size);
    cursor->at += size;
    return true;
}

static void decode_rgbe(float rgb[3], const unsigned char rgbe[RGBE]) {
    float scale = rgbe[3] ? (float)ldexp(1, rgbe[3] - EXPONENT_BIAS) : 0;
    for (int c = 0; c < 3; c++)
        rgb[c] = (float)rgbe[c] * scale;
}

bool hdr_read(struct image *image, const unsigned char *bytes, size_t size) {
    struct cursor cursor = {bytes, bytes + size};
    int width, height;
    if (!read_hdr_header(&cursor, &width, &height))
        return false;
    /* A row of runs has at least 8 bytes for each 127 pixels. */
    if ((uint64_t)left_of(&cursor) * 127 < (uint64_t)width * (uint64_t)height)
        return error_set("ends too soon");
    if (!open_rgb(image, width, height))
        return false;
    unsigned char *row = mem_alloc((size_t)width, RGBE);
    bool ok = true;
    for (int y = 0; ok && y < height; y++) {
        ok = read_hdr_row(&cursor, row, width);
        for (int x = 0; ok && x < width; x++)
            decode_rgbe(image_at(image, x, y), row + RGBE * x);
    }
    free(row);
    if (!ok)
        image_free(image);
    return ok;
}

static void encode_rgbe(unsigned char rgbe[RGBE], const float rgb[3]) {
    float most = fmaxf(rgb[0], fmaxf(rgb[1], rgb[2]));
    int exponent;
    memset(rgbe, 0, RGBE);
    if (!(most >= 1e-32f))
        return;
    float scale = frexpf(most, &exponent) * 256 / most;
    for (int c = 0; c < 3; c++)
        rgbe[c] = (unsigned char)fminf(fmaxf(rgb[c] * scale, 0), 255);
    rgbe[3] = (unsigned char)(exponent + 128);
}

static int run_length(const unsigned char *row, int at, int width) {
    int length = 1;
    while (length < RUN_MAX && at + length < width && row[RGBE * (at + length)] == row[RGBE * at])
        length++;
    return length;
}

static void write_values(struct text *file, const unsigned char *row, int at, int end) {
    while (at < end) {
        int count = end - at < VALUES_MAX ? end - at : VALUES_MAX;
        text_append(file, &(unsigned char){(unsigned char)count}, 1);
        for (int i = 0; i < count; i++)
            text_append(file, row + RGBE * (at + i), 1);
        at += count;
    }
}

static void write_run(struct text *file, unsigned char value, int length) {
    const unsigned char run[2] = {(unsigned char)(VALUES_MAX + length), value};
    text_append(file, run, 2);
}

/* One byte of each pixel after another. A short run is worth its two bytes where nothing comes before it. */
static void write_runs(struct text *file, const unsigned char *row, int width) {
    for (int at = 0; at < width;) {
        int begin = at, length = 0, first = run_length(row, at, width);
        while (begin < width && (length = run_length(row, begin, width)) < RUN_MIN)
            begin += length;
        if (first > 1 && first == begin - at) {
            write_run(file, row[RGBE * at], first);
            at = begin;
        }
        write_values(file, row, at, begin);
        if (begin < width)
            write_run(file, row[RGBE * begin], length);
        at = begin < width ? begin + length : width;
    }
}

static void write_hdr_row(struct text *file, const unsigned char *row, int width) {
    if (width < RUN_WIDTH_MIN || width > RUN_WIDTH_MAX) {
        text_append(file, row, RGBE * (size_t)width);
        return;
    }
    const unsigned char mark[RGBE] = {2, 2, (unsigned char)(width >> 8), (unsigned char)width};
    text_append(file, mark, RGBE);
    for (int c = 0; c < RGBE; c++)
        write_runs(file, row + c, width);
}

void hdr_write(struct text *file, const struct image *image, const int channels[3]) {
    text_print(file, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n", image->height,
               image->width);
    unsigned char *row = mem_alloc((size_t)image->width, RGBE);
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            const float *pixel = image_at(image, x, y);
            const float rgb[3] = {pixel[channels[0]], pixel[channels[1]], pixel[channels[2]]};
            encode_rgbe(row + RGBE * x, rgb);
        }
        write_hdr_row(file, row, image->width);
    }
    free(row);
}
