#define _POSIX_C_SOURCE 200809L
#include "scene/gltf/data_uri.h"

#include "base/error.h"
#include "base/memory.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static int hex_digit(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

size_t uri_unescape(char *uri) {
    char *to = uri;
    for (const char *from = uri; *from; from++) {
        int high = *from == '%' ? hex_digit(from[1]) : -1;
        int low = high >= 0 ? hex_digit(from[2]) : -1;
        *to++ = low >= 0 ? (char)(high * 16 + low) : *from;
        from += low >= 0 ? 2 : 0;
    }
    *to = '\0';
    return (size_t)(to - uri);
}

bool data_uri_is(const char *uri) {
    return strncasecmp(uri, "data:", 5) == 0;
}

/* Whether the last parameter before the comma says so. */
static bool is_base64(const char *uri, const char *comma) {
    static const char word[] = "base64";
    const size_t length = sizeof word - 1;
    while (comma > uri && isspace((unsigned char)comma[-1]))
        comma--;
    return (size_t)(comma - uri) > length && strncasecmp(comma - length, word, length) == 0 &&
           strchr("; ", comma[-(ptrdiff_t)length - 1]);
}

/* Both alphabets [RFC 4648]. */
static int base64_digit(char c) {
    return c >= 'A' && c <= 'Z'   ? c - 'A'
           : c >= 'a' && c <= 'z' ? c - 'a' + 26
           : c >= '0' && c <= '9' ? c - '0' + 52
           : c == '+' || c == '-' ? 62
           : c == '/' || c == '_' ? 63
                                  : -1;
}

/* In place: three bytes of four digits. What is left of the last four is padding. */
static bool decode_base64(struct file_bytes *bytes) {
    unsigned bits = 0;
    size_t digits = 0, size = 0;
    for (size_t i = 0; i < bytes->size && bytes->data[i] != '='; i++) {
        char c = (char)bytes->data[i];
        int digit = base64_digit(c);
        if (isspace((unsigned char)c))
            continue;
        if (digit < 0)
            return error_set("its data URI has the byte 0x%02X at %zu, which is no digit of base64",
                             (unsigned)(unsigned char)c, i);
        bits = bits << 6 | (unsigned)digit;
        if (++digits % 4 != 1)
            bytes->data[size++] = (unsigned char)(bits >> (6 - 2 * ((digits - 1) % 4)));
    }
    bytes->size = size;
    return true;
}

bool data_uri_decode(struct file_bytes *bytes, const char *uri) {
    *bytes = (struct file_bytes){0};
    const char *comma = strchr(uri, ',');
    if (!comma)
        return error_set("its data URI has no comma");
    char *text = mem_strdup(comma + 1);
    bytes->data = (unsigned char *)text;
    bytes->size = uri_unescape(text);
    if (!is_base64(uri, comma) || decode_base64(bytes))
        return true;
    free(text);
    *bytes = (struct file_bytes){0};
    return false;
}
