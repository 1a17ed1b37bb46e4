/* The interface of picture files over the smaller libraries, for `make bundle`: EXR, PNG, PFM and HDR both ways, and
 * textures in PNG, JPEG and WebP. All else is refused by name. */
#include "base/file/image_file.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/file/output_file.h"
#include "base/file/small/small.h"
#include "base/log.h"
#include "base/memory.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

struct format {
    const char *extension;
    bool is_float, has_alpha;
    const char *magic; /* with which its files begin */
};

enum { EXR, PFM, HDR, PNG, FORMAT_COUNT };

static const struct format formats[FORMAT_COUNT] = {
    [EXR] = {"exr", true, true, "v/1\x01"},
    [PFM] = {"pfm", true, false, "PF"},
    [HDR] = {"hdr", true, false, "#?"},
    [PNG] = {"png", false, true, "\x89PNG"},
};

static const char known[] = ".exr .pfm .hdr .png";

/* --- formats by name -------------------------------------------------------------------------- */

/* Of names that do not tell theirs. */
static const struct format *format_of_others;

static const struct format *find_extension(const char *extension) {
    for (int i = 0; i < FORMAT_COUNT; i++)
        if (strcasecmp(extension, formats[i].extension) == 0)
            return formats + i;
    return NULL;
}

/* "" where the file's name has none. */
static const char *extension_of(const char *path) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path,
               *dot = strrchr(name, '.');
    return dot ? dot + 1 : "";
}

/* NULL after an error. */
static const struct format *find_format(const char *path) {
    const char *extension = extension_of(path);
    const struct format *format = find_extension(extension);
    if (format || format_of_others)
        return format ? format : format_of_others;
    if (output_file_is_stdout(path))
        error_set("%s: standard output needs --format, such as png or exr", path);
    else if (!*extension)
        error_set("%s: no extension, so no picture format (try .exr or .png)", path);
    else
        error_set("%s: unknown picture format '.%s' (known: %s)", path, extension, known);
    return NULL;
}

bool image_name_tells_format(const char *path) {
    return find_extension(extension_of(path)) != NULL;
}

bool image_set_format_of_others(const char *extension) {
    format_of_others = find_extension(extension);
    return format_of_others ||
           error_set("format: '%s' is not one of those known: %s", extension, known);
}

bool image_format_is_float(const char *path, bool *is_float) {
    const struct format *format = find_format(path);
    *is_float = format && format->is_float;
    return format != NULL;
}

bool image_format_has_alpha(const char *path) {
    const struct format *format = find_format(path);
    return format && (format->has_alpha ||
                      error_set("%s: %s is written without alpha, which png and exr have", path,
                                format->extension));
}

bool image_name_holds_layers(const char *path) {
    const struct format *format = find_format(path);
    return format && (format == formats + EXR ||
                      error_set("%s: only EXR files (.exr) hold all layers", path));
}

/* --- reading ---------------------------------------------------------------------------------- */

/* By the content; NULL after an error. */
static const struct format *format_of(const struct file_bytes *file) {
    for (int i = 0; i < FORMAT_COUNT; i++) {
        size_t length = strlen(formats[i].magic);
        if (file->size > length && memcmp(file->data, formats[i].magic, length) == 0)
            return formats + i;
    }
    error_set("not a picture that this build reads (%s)", known);
    return NULL;
}

static bool take_raster(struct image *image, const struct raster *raster) {
    static const char *const names[] = {"", "Y", "Y A", "R G B", "R G B A"};
    if (!image_fits(raster->width, raster->height, raster->channels))
        return false;
    image_init(image, raster->width, raster->height, names[raster->channels]);
    image->display = image->data = (struct image_window){0, 0, raster->width, raster->height};
    image->encoded = true;
    for (size_t i = 0; i < raster_count(raster); i++)
        image->pixels[i] = raster->is_wide ? (float)raster->wide[i] * (1.f / 65535)
                                           : (float)raster->narrow[i] * (1.f / 255);
    return true;
}

static bool read_png(struct image *image, const struct file_bytes *file) {
    struct raster raster;
    if (!png_read(&raster, file->data, file->size, false))
        return false;
    bool ok = raster.has_tags ? error_set("has a camera's tags, which this build does not read")
                              : take_raster(image, &raster);
    raster_free(&raster);
    return ok;
}

static bool read_any(struct image *image, const char *path, const char *layer, int channels[3]) {
    struct file_bytes file;
    *image = (struct image){0};
    if (!file_read(&file, path))
        return false;
    const struct format *format = format_of(&file);
    bool ok = format == formats + EXR   ? exr_read(image, path, layer, channels)
              : format == formats + PFM ? pfm_read(image, file.data, file.size)
              : format == formats + HDR ? hdr_read(image, file.data, file.size)
                                        : format && read_png(image, &file);
    free(file.data);
    if (ok && layer && format != formats + EXR && !image_find_layer(image, layer, channels)) {
        image_free(image);
        ok = false;
    }
    return ok || error_prefix("%s", path);
}

bool image_read(struct image *image, const char *path) {
    return read_any(image, path, NULL, NULL);
}

bool image_read_layer(struct image *image, const char *path, const char *layer, int channels[3]) {
    return read_any(image, path, layer, channels);
}

bool image_is_whole(const char *path) {
    struct image image;
    if (!find_format(path))
        return false;
    if (file_is_stream(path))
        return error_set("%s: ends too soon", path);
    bool ok = image_read(&image, path);
    image_free(&image);
    return ok;
}

static bool read_size(const struct file_bytes *file, const char *path, int size[2]) {
    const struct format *format = format_of(file);
    struct raster raster = {0};
    struct image image = {0};
    bool ok = format != NULL;
    if (format == formats + EXR)
        return exr_read_size(path, size);
    if (format == formats + PNG)
        ok = png_read(&raster, file->data, file->size, true);
    else if (ok)
        ok = format == formats + PFM ? pfm_read(&image, file->data, file->size)
                                     : hdr_read(&image, file->data, file->size);
    size[0] = raster.width + image.width; /* one of the two is empty */
    size[1] = raster.height + image.height;
    image_free(&image);
    return ok;
}

bool image_size(const char *path, int size[2]) {
    struct file_bytes file;
    if (!file_read(&file, path))
        return false;
    bool ok = read_size(&file, path, size);
    free(file.data);
    return ok || error_prefix("%s", path);
}

/* --- writing ---------------------------------------------------------------------------------- */

static bool write_text(const char *path, struct text *file, bool ok) {
    ok = ok ? output_file_write(path, file->data, file->length) : error_prefix("%s", path);
    free(file->data);
    return ok;
}

bool image_write(const struct image *image, const char *path) {
    const struct format *format = find_format(path);
    struct text file = {0};
    int channels[3];
    if (!format)
        return false;
    if (format == formats + EXR)
        return write_text(path, &file, exr_write(&file, image));
    if (!format->is_float)
        return error_set("%s: floats are written as .exr, .pfm or .hdr", path);
    if (!image_find_layer(image, "", channels))
        return error_prefix("%s", path);
    if (format == formats + PFM)
        pfm_write(&file, image, channels);
    else
        hdr_write(&file, image, channels);
    return write_text(path, &file, true);
}

static bool write_bitmap(const struct bitmap *bitmap, const char *path, int channels) {
    const struct format *format = find_format(path);
    struct text file = {0};
    if (!format)
        return false;
    if (format->is_float)
        return error_set("%s: 8 bits are written as .png", path);
    size_t count = (size_t)bitmap->width * (size_t)bitmap->height, step = (size_t)channels;
    unsigned char *samples = mem_alloc(count, step);
    for (size_t i = 0; i < count; i++)
        memcpy(samples + step * i, bitmap->rgba + 4 * i, step);
    bool ok = png_write(&file, samples, bitmap->width, bitmap->height, channels);
    free(samples);
    return write_text(path, &file, ok);
}

bool bitmap_write(const struct bitmap *bitmap, const char *path) {
    return write_bitmap(bitmap, path, 3);
}

bool bitmap_write_alpha(const struct bitmap *bitmap, const char *path) {
    return image_format_has_alpha(path) && write_bitmap(bitmap, path, 4);
}

/* --- textures --------------------------------------------------------------------------------- */

static bool read_texture(struct raster *raster, const unsigned char *bytes, size_t size,
                         bool size_only) {
    bool ok;
    *raster = (struct raster){0};
    if (size > 4 && memcmp(bytes, formats[PNG].magic, 4) == 0)
        ok = png_read(raster, bytes, size, size_only);
    else if (size > 3 && memcmp(bytes, "\xFF\xD8\xFF", 3) == 0)
        ok = jpeg_read(raster, bytes, size, size_only);
    else if (size > 12 && memcmp(bytes, "RIFF", 4) == 0 && memcmp(bytes + 8, "WEBP", 4) == 0)
        ok = webp_read(raster, bytes, size, size_only);
    else
        return error_set("not a picture of a known format");
    return ok || error_prefix("picture");
}

bool bitmap_measure(const void *bytes, size_t size, uint64_t *memory) {
    struct raster raster;
    if (!read_texture(&raster, bytes, size, true))
        return false;
    *memory = (uint64_t)raster.width * (uint64_t)raster.height * 28 / 3; /* with MIP maps */
    return true;
}

bool bitmap_decode(struct bitmap *bitmap, const void *bytes, size_t size) {
    struct raster raster;
    *bitmap = (struct bitmap){0};
    if (!read_texture(&raster, bytes, size, false))
        return false;
    size_t count = (size_t)raster.width * (size_t)raster.height, n = (size_t)raster.channels;
    bitmap->width = raster.width;
    bitmap->height = raster.height;
    bitmap->rgba = mem_alloc(count, 4);
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++)
            bitmap->rgba[4 * i + c] = raster_byte(&raster, n * i + (n >= 3 ? c : 0));
        bitmap->rgba[4 * i + 3] = n % 2 == 0 ? raster_byte(&raster, n * i + n - 1) : 255;
    }
    raster_free(&raster);
    return true;
}
