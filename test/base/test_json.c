/* Values as JSON text: escapes, numbers, and bytes that are not UTF-8. */
#define _POSIX_C_SOURCE 200809L
#include "support.h"

#include "base/json.h"

TEST(values) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    struct json json = {.out = out, .lines = 1};
    json_open(&json, NULL, "{");
    json_text(&json, "a\"b", "c\\d\n");
    json_open(&json, "e", "[");
    json_number(&json, NULL, .1);
    json_number(&json, NULL, (double).1F);
    json_number(&json, NULL, 2147483648.);
    json_number(&json, NULL, INFINITY);
    json_open(&json, NULL, "[");
    json_close(&json, "]");
    json_close(&json, "]");
    json_vector(&json, "f", (float[]){-0.F, 1e-9F, 3});
    json_flag(&json, "g", true);
    json_text(&json, "h", NULL);
    json_close(&json, "}");
    fclose(out);
    assert_string_equal(
        text,
        "{\n \"a\\\"b\": \"c\\\\d\\u000a\",\n \"e\": [0.1, 0.100000001, 2147483648, null, []],\n"
        " \"f\": [0, 9.99999972e-10, 3],\n \"g\": true,\n \"h\": null}\n");
    free(text);
}

/* Characters of one to four bytes stay; bytes that are none are replaced: the sharpest cases of RFC
 * 3629. */
TEST(utf8) {
    static const struct {
        const char *text, *json;
    } rows[] = {
        {"\x7f\xc3\xa4\xe2\x82\xac\xf0\x9f\x92\xa1",
         "\"\x7f\xc3\xa4\xe2\x82\xac\xf0\x9f\x92\xa1\""},
        {"a\xff"
         "b",
         "\"a\\ufffdb\""},
        {"\xc3", "\"\\ufffd\""},
        {"\xe2\x82", "\"\\ufffd\\ufffd\""},
        {"\xc0\x80", "\"\\ufffd\\ufffd\""},
        {"\xc3\"", "\"\\ufffd\\\"\""},
        {"\xed\xa0\x80", "\"\\ufffd\\ufffd\\ufffd\""},
        {"\xf4\x90\x80\x80", "\"\\ufffd\\ufffd\\ufffd\\ufffd\""},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *text = NULL;
        size_t size;
        FILE *out = open_memstream(&text, &size);
        json_print_text(out, rows[i].text);
        fclose(out);
        assert_string_equal(text, rows[i].json);
        free(text);
    }
}

RUN_TESTS(NULL, NULL)
