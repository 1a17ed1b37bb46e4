/* The formats of picture files, and which of two bridges reads and writes a file. Libraries that
 * start quickly come first (base/file/small/): EXR, PNG, PFM and HDR, and textures in PNG, JPEG and
 * WebP. What they refuse goes to OpenImageIO (image_plugin.h), whose refusal counts then. */
#include "base/file/image_file.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/file/image_plugin.h"
#include "base/file/output_file.h"
#include "base/file/small/small.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/primaries.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* Of the other formats that OpenImageIO knows, some lose without a word what does not fit on the
 * disk. */
struct format {
    const char *extension;
    const char *name; /* OpenImageIO's */
    bool is_float;
    bool has_alpha; /* not of WebP, whose encoder divides colours by alpha, whatever it is told */
    const char
        *magic; /* with which files of the small bridge's formats begin; NULL: not one of them */
    const char *end; /* the last bytes of a whole file, where the decoder does not miss them */
    size_t end_length;
};

#define ENDS(text) text, sizeof text - 1

enum { EXR, TIF, TIFF, PFM, HDR, PNG, JPG, JPEG, WEBP, BMP, TGA, GIF, JP2, PPM, DPX, FORMAT_COUNT };

static const struct format formats[FORMAT_COUNT] = {
    [EXR] = {"exr", "openexr", true, true, "v/1\x01", ENDS("")},
    [TIF] = {"tif", "tiff", true, true, NULL, ENDS("")},
    [TIFF] = {"tiff", "tiff", true, true, NULL, ENDS("")},
    [PFM] = {"pfm", "pnm", true, false, "PF", ENDS("")},
    [HDR] = {"hdr", "hdr", true, false, "#?", ENDS("")},
    [PNG] = {"png", "png", false, true, "\x89PNG", ENDS("IEND\xAE\x42\x60\x82")},
    [JPG] = {"jpg", "jpeg", false, false, NULL, ENDS("")},
    [JPEG] = {"jpeg", "jpeg", false, false, NULL, ENDS("")},
    [WEBP] = {"webp", "webp", false, false, NULL, ENDS("")},
    [BMP] = {"bmp", "bmp", false, false, NULL, ENDS("")},
    [TGA] = {"tga", "targa", false, true, NULL, ENDS("TRUEVISION-XFILE.\0")},
    [GIF] = {"gif", "gif", false, false, NULL, ENDS(";")},
    [JP2] = {"jp2", "jpeg2000", false, false, NULL, ENDS("")},
    [PPM] = {"ppm", "pnm", false, false, NULL, ENDS("")},
    [DPX] = {"dpx", "dpx", false, false, NULL, ENDS("")},
};

static bool is_small(const struct format *format) {
    return format->magic != NULL;
}

/* --- formats by name -------------------------------------------------------------------------- */

/* Of names that do not tell theirs. */
static const struct format *format_of_others;

static bool is_known(const struct format *format) {
    return is_small(format) || image_plugin_is_there();
}

static const struct format *find_extension(const char *extension) {
    for (int i = 0; i < FORMAT_COUNT; i++)
        if (strcasecmp(extension, formats[i].extension) == 0)
            return is_known(formats + i) ? formats + i : NULL;
    return NULL;
}

/* " .exr .png" and so on, to be freed. */
static char *known_extensions(void) {
    struct text known = {0};
    for (int i = 0; i < FORMAT_COUNT; i++)
        if (is_known(formats + i))
            text_print(&known, " .%s", formats[i].extension);
    return known.data;
}

/* "" where the file's name has none, or is one alone: .exr is a hidden file. */
static const char *extension_of(const char *path) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path,
               *dot = strrchr(name, '.');
    return dot && dot != name ? dot + 1 : "";
}

static bool fail_unknown(const char *path, const char *extension) {
    if (output_file_is_stdout(path))
        return error_set("%s: standard output needs --format, such as png or exr", path);
    if (!*extension)
        return error_set("%s: no extension, so no picture format (try .exr or .png)", path);
    char *known = known_extensions();
    error_set("%s: unknown picture format '.%s' (known:%s)", path, extension, known);
    free(known);
    return false;
}

/* NULL after an error: no format is known, or its bridge does not open. */
static const struct format *find_format(const char *path) {
    const char *extension = extension_of(path);
    const struct format *format = find_extension(extension);
    format = format ? format : format_of_others;
    if (!format)
        fail_unknown(path, extension);
    if (!format || is_small(format) || image_plugin_get())
        return format;
    error_prefix("%s", path);
    return NULL;
}

bool image_name_tells_format(const char *path) {
    return find_extension(extension_of(path)) != NULL;
}

bool image_set_format_of_others(const char *extension) {
    format_of_others = find_extension(extension);
    if (format_of_others)
        return true;
    char *known = known_extensions();
    error_set("format: '%s' is not one of those known:%s", extension, known);
    free(known);
    return false;
}

bool image_format_is_float(const char *path, bool *is_float) {
    const struct format *format = find_format(path);
    *is_float = format && format->is_float;
    return format != NULL;
}

bool image_format_has_alpha(const char *path) {
    const struct format *format = find_format(path);
    return format &&
           (format->has_alpha ||
            error_set("%s: %s is written without alpha, which %s have", path, format->extension,
                      image_plugin_is_there() ? "png, tga, tif and exr" : "png and exr"));
}

bool image_name_holds_layers(const char *path) {
    const struct format *format = find_format(path);
    return format && (format == formats + EXR ||
                      error_set("%s: only EXR files (.exr) hold all layers", path));
}

/* --- reading ---------------------------------------------------------------------------------- */

/* By the content; NULL after an error. */
static const struct format *format_of(const unsigned char *bytes, size_t size) {
    for (int i = 0; i < FORMAT_COUNT; i++) {
        size_t length = is_small(formats + i) ? strlen(formats[i].magic) : 0;
        if (length && size > length && memcmp(bytes, formats[i].magic, length) == 0)
            return formats + i;
    }
    error_set("not a picture that this build reads (.exr .pfm .hdr .png)");
    return NULL;
}

static const struct format *format_of_file(const char *path) {
    unsigned char start[8];
    FILE *file = fopen(path, "rb");
    size_t size = file ? fread(start, 1, sizeof start, file) : 0;
    if (file)
        fclose(file);
    return format_of(start, size);
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
    bool ok = raster.has_tags ? error_set("has a camera's tags or an offset, which this build does "
                                          "not read")
                              : take_raster(image, &raster);
    raster_free(&raster);
    return ok;
}

static bool decode(struct image *image, const struct format *format,
                   const struct file_bytes *file) {
    return format == formats + PFM   ? pfm_read(image, file->data, file->size)
           : format == formats + HDR ? hdr_read(image, file->data, file->size)
                                     : read_png(image, file);
}

/* The channels of the layer alone, of a picture that has been read whole. */
static bool keep_layer(struct image *image, const char *path, const char *layer, int channels[3]) {
    int wanted[3];
    if (!image_find_layer(image, layer, channels))
        return false;
    tell_layer(image, path, layer);
    int count = sort_channels(channels, wanted), before = image->channel_count;
    const char *names[3];
    for (int i = 0; i < count; i++)
        names[i] = image->names[wanted[i]];
    if (count == before)
        return true;
    struct image kept = image_pick(image, wanted, names, count);
    kept.display = image->display;
    kept.data = image->data;
    kept.encoded = image->encoded;
    kept.cube = image->cube;
    image_free(image);
    *image = kept;
    return true;
}

static bool read_small(struct image *image, const char *path, const char *layer, int channels[3]) {
    const struct format *format = format_of_file(path);
    struct file_bytes file;
    if (!format)
        return false;
    if (format == formats + EXR)
        return exr_read(image, path, layer, channels);
    if (!file_read(&file, path))
        return false;
    bool ok = decode(image, format, &file) && (!layer || keep_layer(image, path, layer, channels));
    free(file.data);
    if (!ok)
        image_free(image);
    return ok;
}

/* OpenImageIO, for what the small bridge refused. NULL where this build lacks it: the refusal
 * stands, of the file. */
static const struct image_plugin *other_bridge(const char *path) {
    const struct image_plugin *plugin = image_plugin_is_there() ? image_plugin_get() : NULL;
    if (!plugin && path)
        error_prefix("%s", path);
    return plugin;
}

/* The other bridge reads all kinds of Radiance's files, too, but not their exposures: the refusal
 * stands. */
static bool is_for_small_alone(const char *path) {
    return format_of_file(path) == formats + HDR;
}

static bool read_stored(struct image *image, const char *path, const char *layer, int channels[3]) {
    *image = (struct image){0};
    if (!file_can_be_read(path))
        return false;
    if (read_small(image, path, layer, channels))
        return true;
    if (is_for_small_alone(path))
        return error_prefix("%s", path);
    const struct image_plugin *plugin = other_bridge(path);
    return plugin && image_plugin_end(plugin, plugin->read(image, path, layer, channels));
}

/* As the file says what its colours are. */
static void convert_colours(struct image *image, const char *path) {
    static const float none[PRIMARIES_NUMBERS];
    const bool has_unit = image->unit > 0 && isfinite(image->unit) && image->unit != 1,
               has_own = memcmp(image->primaries, none, sizeof none) != 0 &&
                         !primaries_are_bt709(image->primaries);
    float matrix[3][3];
    if (!has_own && !has_unit)
        return;
    bool spans = primaries_matrix(has_own ? image->primaries : primaries_bt709, matrix);
    if (!spans)
        primaries_matrix(primaries_bt709, matrix);
    for (int i = 0; i < 9 && has_unit; i++)
        matrix[i / 3][i % 3] *= image->unit;
    if (image_convert_colours(image, matrix) == 0)
        return;
    if (has_own)
        log_note("%s: its chromaticities %s", path,
                 spans ? "are not those of BT.709; its colours are converted"
                       : "span no colours; those of BT.709 are taken");
    if (has_unit)
        log_note("%s: its values are multiplied by its whiteLuminance, %g", path,
                 (double)image->unit);
}

static bool read_any(struct image *image, const char *path, const char *layer, int channels[3]) {
    if (!read_stored(image, path, layer, channels))
        return false;
    convert_colours(image, path);
    return true;
}

bool image_read(struct image *image, const char *path) {
    return read_any(image, path, NULL, NULL);
}

bool image_read_layer(struct image *image, const char *path, const char *layer, int channels[3]) {
    return read_any(image, path, layer, channels);
}

static bool is_whole_small(const char *path) {
    struct image image = {0};
    bool ok = read_small(&image, path, NULL, NULL);
    image_free(&image);
    return ok;
}

static bool ends_well(const char *path, const struct format *format) {
    char end[32];
    FILE *file = fopen(path, "rb");
    if (!file)
        return format->end_length == 0;
    bool ok =
        format->end_length == 0 || (fseek(file, -(long)format->end_length, SEEK_END) == 0 &&
                                    fread(end, 1, format->end_length, file) == format->end_length &&
                                    memcmp(end, format->end, format->end_length) == 0);
    fclose(file);
    return ok;
}

bool image_is_whole(const char *path) {
    const struct format *format = find_format(path);
    if (!format)
        return false;
    if (file_is_stream(path) || !ends_well(path, format))
        return error_set("%s: ends too soon", path);
    if (is_whole_small(path))
        return true;
    if (is_for_small_alone(path))
        return error_prefix("%s", path);
    const struct image_plugin *plugin = other_bridge(path);
    return plugin && image_plugin_end(plugin, plugin->check(path));
}

/* Pixels across and down, of files other than EXR: where size_only is, only as much is decoded as
 * tells them. */
static bool measure(const struct format *format, const struct file_bytes *file, bool size_only,
                    int size[2]) {
    struct raster raster = {0};
    struct image image = {0};
    bool ok = format == formats + PNG ? png_read(&raster, file->data, file->size, size_only)
                                      : decode(&image, format, file);
    size[0] = raster.width + image.width; /* one of the two is empty */
    size[1] = raster.height + image.height;
    raster_free(&raster);
    image_free(&image);
    return ok;
}

static bool read_size_small(const char *path, int size[2]) {
    const struct format *format = format_of_file(path);
    struct file_bytes file;
    if (!format)
        return false;
    if (format == formats + EXR)
        return exr_read_size(path, size);
    if (!file_read(&file, path))
        return false;
    bool ok = measure(format, &file, true, size);
    free(file.data);
    return ok;
}

bool image_size(const char *path, int size[2]) {
    if (read_size_small(path, size))
        return true;
    if (is_for_small_alone(path))
        return error_prefix("%s", path);
    const struct image_plugin *plugin = other_bridge(path);
    return plugin && image_plugin_end(plugin, plugin->read_size(path, size));
}

/* --- writing ---------------------------------------------------------------------------------- */

/* Decodes what was encoded, before a file is written. */
static bool is_encoded_well(const struct format *format, const struct text *text, int width,
                            int height) {
    const struct file_bytes file = {(unsigned char *)text->data, text->length};
    int size[2];
    bool ok = format == formats + EXR ? exr_check(text, size) : measure(format, &file, false, size);
    if (ok && (size[0] != width || size[1] != height))
        ok = error_set("it has another size");
    return ok || error_prefix("was not encoded well");
}

/* Writes and frees what the small bridge encoded, where it is ok. */
static bool write_text(const char *path, struct text *text, bool ok) {
    ok = ok ? output_file_write(path, text->data, text->length) : error_prefix("%s", path);
    free(text->data);
    return ok;
}

/* The same of OpenImageIO, whose errors name the path. */
static bool write_other(const char *path, struct file_bytes *file, bool ok) {
    ok = ok && output_file_write(path, file->data, file->size);
    free(file->data);
    return ok;
}

/* Formats that hold one layer, and have no names for it, get that one. */
static bool encode(const struct format *format, struct text *file, const struct image *image,
                   const char *layer) {
    int channels[3];
    if (format == formats + EXR)
        return exr_write(file, image);
    if (!image_find_layer(image, layer, channels))
        return false;
    if (format == formats + PFM)
        pfm_write(file, image, channels);
    else
        hdr_write(file, image, channels);
    return true;
}

static bool write_floats(const struct image *image, const char *path, const char *layer) {
    const struct format *format = find_format(path);
    struct text text = {0};
    struct file_bytes file = {0};
    if (!format)
        return false;
    if (is_small(format) && format->is_float) {
        bool ok = encode(format, &text, image, layer) &&
                  is_encoded_well(format, &text, image->width, image->height);
        return write_text(path, &text, ok);
    }
    error_set("floats are written as .exr, .pfm or .hdr");
    const struct image_plugin *plugin = other_bridge(path);
    if (!plugin)
        return false;
    return write_other(path, &file,
                       image_plugin_end(plugin, plugin->encode(&file, image, path, format->name)));
}

bool image_write(const struct image *image, const char *path) {
    return write_floats(image, path, "");
}

/* R, G and B of the layer, and the picture's alpha, which belongs to the beauty alone. */
static bool take_layer(struct image *taken, const struct image *image, const char *layer) {
    static const char *const names[] = {"R", "G", "B", "A"};
    int channels[4], count = 3;
    if (!image_find_layer(image, layer, channels))
        return false;
    channels[3] = *layer ? -1 : image_find_channel(image, "A");
    count += channels[3] >= 0;
    if (!image_fits(image->width, image->height, count))
        return false;
    *taken = image_pick(image, channels, names, count);
    return true;
}

bool image_write_layer(const struct image *image, const char *path, const char *layer) {
    const struct format *format = find_format(path);
    struct image taken;
    if (!format || is_small(format))
        return format && write_floats(image, path, layer);
    if (!take_layer(&taken, image, layer))
        return error_prefix("%s", path);
    bool ok = image_write(&taken, path);
    image_free(&taken);
    return ok;
}

static bool encode_png(struct text *file, const struct bitmap *bitmap, int channels) {
    size_t count = (size_t)bitmap->width * (size_t)bitmap->height, step = (size_t)channels;
    unsigned char *samples = mem_alloc(count, step);
    for (size_t i = 0; i < count; i++)
        memcpy(samples + step * i, bitmap->rgba + 4 * i, step);
    bool ok = png_write(file, samples, bitmap->width, bitmap->height, channels);
    free(samples);
    return ok && is_encoded_well(formats + PNG, file, bitmap->width, bitmap->height);
}

static bool write_bitmap(const struct bitmap *bitmap, const char *path, int channels) {
    const struct format *format = find_format(path);
    struct text text = {0};
    struct file_bytes file = {0};
    if (!format)
        return false;
    if (format == formats + PNG) {
        bool ok = encode_png(&text, bitmap, channels);
        return write_text(path, &text, ok);
    }
    error_set("8 bits are written as .png");
    const struct image_plugin *plugin = other_bridge(path);
    if (!plugin)
        return false;
    return write_other(path, &file,
                       image_plugin_end(plugin, plugin->encode_bitmap(&file, bitmap, channels, path,
                                                                      format->name)));
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
    if (format_of(bytes, size) == formats + PNG)
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
    if (!read_texture(&raster, bytes, size, true)) {
        const struct image_plugin *plugin = other_bridge(NULL);
        return plugin && image_plugin_end(plugin, plugin->measure_texture(bytes, size, memory));
    }
    *memory = (uint64_t)raster.width * (uint64_t)raster.height * 28 / 3; /* with MIP maps */
    return true;
}

bool bitmap_decode(struct bitmap *bitmap, const void *bytes, size_t size) {
    struct raster raster;
    *bitmap = (struct bitmap){0};
    if (!read_texture(&raster, bytes, size, false)) {
        const struct image_plugin *plugin = other_bridge(NULL);
        return plugin && image_plugin_end(plugin, plugin->decode_texture(bitmap, bytes, size));
    }
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
