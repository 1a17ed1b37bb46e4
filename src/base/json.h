/* Writes values as JSON text. */
#ifndef BASE_JSON_H
#define BASE_JSON_H

#include <stdbool.h>
#include <stdio.h>

/* Returns the bytes of the UTF-8 character at c [RFC 3629 §4]; 0: none begins here. The text is
 * zero-terminated. */
int utf8_length(const unsigned char *c);

/* Prints the text in quotes, escaped, with U+FFFD for each byte that is not UTF-8. */
void json_print_text(FILE *out, const char *text);

/* JSON written value by value, with commas between. Nothing is written if out is NULL.
 *
 *     struct json json = {.out = stdout};
 *     json_open(&json, NULL, "{");
 *     json_number(&json, "width", 16);
 *     json_close(&json, "}");
 */
struct json {
    FILE *out;
    int lines; /* depths whose members start a line: 1 the outermost value, 2 also its members */
    int depth;
    bool follows; /* the next member needs a comma */
};

/* Opens an object "{" or an array "[". key is NULL in arrays, here and below. */
void json_open(struct json *json, const char *key, const char *bracket);
void json_close(struct json *json, const char *bracket);

/* Writes a string; NULL: null. */
void json_text(struct json *json, const char *key, const char *text);

/* Writes a number: an integer without a point, a float value with the digits that identify it,
 * others with twelve. JSON has no NaN and no infinity; they become null. */
void json_number(struct json *json, const char *key, double number);
void json_flag(struct json *json, const char *key, bool flag);
void json_vector(struct json *json, const char *key, const float vector[3]);

/* Writes a value that is JSON text. */
void json_value(struct json *json, const char *key, const char *value);

#endif
