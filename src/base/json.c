#include "base/json.h"

#include <math.h>

void json_print_text(FILE *out, const char *text) {
    fputc('"', out);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(out, "\\%c", *c);
        else if (*c < 0x20)
            fprintf(out, "\\u%04x", *c);
        else
            fputc(*c, out);
    }
    fputc('"', out);
}

void json_print_number(FILE *out, double number) {
    if (isfinite(number))
        fprintf(out, "%.9g", number);
    else
        fprintf(out, "null");
}
