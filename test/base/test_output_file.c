/* Files are written whole or not at all: every format, on a disk that takes no more bytes. */
#define _XOPEN_SOURCE 700
#include "support.h"

#include "base/file/file.h"
#include "base/file/output_file.h"
#include "viewer/scene/session.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *const extensions[] = {"exr",  "tif", "tiff", "pfm", "hdr", "png", "jpg", "jpeg",
                                         "webp", "bmp", "tga",  "gif", "jp2", "ppm", "dpx"};

enum { EXTENSIONS = sizeof extensions / sizeof *extensions, SIDE = 64 };

/* --- a folder, a disk ------------------------------------------------------------------------- */

/* An empty folder; the name lasts until the next but seven. */
static const char *fresh_folder(const char *name) {
    const char *folder = scratch(name);
    char output[64];
    const char *command = form("rm -rf '%s' && mkdir '%s'", folder, folder);
    assert_int_equal(run_command(command, output, sizeof output), 0);
    return folder;
}

/* From here on no file can grow beyond so many bytes; the test's own output neither. */
static void limit_files(rlim_t size) {
    struct rlimit limit;
    fflush(NULL);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
    limit.rlim_cur = size == RLIM_INFINITY ? limit.rlim_max : size;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
}

/* --- pictures --------------------------------------------------------------------------------- */

/* Noise, which no encoder makes small; a picture per seed. */
static bool write_noise(const char *path, unsigned seed) {
    bool is_float, ok;
    check_ok("format", image_format_is_float(path, &is_float));
    OWNED(image) image;
    OWNED(bitmap) bitmap = {SIDE, SIDE, mem_alloc(SIDE * SIDE, 4)};
    image_init(&image, SIDE, SIDE, "R G B");
    for (int i = 0; i < SIDE * SIDE * 4; i++) {
        seed = seed * 1664525U + 1013904223U;
        bitmap.rgba[i] = (unsigned char)(seed >> 24);
        if (i < SIDE * SIDE * 3)
            image.pixels[i] = (float)(seed >> 24) / 64;
    }
    ok = is_float ? image_write(&image, path) : bitmap_write(&bitmap, path);
    return ok;
}

static bool holds(const char *path, const struct file_bytes *bytes) {
    struct file_bytes now;
    check_ok("read again", file_read(&now, path));
    bool same = now.size == bytes->size && memcmp(now.data, bytes->data, now.size) == 0;
    free(now.data);
    return same;
}

static void expect_refused(bool written, const char *path, const char *reason) {
    if (written || !strstr(error_get(), path) || !strstr(error_get(), reason))
        fail_msg("%s: %s, '%s'", path, written ? "written" : "refused", error_get());
}

/* Nothing is left where nothing was, and what was there stays. */
static void check_full(const char *folder, const char *extension) {
    struct file_bytes old;
    const char *path = form("%s/picture.%s", folder, extension);
    const char *other = form("%s/new.%s", folder, extension);
    check_ok(path, write_noise(path, 1));
    check_ok("whole", image_is_whole(path));
    check_ok("read", file_read(&old, path));
    assert_int_equal(count_files(folder), 1);
    const size_t limits[] = {0, 1, 100, old.size / 2, old.size - 1};
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        limit_files(limits[i]);
        bool replaced = write_noise(path, 1);
        limit_files(RLIM_INFINITY);
        expect_refused(replaced, path, "File too large");
        limit_files(limits[i]);
        bool added = write_noise(other, 1);
        limit_files(RLIM_INFINITY);
        expect_refused(added, other, "File too large");
        assert_int_equal(count_files(folder), 1);
        assert_true(holds(path, &old));
    }
    printf("    %-5s %6zu bytes: %s\n", extension, old.size, error_get());
    check_ok("new content", write_noise(path, 2));
    assert_false(holds(path, &old));
    free(old.data);
    remove(path);
}

TEST(full_disk) {
    const char *folder = fresh_folder("full");
    for (int i = 0; i < EXTENSIONS; i++)
        if (knows_format(extensions[i]))
            check_full(folder, extensions[i]);
}

/* A file of other programs, or of a disk that lost its end. */
static void check_cut(const char *folder, const char *extension) {
    char path[512], reason[100] = "";
    struct file_bytes whole;
    snprintf(path, sizeof path, "%s/cut.%s", folder, extension);
    check_ok(path, write_noise(path, 1));
    check_ok("whole", image_is_whole(path));
    check_ok("read", file_read(&whole, path));
    const size_t lost[] = {
        1, 2, 3, 4, 8, 12, 26, 30, 100, 1000, whole.size / 2, whole.size - 10, whole.size};
    for (size_t i = 0; i < sizeof lost / sizeof *lost; i++) {
        assert_int_equal(truncate(path, (off_t)(whole.size - lost[i])), 0);
        if (image_is_whole(path))
            fail_msg("%s without its last %zu bytes is taken for whole", path, lost[i]);
        if (!strstr(error_get(), path))
            fail_msg("'%s' does not name %s", error_get(), path);
        if (i == 0)
            snprintf(reason, sizeof reason, "%s", error_get());
        check_ok("restore", output_file_write(path, whole.data, whole.size));
    }
    printf("    %s\n", reason);
    free(whole.data);
}

TEST(cut_files) {
    const char *folder = fresh_folder("cut");
    for (int i = 0; i < EXTENSIONS; i++)
        if (knows_format(extensions[i]))
            check_cut(folder, extensions[i]);
}

/* Formats that OpenImageIO writes somewhere else, without a word, or not at all. */
TEST(unknown_formats) {
    static const char *const names[] = {"a.null", "a.term", "a.sgi", "a.ico", "a", "a.xyz"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        bool is_float;
        check_refused(image_format_is_float(names[i], &is_float), names[i]);
    }
    bool is_float = false;
    check_ok("capital letters", image_format_is_float("A.EXR", &is_float));
    assert_true(is_float);
}

/* --- text ------------------------------------------------------------------------------------- */

TEST(text) {
    const char *folder = fresh_folder("text");
    const char *path = form("%s/rows.csv", folder);
    struct output_text text;
    output_text_init(&text);
    fprintf(text.stream, "a,b\n");
    check_ok("first row", output_text_end(&text, path));
    output_text_init(&text);
    fprintf(text.stream, "a,b\n1,2\n");
    limit_files(6);
    bool written = output_text_end(&text, path);
    limit_files(RLIM_INFINITY);
    expect_refused(written, path, "File too large");
    assert_true(holds(path, &(struct file_bytes){(unsigned char *)"a,b\n", 4}));
    assert_int_equal(count_files(folder), 1);
}

TEST(session) {
    const char *folder = fresh_folder("session");
    struct session session = {.scene = "scenes/cornell-box.glb",
                              .technique = technique_default,
                              .camera = "0",
                              .lights = mem_strdup("0")};
    renderer_settings_init(&session.settings);
    const char *path = form("%s/view.txt", folder);
    check_ok("save", session_save(&session, path));
    limit_files(10);
    bool saved = session_save(&session, path);
    limit_files(RLIM_INFINITY);
    expect_refused(saved, path, "File too large");
    check_ok("load", session_load(&session, path));
    session.scene = path;
    expect_refused(session_save(&session, path), path, "it is the input");
    session_free(&session);
    assert_int_equal(count_files(folder), 1);
}

/* --- names ------------------------------------------------------------------------------------ */

TEST(refused_names) {
    char long_name[400];
    const char *folder = fresh_folder("names");
    memset(long_name, 'n', sizeof long_name);
    snprintf(long_name + 256, 5, ".png");
    const char *path = form("%s/%s", folder, long_name);
    const struct {
        const char *path, *reason;
    } cases[] = {
        {folder, "it is a folder"},
        {path, "File name too long"},
        {"no/such/folder/x.png", "No such file or directory"},
        {"scenes/cornell-box.glb/x.png", "Not a directory"},
        {"", "without a name"},
        {"/dev/full", "No space left on device"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bool written = output_file_write(cases[i].path, "x", 1);
        expect_refused(written, cases[i].path, cases[i].reason);
        printf("    %.200s\n", error_get());
    }
    assert_int_equal(count_files(folder), 0);
}

/* The longest name that a folder takes leaves no room for a longer one beside it. */
TEST(longest_name) {
    char name[256];
    memset(name, 'n', 255);
    name[255] = '\0';
    const char *path = form("%s/%s", fresh_folder("longest"), name);
    check_ok("write", output_file_write(path, "x", 1));
    check_ok("again", output_file_write(path, "y", 1));
    assert_true(holds(path, &(struct file_bytes){(unsigned char *)"y", 1}));
}

/* What another program fills takes a name, in place of an old file; where it may not, the old one
 * stays alone. */
TEST(part) {
    struct output_part part;
    const char *folder = fresh_folder("part");
    const char *path = form("%s/file", folder);
    const char *below = form("%s/below", path);
    check_ok("old", output_file_write(path, "old", 3));
    expect_refused(output_part_begin(&part, below), below, "Not a directory");
    for (int ok = 0; ok < 2; ok++) {
        check_ok("begin", output_part_begin(&part, path));
        check_ok("put", output_file_put(part.file, "new", 3));
        assert_int_equal(output_part_end(&part, ok), ok);
        assert_int_equal(count_files(folder), 1);
        assert_true(holds(path, &(struct file_bytes){(unsigned char *)(ok ? "new" : "old"), 3}));
    }
}

TEST(read_only) {
    if (geteuid() == 0) {
        printf("    root may write anywhere\n");
        skip();
    }
    const char *folder = fresh_folder("read-only");
    const char *path = form("%s/file", folder);
    check_ok("write", output_file_write(path, "old", 3));
    assert_int_equal(chmod(path, 0444), 0);
    expect_refused(output_file_write(path, "new", 3), path, "Permission denied");
    assert_int_equal(chmod(path, 0644), 0);
    assert_int_equal(chmod(folder, 0555), 0);
    expect_refused(output_file_write(path, "new", 3), path, "Permission denied");
    assert_int_equal(chmod(folder, 0755), 0);
    assert_true(holds(path, &(struct file_bytes){(unsigned char *)"old", 3}));
}

/* A link stays a link, a file's mode stays its mode, a device stays a device. */
TEST(what_is_replaced) {
    struct stat status;
    const char *folder = fresh_folder("replaced");
    const char *file = form("%s/file", folder);
    const char *link = form("%s/link", folder);
    check_ok("write", output_file_write(file, "old", 3));
    assert_int_equal(chmod(file, 0600), 0);
    assert_int_equal(symlink("file", link), 0);
    check_ok("through the link", output_file_write(link, "new", 3));
    assert_true(holds(file, &(struct file_bytes){(unsigned char *)"new", 3}));
    assert_int_equal(lstat(link, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    assert_int_equal(stat(file, &status), 0);
    assert_int_equal(status.st_mode & 0777, 0600);
    expect_refused(output_file_is_not(link, file), link, "it is the input");
    check_ok("others", output_file_is_not(link, "scenes/cornell-box.glb"));
    assert_int_equal(unlink(file), 0);
    expect_refused(output_file_write(link, "x", 1), link, "it is a link to nothing");
    assert_int_equal(lstat(link, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    check_ok("to a device", output_file_write("/dev/null", "x", 1));
    assert_int_equal(stat("/dev/null", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
}

int main(void) {
    signal(SIGXFSZ, SIG_IGN);
    return run_file(__FILE__, NULL, NULL);
}
