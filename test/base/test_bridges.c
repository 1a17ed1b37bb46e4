/* The two bridges to picture files: OpenImageIO is opened when it is needed and not before, both
 * read the same pixels, and the program goes on without it. */
#include "command_support.h"
#include "exr_parts.h"

#include "base/file/image_plugin.h"

#include <pthread.h>

enum { WIDTH = 19, HEIGHT = 11, THREADS = 8 };

/* --- opening ---------------------------------------------------------------------------------- */

static void *get(void *result) {
    *(const struct image_plugin **)result = image_plugin_get();
    return NULL;
}

/* The first test, for the object is opened once in a process. */
TEST(threads) {
    pthread_t threads[THREADS];
    const struct image_plugin *plugins[THREADS];
    need_all_formats();
    for (int i = 0; i < THREADS; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, get, &plugins[i]), 0);
    for (int i = 0; i < THREADS; i++)
        pthread_join(threads[i], NULL);
    for (int i = 0; i < THREADS; i++) {
        assert_non_null(plugins[i]);
        assert_ptr_equal(plugins[i], plugins[0]);
    }
}

/* Whether a run of the program loads OpenImageIO. */
static void expect_loads(bool loads, const char *arguments) {
    const char *line = form("LD_DEBUG=files LD_DEBUG_OUTPUT=@/loaded %% %s", arguments);
    expect(0, "rm -f @/loaded.*");
    expect(0, line);
    expect(loads ? 0 : 1, "grep -hm1 'calling init: .*/libOpenImageIO\\.so' @/loaded.*");
}

#define RENDER "render scenes/cornell-box.glb --technique unshadowed --size 16x16 "

#define RENDER_BOX "% " RENDER "-o @/a.exr"

TEST(start) {
    need_all_formats();
    expect_loads(false, "--version");
    expect_loads(false, "info scenes/cornell-box.glb");
    expect_loads(false, RENDER "-o @/a.png -o @/a.exr -o @/a.hdr -o @/a.pfm");
    expect_loads(false, "compare @/a.exr @/a.pfm -m rmse -o @/error.png");
    expect_loads(false, RENDER "--environment scenes/day.hdr --background none -o @/b.png");
    expect_loads(true, RENDER "-o @/a.tif -o @/a.pfm");
    expect_loads(true, "compare @/a.pfm @/a.tif -m rmse --max rmse=0");
}

/* What small libraries refuse is read, and whole. */
TEST(handed_over) {
    static const struct exr_part cut = {.channels = "B G R",
                                        .data = {2, 1, 5, 3},
                                        .display = {0, 0, 8, 5},
                                        .base = 1,
                                        .cube = true};
    struct image image;
    need_all_formats();
    check_ok("windows", image_read(&image, exr_write("windows.exr", &cut, 1)));
    assert_true(image.width == 8 && image.height == 5);
    assert_true(image.cube);
    check_near("inside", image_at(&image, 3, 2)[2], exr_value(&cut, 0, 3, 2), 0);
    check_near("outside", image_at(&image, 0, 0)[2], 0, 0);
    image_free(&image);
    need_command("oiiotool --help");
    expect(0, RENDER_BOX);
    expect(0, "oiiotool @/a.exr --tile 16 16 -o @/tiles.exr && oiiotool --info -v @/tiles.exr");
    expect_text("tile size: 16 x 16");
    expect_loads(true, "compare @/tiles.exr @/a.exr -m rmse --max rmse=0");
}

/* --- without the object ----------------------------------------------------------------------- */

#define ALONE "@/alone/manylight "

static void expect_line(const char *line) {
    expect_text(line);
    assert_int_equal(count_text(output, "\n"), 1);
}

TEST(missing) {
    need_all_formats();
    expect(0, "rm -rf @/alone && mkdir @/alone && cp % @/alone/manylight");
    expect(0, ALONE RENDER "-o @/c.png -o @/c.exr");
    expect(2, ALONE RENDER "-o @/c.tif");
    expect_line("c.tif: unknown picture format '.tif' (known: .exr .pfm .hdr .png)");
    expect(0, RENDER_BOX " -o @/a.tif");
    expect(1, ALONE "compare @/a.tif @/a.exr");
    expect_line("a.tif: not a picture that this build reads (.exr .pfm .hdr .png)");
}

TEST(broken) {
    need_all_formats();
    expect(0, "echo no > @/alone/libmanylight-openimageio.so");
    expect(0, ALONE RENDER "-o @/c.png -o @/c.exr");
    expect(2, ALONE RENDER "-o @/c.tif");
    expect_line("c.tif: cannot open ");
    expect_text("libmanylight-openimageio.so: file too short");
    expect(1, ALONE "compare @/a.tif @/a.exr");
    expect_line("a.tif: cannot open ");
}

/* --- the same pixels -------------------------------------------------------------------------- */

static void check_same_window(const struct image_window *a, const struct image_window *b) {
    assert_memory_equal(a, b, sizeof *a);
}

static void check_same_image(const char *path, const char *layer) {
    OWNED(image) ours, theirs;
    int ours_at[3], theirs_at[3];
    const struct image_plugin *plugin = image_plugin_get();
    check_ok(path, layer ? image_read_layer(&ours, path, layer, ours_at) : image_read(&ours, path));
    check_ok(path, image_plugin_end(plugin, plugin->read(&theirs, path, layer, theirs_at)));
    assert_true(ours.width == theirs.width && ours.height == theirs.height);
    assert_int_equal(ours.channel_count, theirs.channel_count);
    assert_int_equal(ours.encoded, theirs.encoded);
    for (int c = 0; c < ours.channel_count; c++)
        assert_string_equal(ours.names[c], theirs.names[c]);
    if (layer)
        assert_memory_equal(ours_at, theirs_at, sizeof ours_at);
    check_same_window(&ours.display, &theirs.display);
    check_same_window(&ours.data, &theirs.data);
    size_t size =
        (size_t)ours.width * (size_t)ours.height * (size_t)ours.channel_count * sizeof(float);
    if (memcmp(ours.pixels, theirs.pixels, size) != 0)
        fail_msg("%s: the bridges read different pixels", path);
}

static void check_same_texture(const char *path) {
    struct file_bytes file;
    OWNED(bitmap) ours, theirs;
    uint64_t our_memory, their_memory;
    const struct image_plugin *plugin = image_plugin_get();
    check_ok(path, file_read(&file, path));
    check_ok(path, bitmap_measure(file.data, file.size, &our_memory));
    check_ok(path, plugin->measure_texture(file.data, file.size, &their_memory));
    assert_int_equal(our_memory, their_memory);
    check_ok(path, bitmap_decode(&ours, file.data, file.size));
    check_ok(path, image_plugin_end(plugin, plugin->decode_texture(&theirs, file.data, file.size)));
    assert_true(ours.width == theirs.width && ours.height == theirs.height);
    if (memcmp(ours.rgba, theirs.rgba, (size_t)ours.width * (size_t)ours.height * 4) != 0)
        fail_msg("%s: the bridges decode different texels", path);
    free(file.data);
}

static struct image make_image(const char *channels) {
    struct image image;
    unsigned seed = 1;
    image_init(&image, WIDTH, HEIGHT, channels);
    for (int i = 0; i < WIDTH * HEIGHT * image.channel_count; i++) {
        seed = seed * 1664525U + 1013904223U;
        image.pixels[i] = ldexpf((float)(seed >> 8), (int)(seed >> 27) - 36);
    }
    return image;
}

TEST(floats) {
    static const char *const files[] = {"floats.exr", "floats.pfm", "floats.hdr"};
    OWNED(image) image = make_image("R G B A Z direct.R direct.G direct.B normal.X");
    need_all_formats();
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        check_ok(files[i], image_write(&image, scratch(files[i])));
        check_same_image(scratch(files[i]), NULL);
        check_same_image(scratch(files[i]), "");
    }
    check_same_image(scratch("floats.exr"), "direct");
    check_same_image(scratch("floats.exr"), "Z");
}

/* Runs of bytes, the longest row that may have them, and a row that may not. */
TEST(radiance_runs) {
    static const int widths[] = {7, 8, 300, 32767};
    need_all_formats();
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        OWNED(image) image;
        image_init(&image, widths[i], 2, "R G B");
        for (int x = 0; x < 3 * 2 * widths[i]; x++)
            image.pixels[x] =
                (float)(x % 7 == 0 ? x % 3 + 1 : x / 780 + 1); /* below 256: whole mantissas */
        struct file_bytes ours, theirs;
        check_ok("write", image_write(&image, scratch("runs.hdr")));
        check_same_image(scratch("runs.hdr"), NULL);
        check_ok("read", file_read(&ours, scratch("runs.hdr")));
        check_ok("encode", image_plugin_get()->encode(&theirs, &image, "runs.hdr", "hdr"));
        printf("    %d across: %zu bytes\n", widths[i], ours.size);
        assert_int_equal(ours.size, theirs.size);
        assert_memory_equal(ours.data, theirs.data, ours.size);
        mem_free(ours.data, theirs.data);
    }
}

TEST(bitmaps) {
    unsigned char rgba[WIDTH * HEIGHT * 4];
    const struct bitmap bitmap = {WIDTH, HEIGHT, rgba};
    need_all_formats();
    for (int i = 0; i < WIDTH * HEIGHT * 4; i++)
        rgba[i] = (unsigned char)(i * 37 + i / 5);
    check_ok("opaque", bitmap_write(&bitmap, scratch("rgb.png")));
    check_ok("alpha", bitmap_write_alpha(&bitmap, scratch("rgba.png")));
    check_ok("jpeg", bitmap_write(&bitmap, scratch("rgb.jpg")));
    check_ok("webp", bitmap_write(&bitmap, scratch("rgb.webp")));
    check_same_image(scratch("rgb.png"), NULL);
    check_same_image(scratch("rgba.png"), NULL);
    check_same_image(scratch("rgba.png"), "");
    check_same_texture(scratch("rgb.png"));
    check_same_texture(scratch("rgba.png"));
    check_same_texture(scratch("rgb.jpg"));
    check_same_texture(scratch("rgb.webp"));
}

/* Kinds of PNG, JPEG, WebP, EXR that this program does not write. */
TEST(others) {
    static const struct {
        const char *file, *made_by;
        bool is_texture;
    } cases[] = {
        {"grey.png", "oiiotool @/rgba.png --ch R -o", true},
        {"grey-alpha.png", "oiiotool @/rgba.png --ch R,A --chnames Y,A -o", true},
        {"grey16.png", "oiiotool @/floats.exr --ch R -d uint16 -o", true},
        {"wide.png", "oiiotool @/floats.exr --ch R,G,B,A -d uint16 -o", true},
        {"palette.png", "convert @/rgb.png -colors 13 PNG8:", true},
        {"bits.png", "convert @/rgb.png -monochrome", true},
        {"interlaced.png", "convert @/rgba.png -interlace PNG", true},
        {"colour-key.png", "convert @/rgb.png -colors 9 -transparent white", true},
        {"offset.png", "convert @/rgb.png -page +3+5", true},
        {"named.png", "convert @/rgb.png -set Orientation 6 -set comment hello", true},
        {"grey.jpg", "convert @/rgb.png -colorspace Gray -quality 80", true},
        {"progressive.jpg", "convert @/rgb.png -interlace JPEG -quality 60", true},
        {"cmyk.jpg", "convert @/rgb.png -colorspace CMYK", true},
        {"alpha.webp", "convert @/rgba.png -quality 70", true},
        {"lossless.webp", "convert @/rgba.png -define webp:lossless=true", true},
        {"none.exr", "oiiotool @/floats.exr --compression none -o", false},
        {"zips.exr", "oiiotool @/floats.exr --compression zips -o", false},
        {"piz.exr", "oiiotool @/floats.exr --compression piz -o", false},
        {"pxr24.exr", "oiiotool @/floats.exr --compression pxr24 -o", false},
        {"b44.exr", "oiiotool @/floats.exr --compression b44 -o", false},
        {"half.exr", "oiiotool @/floats.exr -d half -o", false},
        {"half-b44.exr", "oiiotool @/floats.exr -d half --compression b44a -o", false},
        {"half-dwa.exr", "oiiotool @/floats.exr -d half --compression dwaa -o", false},
        {"turned.hdr", "oiiotool @/floats.hdr --flip -o", false},
        {"big.pfm", "convert @/floats.pfm -endian MSB", false},
    };
    need_all_formats();
    need_command("oiiotool --help");
    need_command("convert -version");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *line =
            form("%s%s@/%s", cases[i].made_by,
                 cases[i].made_by[strlen(cases[i].made_by) - 1] == ':' ? "" : " ", cases[i].file);
        if (run_line(line) != 0) /* of another version of the tool */
            continue;
        check_same_image(scratch(cases[i].file), NULL);
        if (cases[i].is_texture)
            check_same_texture(scratch(cases[i].file));
    }
}

static void write_bytes(const char *name, const struct file_bytes *parts, int count) {
    FILE *file = fopen(scratch(name), "wb");
    assert_non_null(file);
    for (int i = 0; i < count; i++)
        assert_int_equal(fwrite(parts[i].data, 1, parts[i].size, file), parts[i].size);
    assert_int_equal(fclose(file), 0);
}

#define BYTES(text)                                                                                \
    { (unsigned char *)(uintptr_t)(text), sizeof(text) - 1 }

/* Texts of a PNG by which OpenImageIO turns it: a tag in small letters, and
 * ImageMagick's profile. */
TEST(turned_png) {
    enum { HEADER = 33 };
    static const struct file_bytes texts[] = {
        BYTES("\000\000\000\015tEXtorientation\0006\276_\034\217"),
        BYTES("\000\000\000ftEXtRaw profile type exif\000\nexif\n      32\n4578696600004d4d002a"
              "00000008000101120003000000010006000000000000\n\007\220\202N"),
    };
    struct file_bytes file;
    struct image image;
    need_all_formats();
    check_ok("read", file_read(&file, scratch("rgb.png")));
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        const struct file_bytes parts[] = {
            {file.data, HEADER}, texts[i], {file.data + HEADER, file.size - HEADER}};
        write_bytes("turned.png", parts, 3);
        check_same_image(scratch("turned.png"), NULL);
        check_ok("turned", image_read(&image, scratch("turned.png")));
        assert_true(image.width == HEIGHT && image.height == WIDTH);
        image_free(&image);
    }
    free(file.data);
}

/* A row that says another width than the picture's. */
TEST(radiance_row) {
    static const struct file_bytes parts[] = {
        BYTES("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n"),
        BYTES("\2\2\0\7\207\1\207\1\207\1\207\1 and some more bytes than eight pixels"),
    };
    struct image image;
    write_bytes("row.hdr", parts, 2);
    assert_false(image_read(&image, scratch("row.hdr")));
    assert_false(image_is_whole(scratch("row.hdr")));
}

RUN_TESTS(NULL, NULL)
