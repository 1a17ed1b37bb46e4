/* Values as JSON text. */
#ifndef BASE_JSON_H
#define BASE_JSON_H

#include <stdbool.h>
#include <stdio.h>

/* Bytes of the character as UTF-8 has it [RFC 3629 §4]; 0: none begins here. A zero follows the text. */
int utf8_length(const unsigned char *c);

/* In quotes, escaped; U+FFFD for each byte that is not UTF-8. */
void json_print_text(FILE *out, const char *text);

/* JSON that is written value by value, with commas between. Nothing is written where out is NULL.
 *
 *     struct json json = {.out = stdout};
 *     json_open(&json, NULL, "{");
 *     json_number(&json, "width", 16);
 *     json_close(&json, "}");
 */
struct json {
    FILE *out;
    int lines; /* depths whose members begin a line: 1 of the outermost value, 2 of its members, too */
    int depth;
    bool follows; /* a member of the same value */
};

/* An object or an array: "{" or "[". Here and below key is NULL in arrays. */
void json_open(struct json *json, const char *key, const char *bracket);
void json_close(struct json *json, const char *bracket);

/* NULL: null. */
void json_text(struct json *json, const char *key, const char *text);

/* Whole, with the digits that tell a float from its neighbours, or with twelve. JSON knows no NaN and no infinity, so these are
 * null. */
void json_number(struct json *json, const char *key, double number);
void json_flag(struct json *json, const char *key, bool flag);
void json_vector(struct json *json, const char *key, const float vector[3]);

/* A value that is JSON already. */
void json_value(struct json *json, const char *key, const char *value);

#endif
