/* Prints facts of `info` to json, or as text on stdout if json->out is NULL. `format` is a
 * printf format of the value. */
#ifndef APPS_FACTS_H
#define APPS_FACTS_H

#include "base/json.h"

void fact_text(struct json *json, const char *key, const char *format, const char *text);
void fact_count(struct json *json, const char *key, const char *format, long long count);
void fact_number(struct json *json, const char *key, const char *format, double number);

/* Prints text as "(x, y, z)" between two words. */
void fact_vector(struct json *json, const char *key, const char *before, const float v[3],
                 const char *after);

/* Prints `word` as text if the flag is true, else nothing. */
void fact_flag(struct json *json, const char *key, bool flag, const char *word);

/* Prints words as text only, never as JSON. */
void fact_words(const struct json *json, const char *words);

#endif
