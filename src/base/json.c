#include "base/json.h"

#include <math.h>

int utf8_length(const unsigned char *c) {
    if (*c < 0x80)
        return 1;
    int length = *c >= 0xc2 && *c < 0xe0 ? 2 : *c >= 0xe0 && *c < 0xf0 ? 3 : 4;
    bool begins = *c >= 0xc2 && *c < 0xf5,
         /* Overlong forms, surrogates, and what is above U+10FFFF. */
        forbidden = (*c == 0xe0 && c[1] < 0xa0) || (*c == 0xed && c[1] > 0x9f) ||
                    (*c == 0xf0 && c[1] < 0x90) || (*c == 0xf4 && c[1] > 0x8f);
    for (int i = 1; begins && i < length; i++)
        begins = (c[i] & 0xc0) == 0x80;
    return begins && !forbidden ? length : 0;
}

void json_print_text(FILE *out, const char *text) {
    fputc('"', out);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        int length = utf8_length(c);
        if (length == 0) {
            fprintf(out, "\\ufffd");
        } else if (length > 1) {
            fwrite(c, 1, (size_t)length, out);
            c += length - 1;
        } else if (*c == '"' || *c == '\\') {
            fprintf(out, "\\%c", *c);
        } else if (*c < 0x20) {
            fprintf(out, "\\u%04x", *c);
        } else {
            fputc(*c, out);
        }
    }
    fputc('"', out);
}

/* All before a value. False: there is nowhere to write. */
static bool begin(struct json *json, const char *key) {
    if (!json->out)
        return false;
    if (json->depth > 0 && json->depth <= json->lines)
        fprintf(json->out, "%s\n%*s", json->follows ? "," : "", json->depth, "");
    else if (json->follows)
        fprintf(json->out, ", ");
    json->follows = true;
    if (key) {
        json_print_text(json->out, key);
        fprintf(json->out, ": ");
    }
    return true;
}

void json_open(struct json *json, const char *key, const char *bracket) {
    json_value(json, key, bracket);
    json->depth++;
    json->follows = false;
}

void json_close(struct json *json, const char *bracket) {
    if (json->out)
        fprintf(json->out, "%s%s", bracket, --json->depth == 0 ? "\n" : "");
    json->follows = true;
}

void json_text(struct json *json, const char *key, const char *text) {
    if (!text)
        json_value(json, key, "null");
    else if (begin(json, key))
        json_print_text(json->out, text);
}

void json_number(struct json *json, const char *key, double number) {
    bool whole = number == rint(number) && fabs(number) < 1e15;
    if (!isfinite(number))
        json_value(json, key, "null");
    else if (begin(json, key)) /* no "-0" */
        fprintf(json->out,
                whole                             ? "%.0f"
                : (double)(float)number == number ? "%.9g"
                                                  : "%.12g",
                number + 0.0);
}

void json_flag(struct json *json, const char *key, bool flag) {
    json_value(json, key, flag ? "true" : "false");
}

void json_vector(struct json *json, const char *key, const float vector[3]) {
    json_open(json, key, "[");
    for (int c = 0; c < 3; c++)
        json_number(json, NULL, (double)vector[c]);
    json_close(json, "]");
}

void json_value(struct json *json, const char *key, const char *value) {
    if (begin(json, key))
        fprintf(json->out, "%s", value);
}
