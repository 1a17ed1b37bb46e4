/* Values as JSON text. */
#ifndef BASE_JSON_H
#define BASE_JSON_H

#include <stdio.h>

/* Bytes of the character as UTF-8 has it [RFC 3629 §4]; 0: none begins here. A zero follows the text. */
int utf8_length(const unsigned char *c);

/* In quotes, escaped; U+FFFD for each byte that is not UTF-8. */
void json_print_text(FILE *out, const char *text);

/* With the digits that tell a float from its neighbours; JSON knows no NaN and no infinity, so
 * these are null. */
void json_print_number(FILE *out, double number);

#endif
