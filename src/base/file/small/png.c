/* PNG by libpng. */
#include "base/file/small/small.h"

#include "base/error.h"
#include "base/memory.h"

#include <png.h>
#include <string.h>
#include <strings.h>

struct source {
    png_structp png;
    png_infop info;
    const unsigned char *bytes;
    size_t left;
    png_bytepp rows;
};

static void on_error(png_structp png, png_const_charp message) {
    error_set("%s", message);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message) {
    (void)png, (void)message;
}

static void on_read(png_structp png, png_bytep to, size_t size) {
    struct source *source = png_get_io_ptr(png);
    if (source->left < size)
        png_error(png, "ends too soon");
    memcpy(to, source->bytes, size);
    source->bytes += size;
    source->left -= size;
}

/* Palettes become RGB, few bits 8, a colour that is transparent alpha. */
static void expand(const struct source *source) {
    int type = png_get_color_type(source->png, source->info);
    if (type == PNG_COLOR_TYPE_PALETTE)
        png_set_palette_to_rgb(source->png);
    if (type == PNG_COLOR_TYPE_GRAY && png_get_bit_depth(source->png, source->info) < 8)
        png_set_expand_gray_1_2_4_to_8(source->png);
    if (png_get_valid(source->png, source->info, PNG_INFO_tRNS))
        png_set_tRNS_to_alpha(source->png);
    png_set_interlace_handling(source->png);
    if (png_get_bit_depth(source->png, source->info) == 16)
        png_set_swap(source->png); /* this program runs on little-endian machines */
    png_read_update_info(source->png, source->info);
}

static bool read_header(struct source *source, struct raster *raster) {
    if (setjmp(png_jmpbuf(source->png)))
        return false;
    png_set_read_fn(source->png, source, on_read);
    png_read_info(source->png, source->info);
    expand(source);
    raster->width = (int)png_get_image_width(source->png, source->info);
    raster->height = (int)png_get_image_height(source->png, source->info);
    raster->channels = png_get_channels(source->png, source->info);
    raster->is_wide = png_get_bit_depth(source->png, source->info) == 16;
    return check_picture_size(raster->width, raster->height);
}

/* What may say that the picture is turned, or lies somewhere. */
static bool has_tags(const struct source *source) {
    png_textp texts = NULL;
    int count = 0;
    bool found = png_get_valid(source->png, source->info, PNG_INFO_eXIf) ||
                 png_get_x_offset_pixels(source->png, source->info) != 0 ||
                 png_get_y_offset_pixels(source->png, source->info) != 0;
    png_get_text(source->png, source->info, &texts, &count);
    for (int i = 0; i < count; i++)
        found = found || strcmp(texts[i].key, "XML:com.adobe.xmp") == 0 ||
                strncmp(texts[i].key, "Raw profile type ", 17) == 0 || /* ImageMagick's eXIf */
                strcasecmp(texts[i].key, "Orientation") == 0;
    return found;
}

/* To the file's last chunk: a file that is cut is refused. */
static bool read_rows(struct source *source, struct raster *raster) {
    png_bytep samples = raster->is_wide ? (png_bytep)raster->wide : raster->narrow;
    size_t row = png_get_rowbytes(source->png, source->info);
    source->rows = mem_alloc((size_t)raster->height, sizeof *source->rows);
    for (int y = 0; y < raster->height; y++)
        source->rows[y] = samples + (size_t)y * row;
    if (setjmp(png_jmpbuf(source->png)))
        return false;
    png_read_image(source->png, source->rows);
    png_read_end(source->png, source->info);
    raster->has_tags = has_tags(source);
    return true;
}

bool png_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only) {
    struct source source = {.bytes = bytes, .left = size};
    *raster = (struct raster){0};
    source.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, on_error, on_warning);
    source.info = source.png ? png_create_info_struct(source.png) : NULL;
    bool ok = source.info ? read_header(&source, raster) : error_set("out of memory");
    ok = ok && (size_only || (raster_alloc(raster) && read_rows(&source, raster)));
    png_destroy_read_struct(&source.png, &source.info, NULL);
    free(source.rows);
    if (!ok)
        raster_free(raster);
    return ok;
}

static void on_write(png_structp png, png_bytep bytes, size_t size) {
    text_append(png_get_io_ptr(png), bytes, size);
}

static void on_flush(png_structp png) {
    (void)png;
}

struct picture {
    const unsigned char *samples;
    int width, height, channels;
};

static bool write_all(png_structp png, png_infop info, const struct picture *picture) {
    if (setjmp(png_jmpbuf(png)))
        return false;
    int type = picture->channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
    png_set_IHDR(png, info, (png_uint_32)picture->width, (png_uint_32)picture->height, 8, type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
    png_write_info(png, info);
    size_t row = (size_t)picture->width * (size_t)picture->channels;
    for (int y = 0; y < picture->height; y++)
        png_write_row(png, picture->samples + (size_t)y * row);
    png_write_end(png, info);
    return true;
}

bool png_write(struct text *file, const unsigned char *samples, int width, int height,
               int channels) {
    const struct picture picture = {samples, width, height, channels};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (png)
        png_set_write_fn(png, file, on_write, on_flush);
    bool ok = info ? write_all(png, info, &picture) : error_set("out of memory");
    png_destroy_write_struct(&png, &info);
    return ok;
}
