#include "apps/report/html.h"

void html_print_text(FILE *out, const char *text) {
    for (; *text; text++)
        switch (*text) {
        case '&':
            fputs("&amp;", out);
            break;
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        default:
            fputc(*text, out);
        }
}

void html_print_number(FILE *out, double value) {
    fprintf(out, value >= 1000 ? "%.0f" : "%.4g", value);
}
