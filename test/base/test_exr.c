/* EXR files as other programs, faults and strangers make them, made here byte by byte: what is read
 * is what the file holds, and all else is refused with one message, in little time and memory. */
#include "command_support.h"
#include "exr_parts.h"

#include "base/file/file.h"
#include "base/file/output_file.h"
#include "metrics/layer.h"

/* --- the format: OpenEXR File Layout, scan lines without compression -------------------------- */

enum { UINT, HALF, FLOAT };
enum { SINGLE_TILE = 0x200, DEEP = 0x800, TWO_PARTS = 0x1000 };

struct exr {
    int flags, type;        /* of its channels B G R */
    int window[4];          /* x y of the first pixel, x y of the last */
    const uint32_t *values; /* the bits of each, R G B by pixel, of one part after another; NULL: no
                               chunk follows */
};

static void put_channels(struct bytes *bytes, int type) {
    struct bytes list = {.size = 0};
    for (const char *name = "BGR"; *name; name++) {
        const char word[2] = {*name};
        put(&list, word, 2);
        put_int(&list, type);
        put_int(&list, 0); /* linear, reserved */
        put_int(&list, 1); /* a sample for each pixel */
        put_int(&list, 1);
    }
    put(&list, "", 1);
    put_attribute(bytes, "channels", "chlist", list.data, (int32_t)list.size);
}

static int width_of(const struct exr *exr) {
    return exr->window[2] - exr->window[0] + 1;
}

static int height_of(const struct exr *exr) {
    return exr->window[3] - exr->window[1] + 1;
}

/* What files need that are deep or have parts. */
static void put_part(struct bytes *bytes, const struct exr *exr, int part) {
    const char *type = exr->flags & DEEP ? "deepscanline" : "scanlineimage";
    const int32_t one = 1, chunks = height_of(exr);
    put_attribute(bytes, "name", "string", part ? "b" : "a", 1);
    put_attribute(bytes, "type", "string", type, (int32_t)strlen(type));
    put_attribute(bytes, "chunkCount", "int", &chunks, 4);
    put_attribute(bytes, "version", "int", &one, 4);
    if (exr->flags & DEEP)
        put_attribute(bytes, "maxSamplesPerPixel", "int", &one, 4);
}

static void put_header(struct bytes *bytes, const struct exr *exr, int part) {
    static const float one = 1, center[2];
    put_channels(bytes, exr->type);
    put_attribute(bytes, "compression", "compression", "", 1);
    put_attribute(bytes, "dataWindow", "box2i", exr->window, 16);
    put_attribute(bytes, "displayWindow", "box2i", exr->window, 16);
    put_attribute(bytes, "lineOrder", "lineOrder", "", 1);
    put_attribute(bytes, "pixelAspectRatio", "float", &one, 4);
    put_attribute(bytes, "screenWindowCenter", "v2f", center, 8);
    put_attribute(bytes, "screenWindowWidth", "float", &one, 4);
    if (exr->flags & (DEEP | TWO_PARTS))
        put_part(bytes, exr, part);
    put(bytes, "", 1);
}

/* Each part's table of where its lines are, then the lines of all. */
static void put_lines(struct bytes *bytes, const struct exr *exr, int parts) {
    int width = width_of(exr), height = height_of(exr), size = exr->type == HALF ? 2 : 4;
    int line = 3 * width * size, head = parts > 1 ? 12 : 8;
    uint64_t first = bytes->size + 8 * (size_t)(parts * height);
    for (int i = 0; i < parts * height; i++) {
        uint64_t offset = first + (uint64_t)(i * (head + line));
        put(bytes, &offset, 8);
    }
    for (int i = 0; i < parts * height; i++) {
        if (parts > 1)
            put_int(bytes, i / height);
        put_int(bytes, exr->window[1] + i % height);
        put_int(bytes, line);
        for (int c = 2; c >= 0; c--)
            for (int x = 0; x < width; x++)
                put(bytes, &exr->values[3 * (i * width + x) + c], (size_t)size);
    }
}

static const char *write_exr(const char *name, const struct exr *exr) {
    struct bytes bytes = {.size = 0};
    const char *path = scratch(name);
    put_int(&bytes, 20000630);
    put_int(&bytes, 2 | exr->flags);
    int parts = exr->flags & TWO_PARTS ? 2 : 1;
    for (int part = 0; part < parts; part++)
        put_header(&bytes, exr, part);
    if (exr->flags & TWO_PARTS)
        put(&bytes, "", 1);
    if (exr->values)
        put_lines(&bytes, exr, parts);
    check_ok(path, output_file_write(path, bytes.data, bytes.size));
    return path;
}

/* --- values ----------------------------------------------------------------------------------- */

static uint32_t bits_of(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static void check_values(const struct exr *exr, const char *name, const float *expected) {
    OWNED(image) image;
    bool encoded;
    check_ok(name, layer_read(&image, write_exr(name, exr), "", &encoded));
    assert_false(encoded);
    for (int i = 0; i < 6; i++) {
        printf("    %-12s %.9g, expected %.9g\n", name, (double)image.pixels[i],
               (double)expected[i]);
        assert_true(image.pixels[i] == expected[i]);
    }
}

/* The largest, the smallest normal and subnormal halves, and floats beyond them; where a window
 * does not begin at 0. */
TEST(values) {
    static const uint32_t half[6] = {0x7bff, 0xfbff, 0x0400, 0x0001, 0x3555, 0x8000};
    static const float of_half[6] = {65504, -65504, 0x1p-14F, 0x1p-24F, .333251953F, -0.F};
    static const float wide[6] = {65505, 1e6F, -1e30F, 3.4e38F, 1e-38F, 1};
    uint32_t bits[12] = {0};
    for (int i = 0; i < 6; i++)
        bits[i] = bits_of(wide[i]);
    check_values(&(struct exr){.type = HALF, .window = {0, 0, 1, 0}, .values = half}, "half.exr",
                 of_half);
    check_values(&(struct exr){.type = FLOAT, .window = {0, 0, 1, 0}, .values = bits}, "float.exr",
                 wide);
    check_values(&(struct exr){.type = FLOAT, .window = {-3, -5, -3, -4}, .values = bits},
                 "window.exr", wide);
}

/* Of two parts the first; the smaller libraries refuse them. */
TEST(two_parts) {
    static const float values[6] = {.5F, 1, 2, 4, 8, 16};
    uint32_t bits[12] = {0};
    const struct exr exr = {
        .flags = TWO_PARTS, .type = FLOAT, .window = {0, 0, 1, 0}, .values = bits};
    struct image image;
    for (int i = 0; i < 6; i++)
        bits[i] = bits_of(values[i]);
    if (knows_format("tif")) {
        check_values(&exr, "parts.exr", values);
        return;
    }
    check_refused(image_read(&image, write_exr("parts.exr", &exr)), "");
    assert_non_null(
        strstr(error_get(), "parts.exr: 2 parts, and this build reads EXR files of one"));
}

/* Channels come in the same order by whatever library: layers by name, in a layer colours and alpha
 * first. */
TEST(order) {
    static const char names[] = "normal.Z Z B albedo.B direct.R A normal.X R albedo.R normal.Y G "
                                "direct.specular.R albedo.G";
    static const char *const expected[] = {
        "R",        "G",        "B",        "A",        "Z",
        "albedo.R", "albedo.G", "albedo.B", "direct.R", "direct.specular.R",
        "normal.X", "normal.Y", "normal.Z"};
    enum { COUNT = sizeof expected / sizeof *expected };
    OWNED(image) written, read;
    image_init(&written, 3, 20, names);
    for (int i = 0; i < 3 * 20 * COUNT; i++)
        written.pixels[i] = (float)(i % 509) / 4;
    written.passes = mem_strdup("0..3,7");
    written.weight = 5;
    check_ok("write", image_write(&written, scratch("order.exr")));
    check_ok("read", image_read(&read, scratch("order.exr")));
    assert_int_equal(read.channel_count, COUNT);
    for (int c = 0; c < COUNT; c++) {
        assert_string_equal(read.names[c], expected[c]);
        int there = image_find_channel(&written, expected[c]);
        for (int i = 0; i < 3 * 20; i++)
            assert_true(image_at(&read, i % 3, i / 3)[c] ==
                        image_at(&written, i % 3, i / 3)[there]);
    }
    assert_string_equal(read.passes, "0..3,7");
    check_near("weight", read.weight, 5, 0);
}

/* What we write ourselves: half while that holds every value, else 32 bits. */
TEST(bright) {
    static const float values[2][3] = {{65504, -65504, 1}, {65520, 1e6F, 3e38F}};
    for (int k = 0; k < 2; k++) {
        OWNED(image) image, again;
        image_init(&image, 1, 1, "R G B");
        memcpy(image.pixels, values[k], sizeof values[k]);
        check_ok("written", image_write(&image, scratch("bright.exr")));
        check_ok("read", image_read(&again, scratch("bright.exr")));
        for (int c = 0; c < 3; c++) {
            printf("    %g is %g\n", (double)values[k][c], (double)again.pixels[c]);
            assert_true(again.pixels[c] == values[k][c]);
        }
    }
}

/* --- refusals --------------------------------------------------------------------------------- */

/* `compare` with itself, with 5 s of the CPU and 2 GiB. */
static void check_exr_refused(const char *name, const struct exr *exr, const char *message) {
    const char *path = write_exr(name, exr), *limit = "ulimit -v 2097152;";
#ifdef __SANITIZE_ADDRESS__
    limit = "";
#endif
    const char *command =
        form("ulimit -t 5; %s exec %s compare %s %s", limit, binary_path(), path, path);
    int status = run_command(command, output, sizeof output);
    printf("    %-16s %d %s", name, status, output);
    assert_int_equal(status, 1);
    expect_text(name);
    expect_text(message);
}

TEST(not_finite) {
    static const struct {
        const char *name;
        int type;
        uint32_t bits;
        const char *message;
    } cases[] = {
        {"half-inf.exr", HALF, 0x7c00, "inf"},
        {"half-nan.exr", HALF, 0x7e00, "nan"},
        {"float-inf.exr", FLOAT, 0xff800000, "inf"},
        {"float-nan.exr", FLOAT, 0x7fc00000, "nan"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const uint32_t values[6] = {[4] = cases[i].bits};
        check_exr_refused(
            cases[i].name,
            &(struct exr){.type = cases[i].type, .window = {0, 0, 1, 0}, .values = values},
            cases[i].message);
    }
}

TEST(shapes) {
    static const uint32_t values[6];
    static const struct {
        const char *name, *message;
        struct exr exr;
    } cases[] = {
        {"wide.exr", "", {.type = HALF, .window = {0, 0, 2147483646, 0}}},
        {"huge.exr", "", {.type = FLOAT, .window = {0, 0, 999999, 999999}}},
        {"large.exr", "", {.type = FLOAT, .window = {0, 0, 16383, 16383}}},
        {"wraps.exr", "", {.type = HALF, .window = {-2147483647, -2147483647, 2147483646, 9}}},
        {"inverse.exr", "", {.type = HALF, .window = {1, 0, 0, 0}}},
        {"none.exr", "", {.type = HALF, .window = {0, 0, 1, 0}}},
        {"deep.exr", "several depths", {DEEP, HALF, {0, 0, 1, 0}, values}},
        {"tile.exr", "", {SINGLE_TILE, HALF, {0, 0, 1, 0}, values}},
        {"whole.exr", "whole numbers", {0, UINT, {0, 0, 1, 0}, values}},
        {"unknown.exr", "", {0, 7, {0, 0, 1, 0}, values}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        check_exr_refused(cases[i].name, &cases[i].exr, cases[i].message);
}

/* --- damage ----------------------------------------------------------------------------------- */

/* Light with detail, in chunks of 16 lines that are compressed. */
static void write_noise(const char *path, struct image *image) {
    image_init(image, 24, 40, "R G B");
    for (int i = 0; i < 24 * 40 * 3; i++)
        image->pixels[i] = (float)(i * 7919 % 1009) / 1024;
    check_ok(path, image_write(image, path));
    image_free(image);
    check_ok(path, image_read(image, path));
}

static bool is_same(const struct image *a, const struct image *b) {
    return a->width == b->width && a->height == b->height && a->channel_count == b->channel_count &&
           memcmp(a->pixels, b->pixels,
                  sizeof(float) * (size_t)(a->width * a->height * a->channel_count)) == 0;
}

/* Where the table of chunks begins: three numbers that point to the chunk behind them, and on. */
static size_t find_table(const struct file_bytes *bytes) {
    for (size_t i = 8; i + 24 < bytes->size; i++) {
        uint64_t first;
        memcpy(&first, bytes->data + i, 8);
        if (first == i + 24)
            return i;
    }
    fail_msg("no table of chunks");
    return 0;
}

/* Each byte of the chunks and of their table is another: the checksums of what is compressed tell.
 * What has no checksum is where a chunk begins. */
TEST(damage) {
    struct image whole, image;
    struct file_bytes bytes;
    int refused = 0, same = 0, other = 0;
    const char *path = form("%s", scratch("damaged.exr"));
    write_noise(path, &whole);
    check_ok(path, file_read(&bytes, path));
    size_t table = find_table(&bytes);
    for (size_t i = table; i < bytes.size; i++) {
        bytes.data[i] ^= (unsigned char)(1 + i % 255);
        FILE *file = fopen(path, "wb");
        assert_int_equal(fwrite(bytes.data, 1, bytes.size, file), bytes.size);
        fclose(file);
        bytes.data[i] ^= (unsigned char)(1 + i % 255);
        bool read = image_read(&image, path);
        refused += !read;
        same += read && is_same(&image, &whole);
        if (read && !is_same(&image, &whole))
            printf("    byte %zu of %zu\n", i, bytes.size), other++;
        image_free(&image);
    }
    printf("    of %zu bytes from %zu on: %d refused, %d the same, %d read wrong\n", bytes.size,
           table, refused, same, other);
    assert_int_equal(other, 0);
    free(bytes.data);
    image_free(&whole);
}

RUN_TESTS(NULL, NULL)
