#include "apps/facts.h"

void fact_text(struct json *json, const char *key, const char *format, const char *text) {
    json_text(json, key, text);
    if (!json->out)
        printf(format, text);
}

void fact_count(struct json *json, const char *key, const char *format, long long count) {
    json_number(json, key, (double)count);
    if (!json->out)
        printf(format, count);
}

void fact_number(struct json *json, const char *key, const char *format, double number) {
    json_number(json, key, number);
    if (!json->out)
        printf(format, number + 0.0); /* no "-0" */
}

void fact_vector(struct json *json, const char *key, const char *before, const float v[3],
                 const char *after) {
    json_vector(json, key, v);
    if (!json->out)
        printf("%s(%.4g, %.4g, %.4g)%s", before, v[0] + 0.0, v[1] + 0.0, v[2] + 0.0, after);
}

void fact_flag(struct json *json, const char *key, bool flag, const char *word) {
    json_flag(json, key, flag);
    fact_words(json, flag ? word : "");
}

void fact_words(const struct json *json, const char *words) {
    if (!json->out)
        fputs(words, stdout);
}
