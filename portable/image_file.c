/* Picture files without OpenImageIO, for `make portable`: PFM (the beauty layer) and 8-bit PNG.
 * Textures are decoded by stb_image. The only place that names stb. */
#include "base/file/image_file.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "base/text.h"

#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of names that do not tell theirs; "" = none. */
static const char *extension_of_others = "";

static const char *own_extension(const char *path) {
    static const char *const known[] = {"pfm", "png"};
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof known / sizeof *known; i++)
        if (strcmp(dot + 1, known[i]) == 0)
            return known[i];
    return NULL;
}

static bool has_extension(const char *path, const char *extension) {
    const char *own = own_extension(path);
    return strcmp(own ? own : extension_of_others, extension) == 0;
}

bool image_name_tells_format(const char *path) {
    return own_extension(path) != NULL;
}

bool image_set_format_of_others(const char *extension) {
    char *name = mem_printf(".%s", extension);
    const char *known = own_extension(name);
    free(name);
    if (!known)
        return error_set("format: '%s' is neither pfm nor png", extension);
    extension_of_others = known;
    return true;
}

bool image_format_has_alpha(const char *path) {
    return has_extension(path, "png") || error_set("%s: of this build .png alone has alpha", path);
}

bool image_name_holds_layers(const char *path) {
    return error_set("%s: only EXR files hold all layers, which this build does not write", path);
}

bool image_format_is_float(const char *path, bool *is_float) {
    *is_float = has_extension(path, "pfm");
    return *is_float || has_extension(path, "png") ||
           error_set("%s: this build writes .pfm and .png alone", path);
}

/* Rows from the bottom up, little-endian: the sign of the scale says so. */
static void append_pfm(struct text *file, const struct image *image, const int channels[3]) {
    text_print(file, "PF\n%d %d\n-1.0\n", image->width, image->height);
    for (int y = image->height - 1; y >= 0; y--)
        for (int x = 0; x < image->width; x++)
            for (int c = 0; c < 3; c++)
                text_append(file, image_at(image, x, y) + channels[c], sizeof(float));
}

bool image_write(const struct image *image, const char *path) {
    int channels[3];
    struct text file = {0};
    if (!has_extension(path, "pfm"))
        return error_set("%s: this build writes floats to .pfm alone", path);
    if (!image_find_layer(image, "", channels))
        return error_prefix("%s", path);
    append_pfm(&file, image, channels);
    bool ok = output_file_write(path, file.data, file.length);
    free(file.data);
    return ok;
}

static bool write_bitmap(const struct bitmap *bitmap, const char *path, int channels) {
    size_t count = (size_t)bitmap->width * (size_t)bitmap->height, step = (size_t)channels;
    unsigned char *pixels = mem_alloc(count, step);
    for (size_t i = 0; i < count; i++)
        memcpy(pixels + step * i, bitmap->rgba + 4 * i, step);
    int size;
    unsigned char *png =
        stbi_write_png_to_mem(pixels, 0, bitmap->width, bitmap->height, channels, &size);
    bool ok =
        png ? output_file_write(path, png, (size_t)size) : error_set("%s: cannot be encoded", path);
    STBIW_FREE(png);
    free(pixels);
    return ok;
}

bool bitmap_write(const struct bitmap *bitmap, const char *path) {
    return write_bitmap(bitmap, path, 3);
}

bool bitmap_write_alpha(const struct bitmap *bitmap, const char *path) {
    return image_format_has_alpha(path) && write_bitmap(bitmap, path, 4);
}

static bool read_pfm(FILE *file, struct image *image, const char *path) {
    int width, height;
    double scale;
    enum { SIDE_MAX = 16384 };
    if (fscanf(file, "PF %d %d %lf", &width, &height, &scale) != 3 || fgetc(file) != '\n' ||
        width < 1 || height < 1 || width > SIDE_MAX || height > SIDE_MAX || scale >= 0)
        return error_set("%s: not a little-endian PFM in colour, which this build reads alone",
                         path);
    image_init(image, width, height, "R G B");
    size_t row = 3 * (size_t)width;
    for (int y = height - 1; y >= 0; y--)
        if (fread(image_at(image, 0, y), sizeof(float), row, file) != row) {
            image_free(image);
            return error_set("%s: ends too soon", path);
        }
    return true;
}

bool image_read(struct image *image, const char *path) {
    *image = (struct image){0};
    FILE *file = fopen(path, "rb");
    if (!file)
        return error_set("cannot open %s: %s", path, strerror(errno));
    bool ok = read_pfm(file, image, path);
    fclose(file);
    return ok;
}

bool image_read_layer(struct image *image, const char *path, const char *layer, int channels[3]) {
    if (!image_read(image, path))
        return false;
    if (image_find_layer(image, layer, channels))
        return true;
    image_free(image);
    return error_prefix("%s", path);
}

static bool read_png(struct bitmap *bitmap, const char *path) {
    static const char end[] = "IEND\xAE\x42\x60\x82";
    struct file_bytes bytes;
    if (!file_read(&bytes, path))
        return false;
    bool ok = bytes.size > 8 && memcmp(bytes.data + bytes.size - 8, end, 8) == 0;
    ok = ok ? bitmap_decode(bitmap, bytes.data, bytes.size) || error_prefix("%s", path)
            : error_set("%s: ends too soon", path);
    free(bytes.data);
    return ok;
}

bool image_size(const char *path, int size[2]) {
    struct image image = {0};
    struct bitmap bitmap = {0};
    bool is_png = has_extension(path, "png");
    bool ok = is_png ? read_png(&bitmap, path) : image_read(&image, path);
    size[0] = is_png ? bitmap.width : image.width;
    size[1] = is_png ? bitmap.height : image.height;
    bitmap_free(&bitmap);
    image_free(&image);
    return ok;
}

bool image_is_whole(const char *path) {
    int size[2];
    return image_size(path, size);
}

bool bitmap_measure(const void *bytes, size_t size, uint64_t *memory) {
    int width, height, channels;
    if (size > INT_MAX)
        return error_set("picture: too large");
    if (!stbi_info_from_memory(bytes, (int)size, &width, &height, &channels))
        return error_set("not a picture of a known format: %s", stbi_failure_reason());
    *memory = (uint64_t)width * (uint64_t)height * 28 / 3; /* RGBA8, and RGBA8 with MIP maps */
    return true;
}

bool bitmap_decode(struct bitmap *bitmap, const void *bytes, size_t size) {
    int channels;
    *bitmap = (struct bitmap){0};
    if (size > INT_MAX)
        return error_set("picture: too large");
    stbi_uc *rgba =
        stbi_load_from_memory(bytes, (int)size, &bitmap->width, &bitmap->height, &channels, 4);
    if (!rgba)
        return error_set("not a picture of a known format: %s", stbi_failure_reason());
    size_t count = (size_t)bitmap->width * (size_t)bitmap->height;
    bitmap->rgba = mem_alloc(count, 4);
    memcpy(bitmap->rgba, rgba, 4 * count);
    stbi_image_free(rgba);
    return true;
}
