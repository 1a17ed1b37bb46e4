/* The base floor: errors, Halton points, images and their files. */
#define _POSIX_C_SOURCE 200809L
#include "support.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/file/folder.h"
#include "base/halton.h"
#include "base/json.h"
#include "base/log.h"
#include "base/image.h"
#include "base/file/image_file.h"
#include "base/memory.h"
#include "base/names.h"
#include "base/option.h"
#include "base/settings.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/text.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void test_error_prefix(void **state) {
    (void)state;
    assert_false(error_set("cannot open %s", "lion.png"));
    error_prefix("material %d", 12);
    error_prefix("sponza.glb");
    assert_string_equal(error_get(), "sponza.glb: material 12: cannot open lion.png");
    error_set("again: %s", error_get());
    assert_string_equal(error_get(), "again: sponza.glb: material 12: cannot open lion.png");
}

static void test_halton(void **state) {
    (void)state;
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

static void test_parallel_for(void **state) {
    (void)state;
    for (int threads = 0; threads < 5; threads++) {
        atomic_size_t sum = 0;
        parallel_for(1000, threads, count_up, &sum);
        assert_int_equal(sum, 500500);
    }
}

static void test_layers(void **state) {
    (void)state;
    struct image image;
    image_init(&image, 2, 1, "R G B Z indirect.R indirect.G indirect.B");
    int channels[3];
    assert_true(image_find_layer(&image, "indirect", channels));
    assert_int_equal(channels[0], 4);
    assert_false(image_find_layer(&image, "albedo", channels));
    assert_string_equal(error_get(), "no layer 'albedo' (there is: beauty indirect)");
    image_free(&image);
}

static void test_added_channels(void **state) {
    (void)state;
    struct image image;
    image_init(&image, 2, 2, "R Z");
    for (int i = 0; i < 8; i++)
        image.pixels[i] = (float)i;
    image_add_channels(&image, "val.R val.G");
    assert_int_equal(image.channel_count, 4);
    assert_int_equal(image_find_channel(&image, "val.G"), 3);
    const float last[4] = {6, 7, 0, 0};
    assert_memory_equal(image_at(&image, 1, 1), last, sizeof last);
    image_free(&image);
}

static void test_exr_round_trip(void **state) {
    (void)state;
    struct image written, read;
    image_init(&written, 3, 2, "R G B Z val.id");
    for (int i = 0; i < 3 * 2 * 5; i++)
        written.pixels[i] = (float)i / 4;
    const char *path = scratch("round-trip.exr");
    check_ok("write", image_write(&written, path));
    check_ok("read", image_read(&read, path));
    assert_int_equal(read.channel_count, 5);
    for (int y = 0; y < 2; y++)
        for (int x = 0; x < 3; x++)
            for (int c = 0; c < 5; c++) {
                int there = image_find_channel(&read, written.names[c]);
                assert_true(there >= 0);
                check_near(written.names[c], image_at(&read, x, y)[there],
                           image_at(&written, x, y)[c], 0);
            }
    image_free(&written);
    image_free(&read);
}

/* Names of other programs: each channel keeps its own name, whole, and its own values. */
static void test_foreign_names(void **state) {
    (void)state;
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
    image_free(&written);
    image_free(&read);
    image_init_named(&written, 1, 1, (const char *const[]){"R", "", "B"}, 3);
    written.pixels[2] = .5f;
    check_ok("write", image_write(&written, scratch("nameless.exr")));
    check_ok("read", image_read(&read, scratch("nameless.exr")));
    assert_int_equal(read.channel_count, 3);
    check_near("B", (double)read.pixels[image_find_channel(&read, "B")], .5, 0);
    image_free(&written);
    image_free(&read);
}

/* Layers are told apart by their whole names. */
static void test_long_layers(void **state) {
    (void)state;
    struct image image;
    int channels[3];
    image_init(&image, 1, 1,
               LONG "1.R " LONG "1.G " LONG "1.B " LONG "2.R " LONG "2.G " LONG "2.B");
    check_ok("layer", image_find_layer(&image, LONG "2", channels));
    assert_int_equal(channels[0], 3);
    assert_false(image_find_layer(&image, LONG "3", channels));
    printf("    %s\n", error_get());
    assert_non_null(strstr(error_get(), LONG "3' (there is: " LONG "1 " LONG "2)"));
    image_free(&image);
}

static void test_png_round_trip(void **state) {
    (void)state;
    unsigned char pixels[] = {0, 1, 2, 255, 128, 254, 255, 255};
    struct bitmap written = {.width = 2, .height = 1, .rgba = pixels}, read;
    const char *path = scratch("round-trip.png");
    check_ok("write", bitmap_write(&written, path));
    static unsigned char file[65536];
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    size_t size = fread(file, 1, sizeof file, f);
    fclose(f);
    check_ok("decode", bitmap_decode(&read, file, size));
    assert_memory_equal(read.rgba, pixels, sizeof pixels);
    bitmap_free(&read);
    assert_false(bitmap_decode(&read, file, size / 2) && read.rgba[4] == 128);
    bitmap_free(&read);
    assert_false(bitmap_decode(&read, "nonsense", 8));
}

static void test_file_refusals(void **state) {
    (void)state;
    struct image image;
    bool is_float;
    assert_false(image_read(&image, "no/such/file.exr"));
    printf("    %s\n", error_get());
    assert_non_null(strstr(error_get(), "no/such/file.exr: "));
    assert_false(image_format_is_float("picture", &is_float));
    assert_false(image_format_is_float("picture.xyz", &is_float));
    printf("    %s\n", error_get());
    image_init(&image, 1, 1, "R G B");
    assert_false(image_write(&image, "no/such/folder/x.exr"));
    printf("    %s\n", error_get());
    assert_non_null(strstr(error_get(), "no/such/folder/x.exr: "));
    image_free(&image);
}

struct values {
    bool flag;
    int count, choice, size[2];
    float scale;
    const char *text;
    struct text_list list;
};

static const char *const colours[] = {"red", "green", NULL};

static const struct option table[] = {
    {"flag", 'f', OPTION_FLAG, offsetof(struct values, flag), .help = "a flag"},
    {"count", 0, OPTION_INT, offsetof(struct values, count), 5, 1, 10, .help = "a count"},
    {"colour", 0, OPTION_CHOICE, offsetof(struct values, choice), 1, .choices = colours,
     .help = ""},
    {"size", 0, OPTION_SIZE, offsetof(struct values, size), 800, 1, 16384, .help = "size"},
    {"scale", 0, OPTION_FLOAT, offsetof(struct values, scale), 1.5, 0, 2, .help = "scale"},
    {"text", 't', OPTION_TEXT, offsetof(struct values, text), .help = "text"},
    {"set", 0, OPTION_LIST, offsetof(struct values, list), .help = "list"},
    {NULL},
};

static void test_options(void **state) {
    (void)state;
    struct values values;
    options_set_defaults(table, &values);
    assert_int_equal(values.count, 5);
    assert_int_equal(values.size[1], 800);
    char *argv[] = {"x",    "a",     "--count=7", "-f",    "--colour", "red", "--size", "4x5",
                    "-thi", "--set", "k=1",       "--set", "l=2",      "--",  "-b"};
    const char *positional[2];
    int count;
    check_ok("parse", options_parse_arguments(table, &values, 15, argv, positional, 2, &count));
    assert_int_equal(count, 2);
    assert_string_equal(positional[1], "-b");
    assert_true(values.flag && values.count == 7 && values.choice == 0 && values.size[0] == 4);
    assert_string_equal(values.text, "hi");
    assert_string_equal(values.list.items[1], "l=2");

    for (const struct option *o = table; o->type != OPTION_TEXT; o++) {
        char text[64], again[64];
        option_format(o, &values, text, sizeof text);
        check_ok("round trip", option_parse(o, &values, text));
        option_format(o, &values, again, sizeof again);
        assert_string_equal(text, again);
    }
    static const char *const bad[] = {"count=11",    "count=",  "count=7x",   "scale=nan",
                                      "colour=blue", "size=4x", "size=0x4",   "scale=1e99",
                                      "flag=maybe",  "scale=%", "scale=300%", "scale=1%%"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char name[16];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(bad[i], "="), bad[i]);
        const struct option *option = option_find(table, name);
        assert_non_null(option);
        assert_false(option_parse(option, &values, bad[i] + strcspn(bad[i], "=") + 1));
        printf("    %s\n", error_get());
    }
    check_ok("per cent", option_parse(option_find(table, "scale"), &values, "150%"));
    assert_true(values.scale == 1.5F);
}

/* The help of options of each type, letter by letter, and what a value is refused with. */
static void test_option_help(void **state) {
    (void)state;
    static const char *const names[] = {"red", "green", "blue", NULL};
    static const struct option all[] = {
        {"on", 'o', OPTION_FLAG, offsetof(struct values, flag), .default_value = 1, .help = "one"},
        {"off", 0, OPTION_FLAG, offsetof(struct values, flag), .help = "two\nlines"},
        {"count", 0, OPTION_INT, offsetof(struct values, count), 5, 1, 9, .help = "three"},
        {"hue", 'h', OPTION_CHOICE, offsetof(struct values, choice), 1, .choices = names,
         .help = "four"},
        {"size", 0, OPTION_SIZE, offsetof(struct values, size), 8, 1, 64, .help = "five"},
        {"file", 0, OPTION_TEXT, offsetof(struct values, text), .value_name = "F", .help = "six"},
        {NULL},
    };
    static const char expected[] =
        "  -o, --on                   one [on]\n"
        "  --off                      two\n                             lines\n"
        "  --count N                  three [5; 1 to 9]\n"
        "  -h, --hue NAME             four [green; one of red, green, blue]\n"
        "  --size WxH                 five [8x8]\n"
        "  --file F                   six\n";
    char *text = NULL;
    size_t size;
    struct values values;
    FILE *out = open_memstream(&text, &size);
    options_print_help(out, all, "--");
    fclose(out);
    printf("%s", text);
    assert_string_equal(text, expected);
    free(text);
    options_set_defaults(all, &values);
    assert_false(option_parse(&all[3], &values, "grey"));
    assert_non_null(strstr(error_get(), "one of red, green, blue"));
    assert_false(option_parse(&all[2], &values, "10"));
    assert_non_null(strstr(error_get(), "a whole number from 1 to 9"));
}

static void test_text(void **state) {
    (void)state;
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

static void test_whole_files(void **state) {
    (void)state;
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

/* --- settings ----------------------------------------------------------------------------------
 */

struct maker {
    int count;
    float width;
};

struct painter {
    float width;
    bool bright;
};

static const struct option maker_table[] = {
    {"count", 0, OPTION_INT, offsetof(struct maker, count), 7, 1, 10, .help = ""},
    {"width", 0, OPTION_FLOAT, offsetof(struct maker, width), .5, 0, 1, .help = ""},
    {NULL},
};

static const struct option painter_table[] = {
    {"width", 0, OPTION_FLOAT, offsetof(struct painter, width), 2, 0, 9, .help = ""},
    {"bright", 0, OPTION_FLAG, offsetof(struct painter, bright), 0, .help = ""},
    {NULL},
};

static const struct settings_part maker_part = {"maker", "", maker_table, sizeof(struct maker)},
                                  painter_part = {"painter", "", painter_table,
                                                  sizeof(struct painter)};

static void test_settings(void **state) {
    (void)state;
    struct settings settings = {0}, before;
    settings_add(&settings, &maker_part);
    settings_add(&settings, &painter_part);
    settings_add(&settings, &maker_part); /* once is enough */
    before = settings;
    int count = 0;
    for (struct setting setting = {0}; settings_next(&settings, &setting);)
        count++;
    assert_int_equal(count, 4);
    check_ok("assign", settings_assign(&settings, "count=3, painter.width=4 maker-width=.25"));
    const struct maker *maker = settings_of(&settings, &maker_part);
    const struct painter *painter = settings_of(&settings, &painter_part);
    assert_true(maker->count == 3 && maker->width == .25F);
    assert_true(painter->width == 4 && !painter->bright);
    assert_true(settings_number(&settings, "painter.width") == 4);
    assert_false(settings_same(&settings, &before, &painter_part));
    settings_copy(&settings, &before, &painter_part);
    assert_true(settings_same(&settings, &before, &painter_part));
    assert_false(settings_same(&settings, &before, &maker_part));

    static const char *const bad[][2] = {
        {"width=1", "'width' may be maker.width and painter.width"},
        {"height=1", "no setting is called 'height'"},
        {"maker.bright=on", "no setting is called 'maker.bright'"},
        {"count", "'count' is not key=value"},
        {"painter.width=10", "width: '10' is not a number"},
        {"count=3, width=1", "'width' may be"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(settings_assign(&settings, bad[i][0]));
        printf("    %s\n", error_get());
        assert_non_null(strstr(error_get(), bad[i][1]));
    }
}

static void test_words_and_names(void **state) {
    (void)state;
    struct names names = {0};
    int count = 0;
    for (struct word word = {.at = " ,one, two=2,,three "}; word_next(&word); count++) {
        char text[16];
        snprintf(text, sizeof text, "%.*s", word.length, word.at);
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

/* Texts, lists and sizes as an option's value: told, compared, and too many of them. */
static void test_option_values(void **state) {
    (void)state;
    struct values a, b;
    char text[64];
    const struct option *name = option_find(table, "text"), *size = option_find(table, "size"),
                        *list = option_find(table, "set");
    options_set_defaults(table, &a);
    b = a;
    option_format(name, &a, text, sizeof text);
    assert_string_equal(text, "");
    assert_true(option_equal(name, &a, &b) && option_equal(size, &a, &b));
    check_ok("text", option_parse(name, &a, "one"));
    assert_false(option_equal(name, &a, &b));
    check_ok("text", option_parse(name, &b, (char[]){"one"}));
    option_format(name, &b, text, sizeof text);
    assert_string_equal(text, "one");
    assert_true(option_equal(name, &a, &b));
    check_ok("size", option_parse(size, &a, "4x5"));
    assert_false(option_equal(size, &a, &b));
    for (int i = 0; i < TEXT_LIST_MAX; i++)
        check_ok("list", option_parse(list, &a, "x"));
    assert_false(option_parse(list, &a, "x"));
    printf("    %s\n", error_get());
    option_format(list, &a, text, sizeof text);
    assert_int_equal(atoi(text), TEXT_LIST_MAX);
    assert_true(option_number(option_find(table, "count"), &a) == 5);
    assert_true(option_number(option_find(table, "flag"), &a) == 0);
    assert_true(option_number(option_find(table, "scale"), &a) == 1.5);
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

/* Notes by level, warnings always; a listener hears both however quiet it is, and of a silent thread nobody. */
static void test_log(void **state) {
    (void)state;
    enum log_level before = log_get_level();
    char *text = stderr_of(tell_all);
    log_set_level(before);
    assert_string_equal(text, "manylight: detail 1\nmanylight: note: note 2\n"
                              "manylight: warning: warning 4\nmanylight: warning: unheard\n");
    assert_string_equal(heard, "heard note 2;heard quiet 3;heard warning warning 4;");
    free(text);
}

static void show_progress(void) {
    struct progress progress = {.shown = true};
    progress_show(&progress, 0, "nothing is done");
    progress_show(&progress, .25, "noise");
    progress_show(&progress, .5, "too soon");
    assert_true(progress_end(&progress) > 0);
    progress.shown = false;
    progress.last = 0;
    progress_show(&progress, .5, "no terminal");
    progress_end(&progress);
}

static void test_progress(void **state) {
    (void)state;
    char *text = stderr_of(show_progress);
    assert_non_null(strstr(text, "  25 %"));
    assert_non_null(strstr(text, "left  noise"));
    assert_null(strstr(text, "nothing") ? strstr(text, "nothing") : strstr(text, "too soon"));
    assert_null(strstr(text, "no terminal"));
    free(text);
}

static void test_json(void **state) {
    (void)state;
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    json_print_text(out, "a\"b\\c\nd");
    json_print_number(out, .1);
    json_print_number(out, INFINITY);
    fclose(out);
    assert_string_equal(text, "\"a\\\"b\\\\c\\u000ad\"0.1null");
    free(text);
}

/* A variable, else the home, else neither; and the folders on the way to a file, one of which is a file. */
static void test_folders(void **state) {
    (void)state;
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
    assert_false(folder_make_for(below));
    printf("    %s\n", error_get());
    remove(path);
    free(below);
    free(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_option_values),   cmocka_unit_test(test_log),
        cmocka_unit_test(test_progress),        cmocka_unit_test(test_json),
        cmocka_unit_test(test_folders),         cmocka_unit_test(test_error_prefix),
        cmocka_unit_test(test_halton),          cmocka_unit_test(test_added_channels),
        cmocka_unit_test(test_parallel_for),    cmocka_unit_test(test_layers),
        cmocka_unit_test(test_exr_round_trip),  cmocka_unit_test(test_png_round_trip),
        cmocka_unit_test(test_file_refusals),   cmocka_unit_test(test_options),
        cmocka_unit_test(test_option_help),     cmocka_unit_test(test_foreign_names),
        cmocka_unit_test(test_long_layers),     cmocka_unit_test(test_text),
        cmocka_unit_test(test_whole_files),     cmocka_unit_test(test_settings),
        cmocka_unit_test(test_words_and_names),
    };
    return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}
