/* The base floor: errors, Halton points, images and their files. */
#define _POSIX_C_SOURCE 200809L
#include "support.h"

#include "base/extremes.h"
#include "base/file/file.h"
#include "base/file/folder.h"
#include "base/halton.h"
#include "base/image.h"
#include "base/log.h"
#include "base/names.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/text.h"
#include "base/words.h"

#include <stdatomic.h>
#include <unistd.h>

/* A running value goes second, and NaN never becomes it but where it begins so. */
TEST(extremes) {
    static const float values[] = {0, 1, -2.5F, 1e30F, -1e30F, INFINITY, -INFINITY, 1e-45F};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        for (size_t j = 0; j < sizeof values / sizeof *values; j++) {
            assert_true(float_min(values[i], values[j]) == fminf(values[i], values[j]));
            assert_true(float_max(values[i], values[j]) == fmaxf(values[i], values[j]));
        }
    assert_true(float_min(NAN, 3) == fminf(NAN, 3) && float_max(NAN, 3) == fmaxf(NAN, 3));
    assert_true(isnan(float_min(3, NAN)) && isnan(float_max(3, NAN)));
}

TEST(error_prefix) {
    assert_false(error_set("cannot open %s", "lion.png"));
    error_prefix("material %d", 12);
    error_prefix("sponza.glb");
    assert_string_equal(error_get(), "sponza.glb: material 12: cannot open lion.png");
    error_set("again: %s", error_get());
    assert_string_equal(error_get(), "again: sponza.glb: material 12: cannot open lion.png");
}

TEST(halton) {
    const double base2[] = {0, .5, .25, .75, .125}, base3[] = {0, 1. / 3, 2. / 3, 1. / 9, 4. / 9};
    for (uint32_t i = 0; i < 5; i++) {
        check_near("Halton base 2", radical_inverse(2, i), base2[i], 0);
        check_near("Halton base 3", radical_inverse(3, i), base3[i], 1e-15);
    }
    /* Any 2^k consecutive points from 0 hit each interval of length 2^-k once. */
    bool hit[64] = {0};
    for (uint32_t i = 0; i < 64; i++)
        hit[(int)(radical_inverse(2, i) * 64)] = true;
    for (int i = 0; i < 64; i++)
        assert_true(hit[i]);
}

static void count_up(void *context, size_t i) {
    atomic_fetch_add((atomic_size_t *)context, i + 1);
}

TEST(parallel_for) {
    for (int k = 0; k < 6; k++) {
        int threads = k < 5 ? k : 1000; /* more than ever start */
        atomic_size_t sum = 0;
        parallel_for(1000, threads, count_up, &sum);
        assert_int_equal(sum, 500500);
    }
}

/* cpu.max of a container. */
TEST(granted) {
    static const struct {
        const char *text;
        int cores;
    } cases[] = {{"150000 100000\n", 2}, {"50000 100000\n", 1}, {"300000 100000\n", 3}};
    for (int i = 0; i < 3; i++) {
        write_text(scratch("cpu.max"), cases[i].text);
        assert_int_equal(parallel_granted(scratch("cpu.max")), cases[i].cores);
    }
    write_text(scratch("cpu.max"), "max 100000\n");
    assert_true(parallel_granted(scratch("cpu.max")) >= 256);
    assert_true(parallel_granted("/nowhere") >= 256);
}

TEST(layers) {
    OWNED(image) image;
    image_init(&image, 2, 1, "R G B Z indirect.R indirect.G indirect.B");
    int channels[3];
    assert_true(image_find_layer(&image, "indirect", channels));
    assert_int_equal(channels[0], 4);
    assert_false(image_find_layer(&image, "albedo", channels));
    assert_string_equal(error_get(), "no layer 'albedo' (there is: beauty, Z, indirect)");
}

TEST(added_channels) {
    OWNED(image) image;
    image_init(&image, 2, 2, "R Z");
    for (int i = 0; i < 8; i++)
        image.pixels[i] = (float)i;
    image_add_channels(&image, "val.R val.G");
    assert_int_equal(image.channel_count, 4);
    assert_int_equal(image_find_channel(&image, "val.G"), 3);
    const float last[4] = {6, 7, 0, 0};
    assert_memory_equal(image_at(&image, 1, 1), last, sizeof last);
}

/* Names of other programs: each channel keeps its own name, whole, and its own values. */
TEST(foreign_names) {
#define LONG "a.name.of.more.than.thirty.one.bytes."
    static const char *const names[] = {"R",         "G",    "B",      "my mask", " leading",
                                        "trailing ", "a  b", LONG "1", LONG "2"};
    enum { COUNT = sizeof names / sizeof *names };
    struct image written, read;
    image_init_named(&written, 2, 1, names, COUNT);
    assert_int_equal(written.channel_count, COUNT);
    for (int i = 0; i < 2 * COUNT; i++)
        written.pixels[i] = (float)i / 4;
    check_ok("write", image_write(&written, scratch("foreign.exr")));
    check_ok("read", image_read(&read, scratch("foreign.exr")));
    assert_int_equal(read.channel_count, COUNT);
    for (int x = 0; x < 2; x++)
        for (int c = 0; c < COUNT; c++) {
            int there = image_find_channel(&read, names[c]);
            if (there < 0)
                fail_msg("no channel '%s'", names[c]);
            check_near(names[c], (double)image_at(&read, x, 0)[there],
                       (double)image_at(&written, x, 0)[c], 0);
        }
    images_free(&written, &read);
    image_init_named(&written, 1, 1, (const char *const[]){"R", "", "B"}, 3);
    written.pixels[2] = .5f;
    check_ok("write", image_write(&written, scratch("nameless.exr")));
    check_ok("read", image_read(&read, scratch("nameless.exr")));
    assert_int_equal(read.channel_count, 3);
    check_near("B", (double)read.pixels[image_find_channel(&read, "B")], .5, 0);
    images_free(&written, &read);
}

/* Layers are told apart by their whole names. */
TEST(long_layers) {
    OWNED(image) image;
    int channels[3];
    image_init(&image, 1, 1,
               LONG "1.R " LONG "1.G " LONG "1.B " LONG "2.R " LONG "2.G " LONG "2.B");
    check_ok("layer", image_find_layer(&image, LONG "2", channels));
    assert_int_equal(channels[0], 3);
    check_refused(image_find_layer(&image, LONG "3", channels),
                  LONG "3' (there is: " LONG "1, " LONG "2)");
}

TEST(file_refusals) {
    OWNED(image) image;
    bool is_float;
    check_refused(image_read(&image, "no/such/file.exr"), "no/such/file.exr: ");
    assert_false(image_format_is_float("picture", &is_float));
    check_refused(image_format_is_float("picture.xyz", &is_float), "");
    image_init(&image, 1, 1, "R G B");
    check_refused(image_write(&image, "no/such/folder/x.exr"), "no/such/folder/x.exr: ");
}

/* Files of no format, pictures that a format has no room for, what is cut, and passes that a file
 * tells of. */
TEST(formats) {
    struct image image, read;
    struct bitmap bitmap = {1, 1, (unsigned char[]){1, 2, 3, 4}}, decoded;
    uint64_t memory;
    image_init(&image, 2, 1, "Z");
    check_refused(image_write(&image, scratch("a.hdr")), "no layer 'beauty'");
    static const char *const names[] = {"a.doc", "a"};
    for (int i = 0; i < 2; i++)
        assert_false(image_write(&image, scratch(names[i])) ||
                     bitmap_write(&bitmap, scratch(names[i])) ||
                     image_read(&read, scratch(names[i])) || image_is_whole(scratch(names[i])));
    printf("    %s\n", error_get());
    image.passes = mem_strdup("0..3");
    image.weight = 4;
    check_ok("passes", image_write(&image, scratch("passes.exr")));
    check_ok("passes", image_read(&read, scratch("passes.exr")));
    assert_string_equal(read.passes, "0..3");
    check_near("weight", read.weight, 4, 0);
    assert_true(image_is_whole(scratch("passes.exr")));
    images_free(&read, &image);
    check_ok("png", bitmap_write(&bitmap, scratch("a.png")));
    struct file_bytes bytes;
    check_ok("its bytes", file_read(&bytes, scratch("a.png")));
    for (size_t size = 0; size < bytes.size;
         size++) { /* cut anywhere, it is none or its one pixel */
        if (!bitmap_measure(bytes.data, size, &memory) ||
            !bitmap_decode(&decoded, bytes.data, size))
            continue;
        assert_true(decoded.width == 1 && decoded.height == 1);
        bitmap_free(&decoded);
    }
    check_ok("whole", bitmap_decode(&decoded, bytes.data, bytes.size));
    assert_memory_equal(decoded.rgba, bitmap.rgba, 3); /* PNG has it without alpha here */
    bitmap_free(&decoded);
    free(bytes.data);
}

TEST(text) {
    struct text text = {0};
    char expected[3 * 1000 + 1] = "";
    for (int i = 0; i < 1000; i++) {
        if (i % 2)
            text_print(&text, "%03d", i);
        else
            text_append(&text, "abcdef", 3);
        snprintf(expected + 3 * i, 4, i % 2 ? "%03d" : "abc", i);
    }
    text_append(&text, NULL, 0);
    assert_int_equal(text.length, strlen(expected));
    assert_string_equal(text.data, expected);
    free(text.data);
}

static void expect_no_file(const char *path, const char *message) {
    struct file_bytes bytes;
    assert_false(file_read(&bytes, path));
    assert_null(bytes.data);
    printf("    %s\n", error_get());
    assert_string_equal(error_get(), message);
    assert_null(file_read_text(path));
}

TEST(whole_files) {
    struct file_bytes bytes;
    const char *path = scratch("bytes");
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite("a\0b\n", 1, 4, file), 4);
    fclose(file);
    check_ok("read", file_read(&bytes, path));
    assert_int_equal(bytes.size, 4);
    assert_memory_equal(bytes.data, "a\0b\n", 5); /* and the zero behind */
    free(bytes.data);
    expect_no_file("/nowhere/at/all", "cannot open /nowhere/at/all: No such file or directory");
    expect_no_file("/", "cannot read /: not a file");
}

TEST(words_and_names) {
    struct names names = {0};
    int count = 0;
    for (struct word word = {.at = " ,one, two=2,,three "}; word_next(&word); count++) {
        const char *text = form("%.*s", word.length, word.at);
        names_add(&names, "; ", text);
        assert_int_equal(word_is(&word, "two=2"), count == 1);
        assert_false(word_is(&word, "thre") || word_is(&word, "threes"));
    }
    printf("    %s\n", names.text);
    assert_string_equal(names.text, "one; two=2; three");
    for (int i = 0; i < 1000; i++)
        names_add(&names, ", ", "another");
    assert_int_equal(strlen(names.text), sizeof names.text - 1);
}

/* What is asked for without a size is a place all the same. */
TEST(no_memory) {
    char *a = mem_alloc(0, 4), *b = mem_alloc(4, 0), *c = mem_resize(NULL, 0, 1);
    assert_true(a && b && c && *a == 0 && *b == 0);
    c = mem_resize(c, 1, 0);
    assert_non_null(c);
    assert_true(mem_resident() > 0 && mem_most_resident() > 0); /* counted at different times */
    mem_free(a, b, c);
}

/* Files that are not read: 4 GiB of nothing, a folder, none. */
TEST(unread_files) {
    struct file_bytes bytes;
    const char *path = scratch("sparse");
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(ftruncate(fileno(file), (off_t)1 << 32), 0);
    fclose(file);
    check_refused(file_read(&bytes, path), "4 GiB or more");
    remove(path);
    assert_false(file_read(&bytes, path) || file_read(&bytes, scratch(".")));
    assert_null(file_read_text(path));
}

/* A picture of grey alone is its beauty; one without colours has no layer at all. */
TEST(grey) {
    struct image image;
    int channels[3];
    image_init(&image, 1, 1, "Y");
    check_ok("grey", image_find_layer(&image, "beauty", channels));
    assert_true(channels[0] == 0 && channels[1] == 0 && channels[2] == 0);
    image_free(&image);
    image_init(&image, 1, 1, "Z");
    assert_false(image_find_layer(&image, "", channels));
    assert_string_equal(error_get(), "no layer 'beauty' (there is: Z)");
    image_free(&image);
    assert_true(image_name_holds_layers("a.exr"));
    assert_false(image_name_holds_layers("a.png") || image_name_holds_layers("a"));
}

/* What is written while `write` runs goes to a file; its text. */
static char *stderr_of(void (*write)(void)) {
    char *path = mem_strdup(scratch("stderr.txt"));
    fflush(stderr);
    int saved = dup(STDERR_FILENO);
    assert_non_null(freopen(path, "w", stderr));
    write();
    fflush(stderr);
    dup2(saved, STDERR_FILENO);
    close(saved);
    char *text = file_read_text(path);
    free(path);
    assert_non_null(text);
    return text;
}

static char heard[200];

static void hear(void *context, bool is_warning, const char *message) {
    snprintf(heard + strlen(heard), sizeof heard - strlen(heard), "%s%s %s;", (char *)context,
             is_warning ? " warning" : "", message);
}

static void tell_all(void) {
    log_set_level(LOG_VERBOSE);
    log_detail("detail %d", 1);
    log_set_listener(hear, "heard");
    log_note("note %d", 2);
    log_set_level(LOG_QUIET);
    log_detail("no detail");
    log_note("quiet %d", 3);
    log_warning("warning %d", 4);
    log_tell_of_thread(false);
    log_note("nothing");
    log_warning("nothing");
    log_tell_of_thread(true);
    log_set_listener(NULL, NULL);
    log_warning("unheard");
    log_set_level(LOG_NORMAL);
}

/* Notes by level, warnings always; a listener hears both however quiet it is, and of a silent
 * thread nobody. */
TEST(log) {
    enum log_level before = log_get_level();
    char *text = stderr_of(tell_all);
    log_set_level(before);
    assert_string_equal(text, "manylight: detail 1\nmanylight: note: note 2\n"
                              "manylight: warning: warning 4\nmanylight: warning: unheard\n");
    assert_string_equal(heard, "heard note 2;heard quiet 3;heard warning warning 4;");
    free(text);
}

static void show_progress(bool rewritten) {
    struct progress progress = {.shown = true, .rewritten = rewritten};
    progress_show(&progress, 0, "nothing is done");
    progress_show(&progress, .25, "noise");
    progress_show(&progress, .5, "too soon");
    progress.last = rewritten ? progress.last : 0;
    progress_show(&progress, 1, "the end, which a log is told otherwise");
    assert_true(progress_end(&progress) > 0);
    progress.shown = false;
    progress.last = 0;
    progress_show(&progress, .5, "quiet");
    progress_end(&progress);
}

static void show_on_terminal(void) {
    show_progress(true);
}

static void show_in_log(void) {
    show_progress(false);
}

static void show_work(void) {
    struct progress progress = {.shown = true, .rewritten = true};
    progress_show_work(&progress, 0, "begins");
    log_warning("between");
    progress_show_work(&progress, .25, "goes on");
    log_show_line(NULL);
    log_show_line(NULL);
}

/* What is told meanwhile stands on a line of its own, which the next line follows. */
TEST(line_is_cleared) {
    char *text = stderr_of(show_work);
    const char *expected = "\rbegins\033[K\r\033[Kmanylight: warning: between\n\r  25 %";
    if (strncmp(text, expected, strlen(expected)) != 0)
        fail_msg("%s", text);
    const char *end = strstr(text, "goes on");
    assert_non_null(end);
    assert_string_equal(end, "goes on\033[K\r\033[K");
    free(text);
}

/* One line of those that are there to tell, which a terminal clears and a log keeps. */
TEST(progress) {
    char *text = stderr_of(show_on_terminal);
    assert_non_null(strstr(text, "\r  25 %"));
    assert_non_null(strstr(text, "left  noise\033[K\r\033[K"));
    assert_null(strchr(text, '\n'));
    assert_null(strstr(text, "nothing") ? strstr(text, "nothing") : strstr(text, "too soon"));
    assert_null(strstr(text, "quiet"));
    free(text);
    text = stderr_of(show_in_log);
    assert_string_equal(strstr(text, "left"), "left, noise\n");
    assert_ptr_equal(strstr(text, "manylight: note: 25 %, "), text);
    free(text);
}

/* A variable, else the home, else neither; and the folders on the way to a file, one of which is a
 * file. */
TEST(folders) {
    char *home = getenv("HOME") ? mem_strdup(getenv("HOME")) : NULL;
    setenv("MANYLIGHT_TEST", "/a", 1);
    char *folder = folder_of_user("MANYLIGHT_TEST", ".b");
    assert_string_equal(folder, "/a/manylight");
    free(folder);
    unsetenv("MANYLIGHT_TEST");
    setenv("HOME", "/home/one", 1);
    folder = folder_of_user("MANYLIGHT_TEST", ".b");
    assert_string_equal(folder, "/home/one/.b/manylight");
    free(folder);
    setenv("MANYLIGHT_TEST", "", 1); /* as good as none */
    setenv("HOME", "", 1);
    assert_null(folder_of_user("MANYLIGHT_TEST", ".b"));
    unsetenv("MANYLIGHT_TEST");
    unsetenv("HOME");
    assert_null(folder_of_user("MANYLIGHT_TEST", ".b"));
    printf("    %s\n", error_get());
    if (home)
        setenv("HOME", home, 1);
    free(home);
    char *path = mem_printf("%s/two/file", scratch("one"));
    check_ok(path, folder_make_for(path));
    check_ok(path, folder_make_for(path));
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fclose(file);
    char *below = mem_printf("%s/three", path);
    assert_true(folder_make_for(below)); /* a name that is there may be a link to a folder */
    free(below);
    below = mem_printf("%s/three/four", path);
    check_refused(folder_make_for(below), "");
    remove(path);
    mem_free(below, path);
}

RUN_TESTS(NULL, NULL)
