/* Options and settings as texts: told, read, refused, listed. */
#define _POSIX_C_SOURCE 200809L
#include "support.h"

#include "base/option.h"
#include "base/settings.h"

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

TEST(options) {
    struct values values;
    options_set_defaults(table, &values);
    assert_int_equal(values.count, 5);
    assert_int_equal(values.size[1], 800);
    char *argv[] = {"x",    "a",     "--count=7", "-f",    "--colour", "red", "--size", "4x5",
                    "-thi", "--set", "k=1",       "--set", "l=2",      "--",  "-b"};
    const char *positional[2];
    int count;
    check_ok("parse",
             options_parse_arguments(table, &values, 15, argv, positional, 2, &count, NULL));
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
        const char *name = form("%.*s", (int)strcspn(bad[i], "="), bad[i]);
        const struct option *option = option_find(table, name);
        assert_non_null(option);
        check_refused(option_parse(option, &values, bad[i] + strcspn(bad[i], "=") + 1), "");
    }
    check_ok("per cent", option_parse(option_find(table, "scale"), &values, "150%"));
    assert_true(values.scale == 1.5F);
}

/* The help of options of each type, letter by letter, and what a value is refused with. */
TEST(option_help) {
    static const char *const names[] = {"red", "green", "blue", NULL};
    static const struct option all[] = {
        {"on", 'o', OPTION_FLAG, offsetof(struct values, flag), .default_value = 1, .help = "one"},
        {"off", 0, OPTION_FLAG, offsetof(struct values, flag), .help = "two\nlines"},
        {"count", 0, OPTION_INT, offsetof(struct values, count), 5, 1, 9, .help = "three"},
        {"hue", 'h', OPTION_CHOICE, offsetof(struct values, choice), 1, .choices = names,
         .help = "four"},
        {"size", 0, OPTION_SIZE, offsetof(struct values, size), 8, 1, 64, .help = "five"},
        {"file", 0, OPTION_TEXT, offsetof(struct values, text), .value_name = "F", .help = "six",
         .rare = true},
        {NULL},
    };
    static const char expected[] =
        "  -o, --on                   one [on]\n"
        "  --off                      two\n                             lines\n"
        "  --count N                  three [5; 1 to 9]\n"
        "  -h, --hue NAME             four [green; one of red, green, blue]\n"
        "  --size WxH                 five [8x8]\n";
    static const char rest[] = "  --file F                   six\n";
    char *text = NULL;
    size_t size;
    struct values values;
    FILE *out = open_memstream(&text, &size);
    assert_int_equal(options_print_help(out, all, "--", false), 1);
    assert_int_equal(options_print_help(out, all, "--", true), 0);
    fclose(out);
    printf("%s", text);
    const size_t once = strlen(expected);
    assert_memory_equal(text, expected, once);
    assert_memory_equal(text + once, expected, once);
    assert_string_equal(text + 2 * once, rest);
    free(text);
    options_set_defaults(all, &values);
    check_refused(option_parse(&all[3], &values, "grey"), "one of red, green, blue");
    check_refused(option_parse(&all[2], &values, "10"), "a whole number from 1 to 9");
}

/* Words of a command line that mean nothing, or lack something. */
TEST(bad_arguments) {
    static const struct {
        const char *arguments[3], *message;
    } bad[] = {
        {{"-z"}, "unknown option '-z'"},
        {{"--none=1"}, "unknown option '--none=1'"},
        {{"--aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"},
         "unknown option '--aaaa"},
        {{"--count"}, "--count needs a value"},
        {{"a", "-", "c"}, "one argument too many: 'c'"},
        {{"--size", "4y5"}, "size: '4y5' is not WIDTHxHEIGHT, each from 1 to 16384"},
        {{"--size", "4x5x"}, "size: '4x5x' is not"},
        {{"--size", "x5"}, "size: 'x5' is not"},
        {{"--count", "99999999999999999999"},
         "count: '99999999999999999999' is not a whole number"},
        {{"--count", "0"}, "count: '0' is not a whole number from 1 to 10"},
        {{"--scale", "-1"}, "scale: '-1' is not a number from 0 to 2"},
        {{"--scale", "1ms"}, "scale: '1ms' is not"},
        {{"-f", "--flag=perhaps"}, "flag: 'perhaps' is not on or off"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct values values;
        char *argv[4] = {"x"};
        const char *positional[2];
        int argc = 1, count;
        for (; argc < 4 && bad[i].arguments[argc - 1]; argc++)
            argv[argc] = (char *)bad[i].arguments[argc - 1];
        options_set_defaults(table, &values);
        check_refused(
            options_parse_arguments(table, &values, argc, argv, positional, 2, &count, NULL),
            bad[i].message);
    }
}

/* A unit may stand behind a number; other letters may not. */
TEST(units) {
    static const struct option time = {"time",    0, OPTION_FLOAT, offsetof(struct values, scale),
                                       1,         0, 1000,         .unit = "ms",
                                       .help = ""};
    struct values values = {0};
    check_ok("16ms", option_parse(&time, &values, "16ms"));
    assert_true(values.scale == 16);
    check_ok("16", option_parse(&time, &values, "17"));
    assert_true(values.scale == 17);
    assert_false(option_parse(&time, &values, "16s"));
    assert_false(option_parse(&time, &values, "ms"));
    assert_true(values.scale == 17);
}

/* Texts, lists and sizes as an option's value: told, compared, and too many of them. */
TEST(option_values) {
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
    check_refused(option_parse(list, &a, "x"), "");
    option_format(list, &a, text, sizeof text);
    assert_int_equal(atoi(text), TEXT_LIST_MAX);
    assert_true(option_number(option_find(table, "count"), &a) == 5);
    assert_true(option_number(option_find(table, "flag"), &a) == 0);
    assert_true(option_number(option_find(table, "scale"), &a) == 1.5);
}

/* --- settings --------------------------------------------------------------------------------- */

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

TEST(settings) {
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
    const struct maker *maker = settings_of(struct maker, &settings, &maker_part);
    const struct painter *painter = settings_of(struct painter, &settings, &painter_part);
    assert_true(maker->count == 3 && maker->width == .25F);
    assert_true(painter->width == 4 && !painter->bright);
    assert_true(settings_number(&settings, "painter.width") == 4);
    assert_false(settings_same(&settings, &before, &painter_part));
    struct word word = {.at = "painter.width=4"};
    struct settings given = before;
    assert_true(word_next(&word));
    settings_copy_given(&given, &settings); /* what was assigned was not given */
    assert_true(settings_same(&given, &before, &painter_part));
    check_ok("give", settings_give_word(&settings, &word));
    settings_copy_given(&given, &settings);
    assert_true(settings_number(&given, "painter.width") == 4);
    assert_true(settings_same(&given, &before, &maker_part));
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
        check_refused(settings_assign(&settings, bad[i][0]), bad[i][1]);
    }
}

/* The help of settings, with what they need; needs word by word; and assignments that are
 * too long. */
TEST(settings_help) {
    char *text = NULL, longer[400];
    size_t size;
    struct settings settings = {0};
    struct setting count = {&maker_part, &maker_table[0]}, wide = {&painter_part, painter_table};
    FILE *out = open_memstream(&text, &size);
    settings_add(&settings, &maker_part);
    setting_print_help(out, &count, "");
    setting_print_help(out, &wide, "maker.count>1");
    fclose(out);
    printf("%s", text);
    assert_string_equal(text, "  maker.count                 [7; 1 to 10]\n"
                              "  painter.width              ; with maker.count>1 [2; 0 to 9]\n");
    struct need need = {.word.at = "maker.count>1, colour!=red|green"};
    assert_true(need_next(&need) && need.sign == '>' && need_names(&need, "1"));
    assert_string_equal(need.name, "maker.count");
    assert_true(need_next(&need) && need.sign == '!');
    assert_string_equal(need.name, "colour");
    assert_true(need_names(&need, "red") && need_names(&need, "green"));
    assert_false(need_names(&need, "gre") || need_names(&need, "red|green"));
    assert_false(need_next(&need));
    need = (struct need){.word.at = NULL};
    assert_false(need_next(&need));
    free(text);
    snprintf(longer, sizeof longer, "count=%0*d", 300, 3);
    check_refused(settings_assign(&settings, longer), "...' is too long");
}

RUN_TESTS(NULL, NULL)
