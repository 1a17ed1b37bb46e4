/* Values as JSON text. */
#ifndef BASE_JSON_H
#define BASE_JSON_H

#include <stdio.h>

/* In quotes, escaped; U+FFFD for each byte that is not UTF-8. */
void json_print_text(FILE *out, const char *text);

/* With the digits that tell a float from its neighbours; JSON knows no NaN and no infinity, so
 * these are null. */
void json_print_number(FILE *out, double number);

#endif
