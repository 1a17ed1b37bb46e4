/* A program that looks up maps as a technique does, rebuilt only if the lookup changes. */
#ifndef INSPECT_LOOKUP_H
#define INSPECT_LOOKUP_H

#include "passes/visibility/visibility.h"

struct lookup {
    GLuint program;
    char *defines; /* defines of the program */
    struct buffer params;
};

/* Builds the full-screen program with this fragment shader, unless it is current. Error: GPU
 * memory, shader; lookup is then zeroed. */
bool lookup_fit(struct lookup *lookup, const char *fragment, const struct visibility_desc *desc);

/* Accepts a zeroed lookup. */
void lookup_free(struct lookup *lookup);

#endif
