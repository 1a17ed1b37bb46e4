/* Facts of `info`, each as text on stdout or as JSON: as text where json->out is NULL. Formats take
 * the value. */
#ifndef APPS_FACTS_H
#define APPS_FACTS_H

#include "base/json.h"

void fact_text(struct json *json, const char *key, const char *format, const char *text);
void fact_count(struct json *json, const char *key, const char *format, long long count);
void fact_number(struct json *json, const char *key, const char *format, double number);

/* As text "(x, y, z)" between two words. */
void fact_vector(struct json *json, const char *key, const char *before, const float v[3],
                 const char *after);

/* As text the word where it is true, or nothing. */
void fact_flag(struct json *json, const char *key, bool flag, const char *word);

/* What is text alone. */
void fact_words(const struct json *json, const char *words);

#endif
