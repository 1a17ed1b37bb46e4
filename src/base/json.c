#include "base/json.h"

#include <math.h>
#include <stdbool.h>

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

void json_print_number(FILE *out, double number) {
    if (isfinite(number))
        fprintf(out, "%.9g", number);
    else
        fprintf(out, "null");
}
