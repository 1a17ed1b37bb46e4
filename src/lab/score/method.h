/* method.json of an entry: what made its pictures, and how fast. bench/schema/method.schema.json
 * says the same. */
#ifndef LAB_SCORE_METHOD_H
#define LAB_SCORE_METHOD_H

#ifdef __cplusplus
extern "C" {
#endif

#include <stdbool.h>

enum { METHOD_LAYERS_MAX = 16 };

/* A picture as whoever made it has it. */
struct method_sum {
    char *file;
    char digits[65]; /* its SHA-256, as lab/score/sha256.h writes it */
};

struct method {
    char name[128], version[64], device[128]; /* "" where it does not tell */
    char layers[METHOD_LAYERS_MAX][32];       /* that it promises besides beauty */
    int layer_count;
    struct method_sum *sums;
    int sum_count;
    char *json; /* all of it, in one line */
};

/* Error: names the file, the field and what it must be. */
bool method_read(struct method *method, const char *path);
void method_free(struct method *method);

/* The digits that it lists for a picture; NULL: none. */
const char *method_sum_of(const struct method *method, const char *file);

#ifdef __cplusplus
}
#endif

#endif
