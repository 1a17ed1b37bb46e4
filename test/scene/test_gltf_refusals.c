/* Hostile glTF files: each ends in one message that names the object, never in a crash, a hang or a
 * read outside the file's folder. */
#define _XOPEN_SOURCE 700
#include "hostile_numbers.h"
#include "hostile_parts.h"

#include "scene/open.h"
#include "scene/read_rules.h"

#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* The message is one line, names the file, and says what is expected. */
static void check_file_refused(const char *what, const char *path, bool loaded,
                               const char *message) {
    assert_false(loaded);
    printf("    %-28s %s\n", what, error_get());
    if (!strstr(error_get(), path) || strchr(error_get(), '\n') || !strstr(error_get(), message))
        fail_msg("%s: expected '%s' and '%s'", what, path, message);
}

/* Opens it with the note, and under --strict not. */
static void check_mended(const char *what, const char *path, const char *note) {
    struct scene scene;
    struct geometry geometry;
    hear_notes();
    check_ok(what, scene_open(&scene, &geometry, path, NULL));
    end_notes();
    geometry_free(&geometry);
    scene_free(&scene);
    if (!*note)
        return;
    printf("    %-28s %s\n", what, note);
    if (!strstr(notes, note))
        fail_msg("%s: '%s' is not in the notes:\n%s", what, note, notes);
    check_ok("strict", read_rules_set(true, NULL));
    bool opened = scene_open(&scene, &geometry, path, NULL);
    check_ok("not strict", read_rules_set(false, NULL));
    check_file_refused(what, path, opened, "");
}

static void check_hostile(const struct hostile *files, size_t count) {
    const char mended[] = "note: ";
    for (const struct hostile *file = files; file < files + count; file++) {
        struct scene scene;
        struct geometry geometry;
        const char *path = write_parts("hostile.glb", &file->parts);
        if (strncmp(file->message, mended, sizeof mended - 1) == 0) {
            check_mended(file->name, path, file->message + sizeof mended - 1);
            continue;
        }
        bool opened = scene_open(&scene, &geometry, path, NULL);
        if (opened)
            fail_msg("%s: loaded", file->name);
        check_file_refused(file->name, path, opened, file->message);
        assert_null(scene.path);
        assert_null(geometry.position);
    }
}

TEST(hostile_files) {
    write_bytes(scratch("../secret.bin"), "secret", 6);
    unlink(scratch("link.bin"));
    assert_int_equal(symlink("/etc/passwd", scratch("link.bin")), 0);
    mkdir(scratch("folder"), 0777);
    check_hostile(hostile, sizeof hostile / sizeof *hostile);
}

TEST(hostile_numbers) {
    write_bytes(scratch("secret-here.bin"), "secret", 6);
    check_hostile(hostile_numbers, sizeof hostile_numbers / sizeof *hostile_numbers);
}

/* A few bytes that claim to be a huge picture, which is replaced before memory is taken for it. */
TEST(huge_picture) {
    /* PNG: signature, IHDR of 900,000 x 900,000 RGB, an empty IDAT. */
    static const unsigned char png[] = {
        0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48,
        0x44, 0x52, 0x00, 0x0D, 0xBB, 0xA0, 0x00, 0x0D, 0xBB, 0xA0, 0x08, 0x02, 0x00, 0x00,
        0x00, 0x5F, 0xDF, 0x06, 0xD8, 0x00, 0x00, 0x00, 0x08, 0x49, 0x44, 0x41, 0x54, 0x78,
        0x9C, 0x03, 0x00, 0x00, 0x00, 0x00, 0x01, 0x48, 0x06, 0x89, 0xD2};
    const char *path = write_parts(
        "huge.glb",
        &PARTS(.views =
                   "[{buffer: 0, byteLength: 320}, {buffer: 0, byteOffset: 64, byteLength: 256}]",
               .materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]",
               .more = "images: [{bufferView: 1}], textures: [{source: 0}],", EXTRA(png)));
    check_mended("huge picture", path, "image 0: picture: too large: 900000x900000");
}

static unsigned char glb[32768];

static void check_bytes_refused(const char *what, size_t size, const char *message) {
    const char *path = scratch("container.glb");
    write_bytes(path, glb, size);
    struct scene scene;
    check_file_refused(what, path, scene_load(&scene, path), message);
}

static void check_bytes_mended(const char *what, size_t size, const char *note) {
    const char *path = scratch("container.glb");
    write_bytes(path, glb, size);
    check_mended(what, path, note);
}

static void set_word(size_t at, uint32_t word) {
    memcpy(glb + at, &word, sizeof word);
}

#define LENGTHS "wrong lengths in a GLB are ignored: "

/* Lengths that differ from those of the file, which has all of its bytes or too few. */
TEST(lengths) {
    const struct gltf_parts quad = {0};
    size_t size = parts_glb(&quad, glb, sizeof glb), json_size = size - 28 - PARTS_BIN;
    const uint32_t wrong[] = {0,
                              12,
                              20,
                              40,
                              (uint32_t)(20 + json_size),
                              (uint32_t)(20 + json_size + 4),
                              (uint32_t)size - 4,
                              (uint32_t)size - 1,
                              (uint32_t)size + 1,
                              (uint32_t)size + 1000,
                              UINT32_MAX};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        set_word(8, wrong[i]);
        const char *note = form(LENGTHS "the header says %u bytes, there are %zu", wrong[i], size);
        check_bytes_mended("length in the header", size, note);
    }
    check_bytes_refused("cut between chunks", 20 + json_size,
                        "truncated: the header says 4294967295 bytes");
    set_word(8, (uint32_t)size - 4);
    check_bytes_mended("and bytes behind", size + 7, LENGTHS "the header says");
    set_word(8, (uint32_t)size);
    set_word(20 + json_size, UINT32_MAX);
    check_bytes_mended("endless BIN", size, LENGTHS "chunk 1: 4294967295 bytes");
    set_word(20 + json_size, PARTS_BIN);
    set_word(8, (uint32_t)size - 100);
    check_bytes_refused("BIN cut", size - 100,
                        "truncated: chunk 1: 320 bytes, but only 220 are left: buffer view 0: ");
    set_word(8, (uint32_t)size);
    set_word(20 + json_size, PARTS_BIN - 4);
    check_bytes_refused("BIN counts too few", size, "outside buffer 0 of 316 bytes");
}

TEST(containers) {
    const struct gltf_parts quad = {0};
    size_t size = parts_glb(&quad, glb, sizeof glb);
    size_t json_size = size - 28 - PARTS_BIN;
    check_bytes_refused("empty", 0, "the file is empty");
    check_bytes_refused("magic alone", 4, "truncated: 4 bytes are no GLB file");
    check_bytes_refused("header alone", 12, "truncated: 12 bytes are no GLB file");
    check_bytes_refused("half the JSON", 100, "truncated: the header says");
    check_bytes_refused("half the BIN", size - 100, "truncated: the header says");
    check_bytes_mended("bytes behind", size + 4,
                       "bytes after the last chunk of a GLB are ignored: 4 bytes");
    set_word(4, 1);
    check_bytes_refused("version 1", size, "glTF version 1; 2.0 is read");
    parts_glb(&quad, glb, sizeof glb);
    set_word(12, 0xFFFFFFFC);
    check_bytes_refused("endless chunk", size, "chunk 0: 4294967292 bytes, but only");
    parts_glb(&quad, glb, sizeof glb);
    set_word(16, 0x004E4942);
    check_bytes_refused("BIN first", size, "chunk 0: type 0x004E4942 is not JSON");
    parts_glb(&quad, glb, sizeof glb);
    set_word(20 + json_size + 4, 0x4E4F534A);
    check_bytes_refused("JSON twice", size,
                        "chunk 1: type 0x4E4F534A is JSON, which comes first alone");
    parts_glb(&quad, glb, sizeof glb);
    set_word(20 + json_size, PARTS_BIN + 4);
    check_bytes_mended("BIN 4 bytes long", size,
                       LENGTHS "chunk 1: 324 bytes, but only 320 are left");
    parts_glb(&quad, glb, sizeof glb);
    set_word(20 + json_size, PARTS_BIN - 2);
    check_bytes_refused("uneven chunk", size, "320 bytes at 0 are outside buffer 0 of 318 bytes");
    parts_glb(&quad, glb, sizeof glb);
    set_word(8, (uint32_t)(20 + json_size));
    check_bytes_refused("no BIN", 20 + json_size,
                        "buffer view 0: its buffer 0 has no uri, and there is no BIN");
}

TEST(texts) {
    static const struct {
        const char *text, *message;
    } texts[] = {
        {"hello", "not a scene: neither glTF nor GLB"},
        {"[]", "the JSON is not an object"},
        {"{\"asset\": ", "the JSON: parse error at line 1, column 11"},
        {"// by hand\n{}", "the JSON: parse error at line 1, column 1: "},
        {"# by hand\n{}", "the JSON: parse error at line 1, column 1: "},
        {"{\n \"asset\": {\"version\": \"2.0\"},\n}", "parse error at line 3, column 1: "},
        {"{\"asset\": {\"version\": \"1.0\"}, \"buffers\": {}}", "glTF version 1.0; 2.0 is read"},
        {"{\"meshes\": {}, \"buffers\": {}}", "glTF version 1.0; 2.0 is read"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a Git LFS pointer"},
        {"\xFF\xFE{", "the text is UTF-16; glTF is UTF-8"},
        {"\xFE\xFF", "the text is UTF-16; glTF is UTF-8"},
        {"{}", "it has no 'asset'"},
    };
    const char *path = scratch("text.gltf");
    struct scene scene;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        write_bytes(path, texts[i].text, strlen(texts[i].text));
        check_file_refused("text", path, scene_load(&scene, path), texts[i].message);
    }
    /* Brackets that would overflow the stack of a recursive reader. */
    enum { DEPTH = 200000 };
    char *deep = mem_alloc(DEPTH + 64, 1);
    size_t size = (size_t)sprintf(deep, "{\"asset\": {\"version\": \"2.0\"}, \"extras\": ");
    memset(deep + size, '[', DEPTH);
    write_bytes(path, deep, size + DEPTH);
    check_file_refused("deep", path, scene_load(&scene, path), "the JSON is nested too deep");
    free(deep);
    check_file_refused("folder", scratch("folder"), scene_load(&scene, scratch("folder")),
                       "not a file");
    check_file_refused("nothing", scratch("none.glb"), scene_load(&scene, scratch("none.glb")),
                       "No such");
}

/* xorshift64 [Marsaglia 2003]. */
static uint32_t next_random(uint64_t *x) {
    *x ^= *x << 13;
    *x ^= *x >> 7;
    *x ^= *x << 17;
    return (uint32_t)(*x >> 32);
}

/* Flips, overwrites or inserts digits in a good file: whatever comes out, loading it must end. */
TEST(mutations) {
    const struct gltf_parts parts = {
        .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                     "}, {bufferView: 0, componentType: 5121, count: 4, type: VEC3, sparse: "
                     "{count: 2, indices: {bufferView: 0, byteOffset: 48, componentType: 5123}, "
                     "values: {bufferView: 0, byteOffset: 60}}}]",
        .meshes =
            PRIMITIVE("attributes: {POSITION: 0, NORMAL: 2}, indices: 1, material: 0, mode: 5"),
        .nodes = "[{mesh: 0, children: [1, 2]}, {camera: 0, scale: [1, 2, 3]}, {extensions: "
                 "{KHR_lights_punctual: {light: 0}}}]",
        .more =
            "cameras: [{type: perspective, perspective: {yfov: 1, znear: 1}}], extensions: "
            "{KHR_lights_punctual: {lights: [{type: spot, spot: {}}]}}, scenes: [{nodes: [0]}],"};
    size_t size = parts_glb(&parts, glb, sizeof glb);
    static unsigned char good[sizeof glb];
    memcpy(good, glb, size);
    const char *path = scratch("mutated.glb");
    uint64_t random = 20240229;
    int loaded = 0, count = 0;
    for (clock_t start = clock(); count < 4000 && clock() - start < 2 * CLOCKS_PER_SEC; count++) {
        memcpy(glb, good, size);
        for (uint32_t k = next_random(&random) % 4 + 1; k > 0; k--) {
            size_t at = next_random(&random) % size;
            uint32_t r = next_random(&random);
            glb[at] = r & 1   ? (unsigned char)('0' + (r >> 8) % 10)
                      : r & 2 ? (unsigned char)(glb[at] ^ 1u << (r >> 8) % 8)
                              : (unsigned char)(r >> 8);
        }
        write_bytes(path, glb, size);
        struct scene scene;
        struct geometry geometry;
        if (!scene_load(&scene, path)) {
            assert_non_null(strstr(error_get(), path));
            continue;
        }
        loaded++;
        if (geometry_init(&geometry, &scene, 0)) {
            for (uint32_t i = 0; i < geometry.index_count; i++)
                assert_true(geometry.indices[i] < geometry.vertex_count);
            geometry_free(&geometry);
        }
        scene_free(&scene);
    }
    printf("    %d of %d mutated files loaded\n", loaded, count);
    assert_true(loaded > 0 && loaded < count);
}

RUN_TESTS(be_quiet, NULL)
