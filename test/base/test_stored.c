/* Pictures of other programs, made byte by byte: colours are as stored whatever alpha is, and
 * pictures stand upright however their lines lie. */
#include "bytes.h"
#include "command_support.h"

#include "base/file/output_file.h"
#include "base/file/webp.h"
#include "metrics/colour.h"
#include "metrics/layer.h"
#include "scene/lights/environment.h"

static void put_number(struct bytes *bytes, unsigned value, int size, bool big_endian) {
    for (int i = 0; i < size; i++) {
        unsigned char byte = (unsigned char)(value >> 8 * (big_endian ? size - 1 - i : i));
        put(bytes, &byte, 1);
    }
}

static const char *write_bytes(const char *name, const struct bytes *bytes) {
    const char *path = scratch(name);
    check_ok(path, output_file_write(path, bytes->data, bytes->size));
    return path;
}

/* --- formats ---------------------------------------------------------------------------------- */

static unsigned crc_of(const unsigned char *bytes, size_t size) {
    unsigned crc = ~0U;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320U : 0);
    }
    return ~crc;
}

static void put_chunk(struct bytes *png, const char *name, const struct bytes *data) {
    put_number(png, (unsigned)data->size, 4, true);
    size_t from = png->size;
    put(png, name, 4);
    put(png, data->data, data->size);
    put_number(png, crc_of(png->data + from, png->size - from), 4, true);
}

/* Lines of a filter byte and samples, as one block that is not compressed. */
static const char *write_png(const char *name, int width, int height, int depth, int type,
                             const unsigned char *samples, size_t line) {
    struct bytes png = {.size = 0}, head = {.size = 0}, raw = {.size = 0}, data = {.size = 0};
    unsigned a = 1, b = 0;
    put(&png, "\x89PNG\r\n\x1a\n", 8);
    put_number(&head, (unsigned)width, 4, true);
    put_number(&head, (unsigned)height, 4, true);
    put(&head, (const unsigned char[]){(unsigned char)depth, (unsigned char)type, 0, 0, 0}, 5);
    put_chunk(&png, "IHDR", &head);
    for (int y = 0; y < height; y++) {
        put(&raw, "", 1);
        put(&raw, samples + (size_t)y * line, line);
    }
    put(&data, "\x78\x01\x01", 3);
    put_number(&data, (unsigned)raw.size, 2, false);
    put_number(&data, ~(unsigned)raw.size, 2, false);
    put(&data, raw.data, raw.size);
    for (size_t i = 0; i < raw.size; i++) {
        a = (a + raw.data[i]) % 65521;
        b = (b + a) % 65521;
    }
    put_number(&data, b << 16 | a, 4, true);
    put_chunk(&png, "IDAT", &data);
    put_chunk(&png, "IEND", &(struct bytes){.size = 0});
    return write_bytes(name, &png);
}

/* TIFF: a header, samples, and tags of their shape. extra: 0 none, 1 associated, 2 unassociated. */
struct tiff {
    int width, height, channels, bits, extra, orientation;
    bool is_float;
};

static void put_tag(struct bytes *bytes, int tag, int value) {
    put_number(bytes, (unsigned)tag, 2, false);
    put_number(bytes, 4, 2, false); /* LONG */
    put_number(bytes, 1, 4, false);
    put_number(bytes, (unsigned)value, 4, false);
}

/* Up to two lie in the tag itself. */
static void put_tags(struct bytes *file, int tag, int count, int value, int at) {
    put_number(file, (unsigned)tag, 2, false);
    put_number(file, 3, 2, false); /* SHORT */
    put_number(file, (unsigned)count, 4, false);
    int within = count == 2 ? value << 16 | value : value;
    put_number(file, (unsigned)(count > 2 ? at : within), 4, false);
}

static const char *write_tiff(const char *name, const struct tiff *tiff, const void *samples) {
    struct bytes file = {.size = 0};
    size_t size = (size_t)(tiff->width * tiff->height * tiff->channels * tiff->bits / 8);
    put(&file, "II*\0", 4);
    put_number(&file, (unsigned)(8 + 32 + size), 4, false);
    for (int i = 0; i < 8; i++) /* bits of each channel, then kinds of each */
        put_number(&file, (unsigned)tiff->bits, 2, false);
    for (int i = 0; i < 8; i++)
        put_number(&file, tiff->is_float ? 3 : 1, 2, false);
    put(&file, samples, size);
    put_number(&file, tiff->extra ? 12 : 11, 2, false);
    put_tag(&file, 256, tiff->width);
    put_tag(&file, 257, tiff->height);
    put_tags(&file, 258, tiff->channels, tiff->bits, 8);
    put_tag(&file, 259, 1);
    put_tag(&file, 262, tiff->channels >= 3 ? 2 : 1);
    put_tag(&file, 273, 8 + 32);
    put_tag(&file, 274, tiff->orientation ? tiff->orientation : 1);
    put_tag(&file, 277, tiff->channels);
    put_tag(&file, 278, tiff->height);
    put_tag(&file, 279, (int)size);
    if (tiff->extra)
        put_tags(&file, 338, 1, tiff->extra, 0);
    put_tags(&file, 339, tiff->channels, tiff->is_float ? 3 : 1, 24);
    put_number(&file, 0, 4, false);
    return write_bytes(name, &file);
}

/* Type 2: colours, 3: grey. Lines from the top. */
static const char *write_tga(const char *name, int type, int width, int height, int channels,
                             const unsigned char *samples) {
    struct bytes tga = {.size = 0};
    put(&tga, (const unsigned char[]){0, 0, (unsigned char)type}, 3);
    put(&tga, (const unsigned char[9]){0}, 9);
    put_number(&tga, (unsigned)width, 2, false);
    put_number(&tga, (unsigned)height, 2, false);
    put(&tga, (const unsigned char[]){(unsigned char)(8 * channels), 0x28}, 2);
    put(&tga, samples, (size_t)(width * height * channels));
    return write_bytes(name, &tga);
}

/* --- alpha ------------------------------------------------------------------------------------ */

/* Of two pixels, with alpha 128 and 0; TGA stores blue first. */
static const unsigned char rgba[8] = {200, 100, 50, 128, 10, 20, 30, 0},
                           bgra[8] = {50, 100, 200, 128, 30, 20, 10, 0},
                           grey_alpha[4] = {200, 128, 10, 0};

static void check_stored(const char *path, const float expected[6]) {
    OWNED(image) layer;
    bool encoded;
    check_ok(path, layer_read(&layer, path, "", &encoded));
    assert_true(layer.width == 2 && layer.height == 1);
    for (int i = 0; i < 6; i++)
        check_near(path, (double)layer.pixels[i], (double)expected[i], 1e-6);
}

static void check_encoded(const char *path, bool grey) {
    float expected[6];
    for (int i = 0; i < 6; i++)
        expected[i] =
            srgb_decode((float)(grey ? grey_alpha[i / 3 * 2] : rgba[i / 3 * 4 + i % 3]) / 255);
    check_stored(path, expected);
}

TEST(alpha) {
    unsigned char deep[16];
    for (int i = 0; i < 16; i++)
        deep[i] = rgba[i / 2]; /* v * 257 */
    check_encoded(write_png("rgba8.png", 2, 1, 8, 6, rgba, 8), false);
    check_encoded(write_png("rgba16.png", 2, 1, 16, 6, deep, 16), false);
    check_encoded(write_png("grey-alpha.png", 2, 1, 8, 4, grey_alpha, 4), true);
    if (!knows_format("tif"))
        return;
    check_encoded(write_tga("bgra.tga", 2, 2, 1, 4, bgra), false);
    check_encoded(write_tga("grey-alpha.tga", 3, 2, 1, 2, grey_alpha), true);
    for (int extra = 1; extra <= 2; extra++) { /* what is times alpha in the file stays so */
        check_encoded(write_tiff("rgba8.tif", &(struct tiff){2, 1, 4, 8, extra, 1, false}, rgba),
                      false);
        check_encoded(write_tiff("rgba16.tif", &(struct tiff){2, 1, 4, 16, extra, 1, false}, deep),
                      false);
        check_encoded(
            write_tiff("grey.tif", &(struct tiff){2, 1, 2, 8, extra, 1, false}, grey_alpha), true);
        static const float wide[8] = {3, .5F, -1, .25F, 7, 1e6F, .125F, 0},
                           colours[6] = {3, .5F, -1, 7, 1e6F, .125F};
        check_stored(write_tiff("float.tif", &(struct tiff){2, 1, 4, 32, extra, 1, true}, wide),
                     colours);
    }
}

/* Without loss, and with loss in a file of chunks, whose second pixel no alpha covers. */
static const unsigned char lossless[42] =
    "\x52\x49\x46\x46\x22\x00\x00\x00\x57\x45\x42\x50\x56\x50\x38\x4c\x15\x00\x00\x00\x2f\x01\x00"
    "\x00"
    "\x10\x0f\x70\x0a\xa8\x2b\xf8\x9e\xc2\x63\x00\x83\x16\x19\xd1\xff\x00";
static const unsigned char lossy[118] =
    "\x52\x49\x46\x46\x6e\x00\x00\x00\x57\x45\x42\x50\x56\x50\x38\x58\x0a\x00\x00\x00\x10\x00\x00"
    "\x00"
    "\x01\x00\x00\x00\x00\x00\x41\x4c\x50\x48\x03\x00\x00\x00\x00\x80\x00\x00\x56\x50\x38\x20\x44"
    "\x00"
    "\x00\x00\xb0\x02\x00\x9d\x01\x2a\x02\x00\x01\x00\x00\x00\x00\x25\xa0\x02\x74\xba\x01\xf8\x01"
    "\xfa"
    "\x01\xfc\x00\x06\x65\x58\x8c\xc0\x00\xfe\xff\xff\x70\xff\xff\xb8\xb8\xbf\xfd\x0d\xbf\xfe\xc8"
    "\x41"
    "\xe7\xff\xe4\x83\xd7\x93\xcf\xcf\xfc\x90\x8f\xff\xb5\x27\xeb\xcc\x1c\xaf\xfe\xd3\x20";
static const unsigned char of_lossy[8] = {201, 100, 50, 128, 95, 0, 0, 0};

TEST(webp) {
    struct bytes file = {.size = 0};
    struct bitmap texture;
    float expected[6];
    put(&file, lossless, sizeof lossless);
    if (knows_format("webp"))
        check_encoded(write_bytes("lossless.webp", &file), false);
    check_ok("texture", bitmap_decode(&texture, lossless, sizeof lossless));
    assert_memory_equal(texture.rgba, rgba, sizeof rgba);
    bitmap_free(&texture);
    file.size = 0;
    put(&file, lossy, sizeof lossy);
    for (int i = 0; i < 6; i++)
        expected[i] = srgb_decode((float)of_lossy[i / 3 * 4 + i % 3] / 255);
    if (knows_format("webp"))
        check_stored(write_bytes("lossy.webp", &file), expected);
    check_ok("texture", bitmap_decode(&texture, lossy, sizeof lossy));
    assert_memory_equal(texture.rgba, of_lossy, sizeof of_lossy);
    bitmap_free(&texture);
    for (size_t size = 0; size < sizeof lossy; size++) { /* cut anywhere */
        unsigned char cut[sizeof lossy];
        memcpy(cut, lossy, sizeof lossy);
        assert_int_equal(webp_hide_alpha(cut, size), size > 24);
    }
}

/* OpenImageIO gives colours of a map of 16 bits in 8, cut: those that 8 bits hold exactly, others
 * up to 1/255 less. */
TEST(palette) {
    enum { WIDTH = 6, ENTRIES = 16 };
    static const unsigned map[WIDTH][3] = {
        {29 * 257, 100 * 257, 65535}, {7533, 65534, 1},     {0, 256, 257}, {513, 514, 515},
        {0x1D00, 0x8000, 0xFF00},     {32767, 32768, 32769}};
    const unsigned map_at = 16, tags_at = map_at + 6 * ENTRIES;
    struct bytes file = {.size = 0};
    OWNED(image) image;
    put(&file, "II*\0", 4);
    put_number(&file, tags_at, 4, false);
    for (unsigned i = 0; i < WIDTH; i += 2) /* two pixels of 4 bits a byte */
        put_number(&file, i << 4 | (i + 1), 1, false);
    file.size = map_at;
    for (int i = 0; i < 3 * ENTRIES; i++)
        put_number(&file, i % ENTRIES < WIDTH ? map[i % ENTRIES][i / ENTRIES] : 0, 2, false);
    put_number(&file, 9, 2, false);
    put_tag(&file, 256, WIDTH);
    put_tag(&file, 257, 1);
    put_tag(&file, 258, 4);
    put_tag(&file, 259, 1);
    put_tag(&file, 262, 3);
    put_tag(&file, 273, 8);
    put_tag(&file, 278, 1);
    put_tag(&file, 279, WIDTH / 2);
    put_tags(&file, 320, 3 * ENTRIES, 0, (int)map_at);
    put_number(&file, 0, 4, false);
    check_ok("palette", image_read(&image, write_bytes("palette.tif", &file)));
    assert_true(image.width == WIDTH && image.channel_count == 3);
    for (int x = 0; x < WIDTH; x++)
        for (int c = 0; c < 3; c++) {
            double value = (double)image_at(&image, x, 0)[c], exact = map[x][c] / 65535.;
            check_near("colour in 8 bits", value, map[x][c] / 257 / 255., 1e-6);
            assert_true(value <= exact + 1e-6 && value > exact - 1 / 255.);
        }
}

/* Ours keep every value where the format has room for it, alpha 0 or not. */
TEST(written) {
    static const char *const names[] = {"own.exr", "own.tif"};
    for (int i = 0; i < (knows_format("tif") ? 2 : 1); i++) {
        OWNED(image) image, again;
        image_init(&image, 2, 1, "R G B A");
        memcpy(image.pixels, (const float[8]){1, .5F, .25F, .5F, 8, 4, 2, 0}, 8 * sizeof(float));
        check_ok(names[i], image_write(&image, scratch(names[i])));
        check_ok(names[i], image_read(&again, scratch(names[i])));
        assert_int_equal(again.channel_count, 4);
        assert_memory_equal(image.pixels, again.pixels, 8 * sizeof(float));
    }
}

/* --- upright ---------------------------------------------------------------------------------- */

/* Columns and rows of the upright picture: its value at (x, y) is 1 + x + 3 y, in all colours. */
enum { WIDE = 3, HIGH = 2 };

static void check_upright(const char *path, double scale) {
    OWNED(image) layer;
    bool encoded;
    check_ok(path, layer_read(&layer, path, "", &encoded));
    assert_true(layer.width == WIDE && layer.height == HIGH);
    for (int y = 0; y < HIGH; y++)
        for (int x = 0; x < WIDE; x++) {
            double value = (double)image_at(&layer, x, y)[0];
            if (encoded)
                value = (double)srgb_encode((float)value);
            check_near(path, value, (1 + x + WIDE * y) * scale, 1e-6);
        }
}

/* The upright picture's value that is stored at (column, row) by TIFF's orientation. */
static int stored_value(int orientation, int column, int row) {
    bool transposed = orientation >= 5;
    bool from_right = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    bool from_below = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    int x = transposed ? row : column, y = transposed ? column : row;
    return 1 + (from_right ? WIDE - 1 - x : x) + WIDE * (from_below ? HIGH - 1 - y : y);
}

/* Row 0 of orientation 6 is the picture's right side, from top to bottom: the standard's words. */
TEST(orientation_table) {
    assert_int_equal(stored_value(6, 0, 0), 3);
    assert_int_equal(stored_value(6, 1, 0), 6);
    assert_int_equal(stored_value(8, 0, 0), 4); /* its left side, from the bottom up */
    assert_int_equal(stored_value(8, 1, 0), 1);
}

TEST(tiff_orientation) {
    need_all_formats();
    for (int o = 1; o <= 8; o++) {
        unsigned char samples[WIDE * HIGH];
        int width = o >= 5 ? HIGH : WIDE, height = o >= 5 ? WIDE : HIGH;
        for (int i = 0; i < WIDE * HIGH; i++)
            samples[i] = (unsigned char)(40 * stored_value(o, i % width, i / width));
        check_upright(
            write_tiff("turned.tif", &(struct tiff){width, height, 1, 8, 0, o, false}, samples),
            40. / 255);
    }
}

/* Radiance's lines by their resolution line; RGBE of small whole numbers is exact. */
static const char *write_hdr(const char *name, const char *order, int orientation) {
    struct bytes file = {.size = 0};
    int width = orientation >= 5 ? HIGH : WIDE;
    put(&file, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n", 35);
    put(&file, order, strlen(order));
    for (int i = 0; i < WIDE * HIGH; i++) {
        unsigned char value = (unsigned char)(16 * stored_value(orientation, i % width, i / width));
        put(&file, (const unsigned char[]){value, value, value, 128 + 4}, 4);
    }
    return write_bytes(name, &file);
}

TEST(hdr_orders) {
    need_all_formats();
    static const struct {
        const char *order;
        int orientation; /* in which TIFF would say the same */
    } cases[] = {{"-Y 2 +X 3\n", 1}, {"-Y 2 -X 3\n", 2}, {"+Y 2 -X 3\n", 3}, {"+Y 2 +X 3\n", 4},
                 {"+X 3 -Y 2\n", 5}, {"-X 3 -Y 2\n", 6}, {"-X 3 +Y 2\n", 7}, {"+X 3 +Y 2\n", 8}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        printf("    %s", cases[i].order);
        check_upright(write_hdr("turned.hdr", cases[i].order, cases[i].orientation), 1);
    }
}

/* A sky of 2x1 texels, mirrored in the file. */
TEST(sky) {
    need_all_formats();
    static const char *const orders[] = {"-Y 1 +X 2\n", "+Y 1 -X 2\n", "+X 2 +Y 1\n",
                                         "-X 2 -Y 1\n"};
    for (int i = 0; i < 4; i++) {
        struct bytes file = {.size = 0};
        struct environment sky;
        bool mirrored = strstr(orders[i], "-X") != NULL;
        put(&file, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n", 35);
        put(&file, orders[i], strlen(orders[i]));
        put(&file,
            mirrored ? "\x40\x40\x40\x81\x80\x80\x80\x81" : "\x80\x80\x80\x81\x40\x40\x40\x81", 8);
        check_ok(orders[i], environment_load(&sky, write_bytes("sky.hdr", &file)));
        assert_int_equal(sky.width, 2);
        check_near("left", (double)sky.texels[0][0], 1, 1e-6);
        check_near("right", (double)sky.texels[1][0], .5, 1e-6);
        mem_free(sky.texels, sky.path);
    }
}

/* The case of the list: the sky of either file lights the plane with 1. */
TEST(case) {
    need_all_formats();
    if (!shared_path())
        return;
    const char *folder = form("%s/cases/sky-bottom-up", shared_path());
    expect(0, form("%% compare %s/plus-y.hdr %s/minus-y.hdr -m rmse", folder, folder));
    check_near("rmse", strtod(strstr(output, "rmse") + 4, NULL), 0, 0);
}

RUN_TESTS(NULL, NULL)
