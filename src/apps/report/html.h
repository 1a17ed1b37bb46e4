/* Text of a page. */
#ifndef APPS_REPORT_HTML_H
#define APPS_REPORT_HTML_H

#include <stdio.h>

/* With &, <, > and quotes escaped. */
void html_print_text(FILE *out, const char *text);

/* Four digits, from 1000 on those before the point: never a power of ten. */
void html_print_number(FILE *out, double value);

#endif
