/* Files that a scene names, and data in its URIs: where they may lie, and how they may
 * be written. */
#define _GNU_SOURCE
#include "command_support.h"
#include "hostile_numbers.h"

#include "base/file/file.h"
#include "scene/read_rules.h"

#include <sys/stat.h>
#include <unistd.h>

static const int colour[3] = {200, 100, 50};

/* A picture of one colour, in the format of the name's extension. */
static void write_colour(const char *path) {
    unsigned char rgba[16 * 16 * 4];
    for (int i = 0; i < 16 * 16; i++)
        for (int c = 0; c < 4; c++)
            rgba[i * 4 + c] = (unsigned char)(c < 3 ? colour[c] : 255);
    remove(path);
    check_ok(path, bitmap_write(&(struct bitmap){16, 16, rgba}, path));
}

/* A scene in the folder "model" whose quad has the picture of that name; its path. */
static const char *write_textured(const char *uri) {
    static char more[1 << 14];
    snprintf(more, sizeof more, "images: [{uri: '%s'}], textures: [{source: 0}],", uri);
    mkdir(scratch("model"), 0777);
    return write_parts("model/scene.glb", &PARTS(.materials = TEXTURED, .more = more));
}

static bool has_colour(const struct scene *scene) {
    const struct material *material = &scene->materials[0];
    const unsigned char *rgba = scene->textures[material->base_color_texture].bitmap.rgba;
    bool good = true;
    for (int c = 0; c < 3; c++)
        good &= abs(rgba[c] - colour[c]) <= 3; /* of a lossy format */
    if (!good)
        printf("    %d %d %d\n", rgba[0], rgba[1], rgba[2]);
    return good;
}

static void check_shown(const char *uri) {
    struct scene scene;
    check_ok("not strict", read_rules_set(true, read_rules_root()));
    check_ok(uri, scene_load(&scene, write_textured(uri)));
    check_ok("not strict", read_rules_set(false, read_rules_root()));
    bool good = has_colour(&scene);
    scene_free(&scene);
    printf("    %-52.52s %s\n", uri, good ? "shown" : "wrong");
    assert_true(good);
}

static const char *absolute(const char *name) {
    static char path[4096];
    char real[4096];
    assert_non_null(realpath(scratch(""), real));
    snprintf(path, sizeof path, "%.2000s/%s", real, name);
    return path;
}

/* The folder, below the test's, that --root is told to be; NULL = all of the machine, which is not
 * told. */
static void check_hint(const char *text, const char *folder) {
    char hint[5000] = "(--root DIR names another)", real[4096];
    if (folder && realpath(scratch(folder), real))
        snprintf(hint, sizeof hint, "(--root %s allows it)", real);
    assert_non_null(strstr(text, "leads out of the folder "));
    if (!strstr(text, hint))
        fail_msg("'%s' is not in: %s", hint, text);
}

static void check_outside(const char *uri, const char *folder) {
    struct scene scene;
    check_refused(scene_load(&scene, write_textured(uri)), "");
    check_hint(error_get(), folder);
}

/* A name of another machine: the file is not opened, whether it is there or not. */
static void check_elsewhere(const char *uri, const char *hint) {
    struct scene scene;
    hear_notes();
    check_ok(uri, scene_load(&scene, write_textured(uri)));
    end_notes();
    const unsigned char *rgba = scene.textures[scene.materials[0].base_color_texture].bitmap.rgba;
    bool is_magenta = rgba[0] == 255 && rgba[1] == 0 && rgba[2] == 255;
    int files = scene.file_count;
    scene_free(&scene);
    printf("    %-40s %s", uri, notes);
    assert_true(is_magenta);
    assert_int_equal(files, 0);
    assert_non_null(strstr(notes, "colours by a magenta checker: image 0: "));
    if (!strstr(notes, hint))
        fail_msg("'%s' is not in: %s", hint, notes);
    check_ok("strict", read_rules_set(true, read_rules_root()));
    assert_false(scene_load(&scene, write_textured(uri)));
    check_ok("not strict", read_rules_set(false, read_rules_root()));
}

static void link_to(const char *target, const char *name) {
    unlink(scratch(name));
    assert_int_equal(symlink(target, scratch(name)), 0);
}

static void make_folders(void) {
    mkdir(scratch("model"), 0777);
    mkdir(scratch("model/a"), 0777);
    mkdir(scratch("textures"), 0777);
    write_colour(scratch("textures/x.png"));
    write_colour(scratch("model/a/y.png"));
    write_colour(scratch("model/a b+%41.png"));
    write_colour(scratch("../outside-of-named-files.png"));
    link_to("../textures/x.png", "model/link.png");
    link_to("../textures", "model/linked");
    link_to("../../outside-of-named-files.png", "model/out.png");
    link_to("/", "model/slash");
}

TEST(paths) {
    char uri[8192];
    make_folders();
    check_shown("../textures/x.png");
    check_shown("a/../a/y.png");
    check_shown("nowhere/../a/y.png");
    check_shown("./a/.//y.png");
    check_shown("%2e%2E/textures%2Fx.png");
    check_shown("..\\\\textures\\\\x.png");
    check_shown("a\\\\y.png");
    check_shown("a/y.png?v=2");
    check_shown("../textures\\\\x.png#sharp?v=2");
    check_shown("a b+%41.png?width=9&height=9");
    check_shown("link.png");
    check_shown("linked/x.png");
    check_shown("a%20b+%2541.png");
    check_shown("a b+%41.png");
    snprintf(uri, sizeof uri, "%s", absolute("textures/x.png"));
    check_shown(uri);
    snprintf(uri, sizeof uri, "file://%s", absolute("textures/x.png"));
    check_shown(uri);
    check_outside("../../outside-of-named-files.png", "..");
    check_outside("../../no-such-file.png", "..");
    check_outside("a/../../../outside-of-named-files.png", "..");
    check_outside("..\\\\..\\\\outside-of-named-files.png", "..");
    check_outside("out.png", "..");
    check_outside("slash/etc/passwd", NULL);
}

TEST(other_machines) {
    char real[4096];
    const char nowhere[] = "(--root DIR names another)";
    make_folders();
    check_elsewhere("/etc/passwd", nowhere);
    check_elsewhere("/no/such/file.png", nowhere);
    check_elsewhere("file:///etc/passwd", nowhere);
    check_elsewhere("file:/etc/passwd", nowhere);
    check_elsewhere("file:///C:/Users/x/tex.png", nowhere);
    check_elsewhere("C:\\\\Users\\\\x\\\\tex.png", "tex.png: No such file");
    check_elsewhere("C:/Users/x/tex.png", "tex.png: No such file");
    check_elsewhere("\\\\\\\\server\\\\x\\\\tex.png", nowhere);
    check_elsewhere("http://example.org/tex.png", "is a URL, which is not fetched");
    check_elsewhere("https://example.org/a/tex.png?x=1", "is a URL, which is not fetched");
    static const char *const names[] = {"outside-of-named-files.png", "no-such-file.png"};
    assert_non_null(realpath(scratch(".."), real));
    const char *hint = form("(--root %s allows it)", real);
    for (int i = 0; i < 2; i++) {
        const char *uri = form("%s/%s", absolute(".."), names[i]);
        check_elsewhere(uri, hint);
    }
    check_elsewhere(absolute("textures/none.png"), "No such file");
}

/* A cache of a model hub: all files are links into a store two levels up. */
TEST(hub) {
    static const char *const folders[] = {"hub", "hub/blobs", "hub/snapshots",
                                          "hub/snapshots/0a1b"};
    struct scene scene;
    for (int i = 0; i < 4; i++)
        mkdir(scratch(folders[i]), 0777);
    write_colour(scratch("hub/tex.png"));
    rename(scratch("hub/tex.png"), scratch("hub/blobs/77"));
    const char *path = write_textured("tex.png");
    rename(path, scratch("hub/blobs/88"));
    link_to("../../blobs/77", "hub/snapshots/0a1b/tex.png");
    link_to("../../blobs/88", "hub/snapshots/0a1b/scene.glb");
    path = scratch("hub/snapshots/0a1b/scene.glb");
    check_refused(scene_load(&scene, path), "");
    check_hint(error_get(), "hub");
    const char *root = form("%s", absolute("hub"));
    check_ok("hub", read_rules_set(true, root));
    check_ok("links", scene_load(&scene, path));
    check_ok("its own", read_rules_set(false, NULL));
    bool good = has_colour(&scene);
    scene_free(&scene);
    assert_true(good);
}

TEST(root) {
    make_folders();
    check_ok("narrow", read_rules_set(false, scratch("model")));
    check_shown("a/y.png");
    check_outside("../textures/x.png", "");
    check_outside("link.png", "");
    const char *root = form("%s", absolute(".."));
    check_ok("wide", read_rules_set(false, root));
    check_shown("../../outside-of-named-files.png");
    check_shown("out.png");
    check_shown("../textures/x.png");
    check_outside("slash/etc/passwd", NULL);
    check_ok("all", read_rules_set(false, "/"));
    check_shown("out.png");
    assert_false(read_rules_set(false, scratch("no-such-folder")));
    check_refused(read_rules_set(false, scratch("textures/x.png")), "not a folder");
    check_ok("its own", read_rules_set(false, NULL));
    check_outside("out.png", "..");
}

/* What is no file is not waited for. */
TEST(devices) {
    static const char *const names[] = {"pipe", "linked-zero", "a"};
    struct scene scene;
    make_folders();
    unlink(scratch("model/pipe"));
    assert_int_equal(mkfifo(scratch("model/pipe"), 0600), 0);
    link_to("/dev/zero", "model/linked-zero");
    check_ok("wide", read_rules_set(false, "/"));
    for (int i = 0; i < 3; i++) {
        check_ok("strict", read_rules_set(true, "/"));
        check_refused(scene_load(&scene, write_textured(names[i])), "not a file");
    }
    check_ok("its own", read_rules_set(false, NULL));
}

/* --- data ------------------------------------------------------------------------------------- */

static void to_base64(const unsigned char *bytes, size_t size, char *to) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3) {
        unsigned bits = (unsigned)bytes[i] << 16;
        bits |= i + 1 < size ? (unsigned)bytes[i + 1] << 8 : 0;
        bits |= i + 2 < size ? bytes[i + 2] : 0;
        for (size_t k = 0; k < 4; k++)
            *to++ = i + k > size ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    *to = '\0';
}

static void to_percent(const unsigned char *bytes, size_t size, char *to) {
    for (size_t i = 0; i < size; i++)
        to += sprintf(to, "%%%02x", bytes[i]);
}

/* The picture in the URI, after what stands before its bytes. */
static void check_data(const char *head, const char *extension,
                       void (*encode)(const unsigned char *, size_t, char *)) {
    if (!knows_format(extension))
        return; /* made here by writing one */
    static char uri[1 << 13];
    struct file_bytes bytes;
    const char *name = form("data.%s", extension);
    write_colour(scratch(name));
    check_ok(name, file_read(&bytes, scratch(name)));
    assert_true(bytes.size * 4 + 100 < sizeof uri);
    encode(bytes.data, bytes.size, uri + snprintf(uri, sizeof uri, "%s", head));
    free(bytes.data);
    check_shown(uri);
}

TEST(data) {
    check_data("data:image/png;base64,", "png", to_base64);
    check_data("data:image/webp;base64,", "webp", to_base64);
    check_data("data:image/jpg;base64,", "jpg", to_base64);
    check_data("data:image/jpeg;charset=utf-8;base64,", "jpg", to_base64);
    check_data("data:image/bmp;base64,", "bmp", to_base64);
    check_data("data:image/png;charset=US-ASCII;name=x.png;base64,", "png", to_base64);
    check_data("data:;base64,", "png", to_base64);
    check_data("data:application/octet-stream;base64,", "webp", to_base64);
    check_data("data:application/x-anything;base64,", "jpg", to_base64);
    check_data("DATA:IMAGE/PNG;BASE64,", "png", to_base64);
    check_data("data:image/png; base64,", "png", to_base64);
    check_data("data:image/png,", "png", to_percent);
    check_data("data:,", "webp", to_percent);
}

/* A buffer of the quad's corners and indices in a URI. */
static void check_buffer(const char *head, int length, int extra,
                         void (*encode)(const unsigned char *, size_t, char *)) {
    static char buffers[4096], uri[3000];
    unsigned char bin[PARTS_BIN] = {0};
    parts_bin(&PARTS(0), bin);
    encode(bin, (size_t)(60 + extra), uri + snprintf(uri, sizeof uri, "%s", head));
    snprintf(buffers, sizeof buffers, "[{byteLength: %d, uri: '%s'}]", length, uri);
    const char *path = write_parts(
        "buffer.glb", &PARTS(.buffers = buffers, .views = "[{buffer: 0, byteLength: 60}]"));
    struct scene scene;
    check_ok("strict", read_rules_set(length <= 60 + extra, NULL));
    check_ok(head, scene_load(&scene, path));
    check_ok("not strict", read_rules_set(false, NULL));
    printf("    %-52s %d of %d bytes\n", head, length, 60 + extra);
    assert_int_equal(scene.meshes[0].primitives[0].index_count, 6);
    assert_true(scene.meshes[0].primitives[0].position[2][1] == 1);
    scene_free(&scene);
}

TEST(buffers) {
    check_buffer("data:application/octet-stream;base64,", 60, 0, to_base64);
    check_buffer("data:application/gltf-buffer;charset=utf-8;base64,", 60, 0, to_base64);
    check_buffer("data:;base64,", 60, 0, to_base64);
    check_buffer("data:,", 60, 0, to_percent);
    check_buffer("data:application/octet-stream;base64,", 60, 1, to_base64);
    check_buffer("data:application/octet-stream;base64,", 60, 200, to_base64);
    check_buffer("data:text/plain;base64,", 64, 0, to_base64); /* fewer, which no view needs */
    unsigned char bin[PARTS_BIN] = {0};
    parts_bin(&PARTS(0), bin);
    for (size_t size = 60; size <= PARTS_BIN; size += 130) {
        OWNED(scene) scene;
        write_bytes(scratch("long.bin"), bin, size);
        check_ok("file", load_parts(&scene, "file.glb",
                                    &PARTS(.buffers = "[{byteLength: 60, uri: 'long.bin'}]",
                                           .views = "[{buffer: 0, byteLength: 60}]")));
        printf("    a file of %zu bytes for 60\n", size);
        assert_int_equal(scene.file_count, 1);
        assert_false(scene_check_output(&scene, scratch("long.bin")));
    }
}

/* Pointers of Git LFS are named, wherever a file is expected. */
TEST(pointers) {
    static const char pointer[] =
        "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 9\n";
    static const char *const parts[][3] = {
        {"[{byteLength: 320, uri: lfs}]", NULL, NULL},
        {NULL, "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]", PICTURE("lfs")},
        {NULL, NULL, "scenes: [{nodes: [0], extras: {environment: lfs}}],"},
    };
    write_bytes(scratch("lfs"), pointer, sizeof pointer - 1);
    check_ok("strict", read_rules_set(true, NULL));
    for (int i = 0; i < 3; i++) {
        struct scene scene;
        check_refused(load_parts(&scene, "pointers.glb",
                                 &PARTS(.buffers = parts[i][0], .materials = parts[i][1],
                                        .more = parts[i][2])),
                      "");
        assert_non_null(strstr(error_get(), "lfs: a Git LFS pointer; git lfs pull fetches"));
    }
    check_ok("not strict", read_rules_set(false, NULL));
}

/* --- the command line ------------------------------------------------------------------------- */

TEST(options) {
    const char *none = write_textured("none.png");
    expect_command(0, "info", none);
    expect_text("colours by a magenta checker: image 0: cannot open");
    expect_command(1, "info --strict", none);
    expect_text("but for --strict");
    expect_command(1, "render --strict --size 8x8 -o none.exr", none);
    expect_command(1, "reference --strict --size 8x8 -o none.exr", none);
    expect_command(1, "bench times --strict --size 8x8", none);
    expect_command(1, "info --root /no-such-folder", none);
    expect_text("--root: /no-such-folder: No such file or directory");
    make_folders();
    const char *arguments = form("info --root %s", scratch("model"));
    expect_command(1, arguments, write_textured("../textures/x.png"));
    expect_text(" allows it)");
    expect_command(2, "compare --strict a.exr", "b.exr");
}

/* A scene without triangles is told, and not drawn. */
TEST(empty_scenes) {
    const char *points = write_parts(
        "points.glb",
        &PARTS(.meshes = "[{primitives: [{attributes: {POSITION: 0}, mode: 0}, {attributes: "
                         "{POSITION: 0}, mode: 1}, {attributes: {POSITION: 0}, mode: 3}]}]",
               .more = SPOT("", "")));
    expect_command(0, "info", points);
    expect_text("points     primitives 1, not drawn");
    expect_text("lines      primitives 2, not drawn");
    expect_text("drawn      0 vertices, 0 triangles");
    expect_command(1, "render --size 8x8 -o none.exr", points);
    expect_text("there is no triangle, and points and lines are not drawn");
    const char *camera = write_parts(
        "camera.glb",
        &PARTS(.nodes = "[{camera: 0}, {extensions: {KHR_lights_punctual: {light: 0}}}]",
               .more = "cameras: [{type: perspective, perspective: {yfov: 1, znear: 1}}]," SPOT(
                   "", "")));
    expect_command(0, "info", camera);
    expect_text("lights     1");
    expect_text("cameras    1");
    expect_command(1, "render --size 8x8 -o none.exr", camera);
    expect_text("there is no triangle");
    assert_int_equal(access("none.exr", F_OK), -1);
}

RUN_TESTS(be_quiet, NULL)
