/* Files of floats that need no library: the portable float map and Radiance's RGBE. */
#include "base/file/small/small.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/primaries.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct cursor {
    const unsigned char *at, *end;
};

static size_t left_of(const struct cursor *cursor) {
    return (size_t)(cursor->end - cursor->at);
}

/* The next line without its end, as much of it as there is room for; false: there is none. */
static bool next_line(struct cursor *cursor, char *line, size_t size) {
    const unsigned char *end = memchr(cursor->at, '\n', left_of(cursor));
    if (!end)
        return false;
    size_t length = (size_t)(end - cursor->at) < size ? (size_t)(end - cursor->at) : size - 1;
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

/* What the lines before the pixels say. */
struct hdr_header {
    int width, height;
    bool by_columns;    /* the first of the stored lines is a column */
    bool from_end[2];   /* stored lines come from the right or bottom; the pixels of a line do */
    double exposure[3]; /* by which values have been multiplied */
    bool is_xyz;        /* pixels are CIE XYZ, whose white is D65 */
    float primaries[8]; /* of the pixels; zeros: BT.709 */
};

/* Multiplies by one number or three. FreeImage writes 0 where it knows none, which is 1. */
static void take_exposure(double exposure[3], const char *numbers) {
    double by[3];
    int count = sscanf(numbers, "%lf %lf %lf", by, by + 1, by + 2);
    for (int c = 0; c < 3 && (count == 1 || count == 3); c++) {
        double factor = by[count == 1 ? 0 : c];
        exposure[c] *= factor > 0 && isfinite(factor) ? factor : 1;
    }
}

/* What a line of the header sets. Without a FORMAT the picture is RGBE. */
static bool take_line(struct hdr_header *header, const char *line) {
    char format[32] = "";
    float *p = header->primaries;
    if (strncmp(line, "EXPOSURE=", 9) == 0)
        take_exposure(header->exposure, line + 9);
    if (strncmp(line, "COLORCORR=", 10) == 0)
        take_exposure(header->exposure, line + 10);
    sscanf(line, "PRIMARIES=%f %f %f %f %f %f %f %f", p, p + 1, p + 2, p + 3, p + 4, p + 5, p + 6,
           p + 7);
    if (sscanf(line, "FORMAT=%31s", format) != 1)
        return true;
    header->is_xyz = strcmp(format, "32-bit_rle_xyze") == 0;
    return header->is_xyz || strcmp(format, "32-bit_rle_rgbe") == 0 ||
           error_set("a Radiance picture in the format '%s', neither RGBE nor XYZE", format);
}

/* "-Y 8 +X 16": lines of 16 pixels from the top, and of these from the left. */
static bool take_size(struct hdr_header *header, const char *line) {
    char signs[2], axes[2];
    int sizes[2];
    if (sscanf(line, "%c%c %d %c%c %d", signs, axes, sizes, signs + 1, axes + 1, sizes + 1) != 6 ||
        !strchr("+-", signs[0]) || !strchr("+-", signs[1]) || axes[0] + axes[1] != 'X' + 'Y' ||
        (axes[0] != 'X' && axes[0] != 'Y'))
        return error_set("a Radiance picture whose resolution is '%s', and not like -Y 8 +X 16",
                         line);
    header->by_columns = axes[0] == 'X';
    for (int i = 0; i < 2; i++) /* Y counts up, rows here down */
        header->from_end[i] = signs[i] == (axes[i] == 'X' ? '-' : '+');
    header->width = sizes[header->by_columns ? 0 : 1];
    header->height = sizes[header->by_columns ? 1 : 0];
    return check_picture_size(header->width, header->height);
}

static bool read_hdr_header(struct cursor *cursor, struct hdr_header *header) {
    char line[256];
    *header = (struct hdr_header){.exposure = {1, 1, 1}};
    if (!next_line(cursor, line, sizeof line) || strncmp(line, "#?", 2) != 0)
        return error_set("not a Radiance picture");
    while (next_line(cursor, line, sizeof line) && line[0])
        if (!take_line(header, line))
            return false;
    return next_line(cursor, line, sizeof line) ? take_size(header, line)
                                                : error_set("ends too soon");
}

/* One byte of each pixel after another, as runs: above 128 a run of one value, else so
 * many values. */
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

/* Pixels one by one. In files of before 1991 three ones mean that the pixel before comes so often
 * again; another such mark counts 256 times as much. */
static bool read_pixels(struct cursor *cursor, unsigned char *row, int width) {
    int shift = 0;
    for (int x = 0; x < width; cursor->at += RGBE) {
        const unsigned char *at = cursor->at;
        if (left_of(cursor) < RGBE)
            return error_set("ends too soon");
        bool repeats = x > 0 && at[0] == 1 && at[1] == 1 && at[2] == 1;
        int64_t count = repeats ? (int64_t)at[3] << shift : 1;
        if (shift > 16 || count > width - x)
            return error_set("a run of pixels leaves its row");
        for (int64_t i = 0; i < count; i++, x++)
            memcpy(row + RGBE * x, repeats ? row + RGBE * (x - 1) : at, RGBE);
        shift = repeats ? shift + 8 : 0;
    }
    return true;
}

static bool read_hdr_row(struct cursor *cursor, unsigned char *row, int width) {
    bool may_run = width >= RUN_WIDTH_MIN && width <= RUN_WIDTH_MAX && left_of(cursor) >= RGBE;
    const unsigned char *at = cursor->at;
    if (may_run && at[0] == 2 && at[1] == 2 && at[2] < 128) {
        if ((at[2] << 8 | at[3]) != width)
            return error_set("a row of %d pixels, and not of %d", at[2] << 8 | at[3], width);
        cursor->at += RGBE;
        return read_runs(cursor, row, width);
    }
    return read_pixels(cursor, row, width);
}

static void decode_rgbe(float rgb[3], const unsigned char rgbe[RGBE],
                        const struct hdr_header *header, float of_xyz[3][3]) {
    double scale = rgbe[3] ? ldexp(1, rgbe[3] - EXPONENT_BIAS) : 0;
    for (int c = 0; c < 3; c++)
        rgb[c] = (float)(rgbe[c] * scale / header->exposure[c]);
    if (header->is_xyz)
        glm_mat3_mulv(of_xyz, rgb, rgb);
}

/* The pixel of the picture that is the n-th of a stored line. */
static float *find_pixel(const struct image *image, const struct hdr_header *header, int line,
                         int n) {
    int columns = header->by_columns;
    int across = header->from_end[!columns] ? image->width - 1 - (columns ? line : n)
                 : columns                  ? line
                                            : n;
    int down = header->from_end[columns] ? image->height - 1 - (columns ? n : line)
               : columns                 ? n
                                         : line;
    return image_at(image, across, down);
}

static bool read_hdr_lines(struct cursor *cursor, const struct hdr_header *header,
                           struct image *image) {
    int lines = header->by_columns ? image->width : image->height,
        length = header->by_columns ? image->height : image->width;
    unsigned char *row = mem_alloc((size_t)length, RGBE);
    float matrix[3][3];
    bool ok = true;
    primaries_matrix_of_xyz(matrix);
    for (int line = 0; ok && line < lines; line++) {
        ok = read_hdr_row(cursor, row, length);
        for (int n = 0; ok && n < length; n++)
            decode_rgbe(find_pixel(image, header, line, n), row + RGBE * n, header, matrix);
    }
    free(row);
    return ok;
}

bool hdr_read(struct image *image, const unsigned char *bytes, size_t size) {
    enum { PIXELS_OF_A_BYTE = 1 << 14 }; /* at most: two marks for 255 * 256 pixels */
    struct cursor cursor = {bytes, bytes + size};
    struct hdr_header header;
    if (!read_hdr_header(&cursor, &header))
        return false;
    if ((uint64_t)left_of(&cursor) * PIXELS_OF_A_BYTE <
        (uint64_t)header.width * (uint64_t)header.height)
        return error_set("ends too soon");
    if (!open_rgb(image, header.width, header.height))
        return false;
    if (!header.is_xyz)
        memcpy(image->primaries, header.primaries, sizeof image->primaries);
    if (read_hdr_lines(&cursor, &header, image))
        return true;
    image_free(image);
    return false;
}

/* The mantissas are rounded: cut ones would make the picture .4 % too dark. */
static void encode_rgbe(unsigned char rgbe[RGBE], const float rgb[3]) {
    const float largest = 0x1.fep126f; /* 255 with the greatest exponent */
    float most = fminf(fmaxf(rgb[0], fmaxf(rgb[1], rgb[2])), largest);
    int exponent;
    memset(rgbe, 0, RGBE);
    if (!(most >= 1e-32f))
        return;
    if (roundf(256 * frexpf(most, &exponent)) > 255)
        exponent++;
    for (int c = 0; c < 3; c++)
        rgbe[c] = (unsigned char)roundf(ldexpf(fminf(fmaxf(rgb[c], 0), largest), 8 - exponent));
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

/* One byte of each pixel after another. A short run is worth its two bytes where nothing comes
 * before it. */
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
