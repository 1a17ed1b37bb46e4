/* A program that looks maps up as a technique does; made anew only where the lookup is another. */
#ifndef INSPECT_LOOKUP_H
#define INSPECT_LOOKUP_H

#include "passes/visibility/visibility.h"

struct lookup {
    GLuint program;
    char *defines; /* what the program is made for */
    struct buffer params;
};

/* A fullscreen pass with this fragment shader. Error: GPU memory, shader; it is then zeroed. */
bool lookup_fit(struct lookup *lookup, const char *fragment, const struct visibility_desc *desc);

/* Accepts a zeroed one. */
void lookup_free(struct lookup *lookup);

#endif
