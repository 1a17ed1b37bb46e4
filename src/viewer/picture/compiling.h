/* Compiles shaders in the background, so that the window reacts meanwhile. A thread with its own
 * context draws a small stand-in of the scene as the picture will be drawn. The linked programs
 * are handed over. Software OpenGL compiles at the first draw and keeps the result in a cache on
 * disk. */
#ifndef VIEWER_COMPILING_H
#define VIEWER_COMPILING_H

#include "gl/context/context.h"
#include "gl/program.h"
#include "renderer/renderer.h"
#include "scene/stand_in.h"
#include "viewer/window/window.h"

#include <pthread.h>
#include <stdatomic.h>

enum { COMPILING_KNOWN = 64 };

struct compiling {
    struct context *user; /* context that takes the programs */
    void (*wake)(void);
    struct program_store *store;
    struct window *window;   /* hidden */
    struct context *context; /* of the hidden window */
    bool refused;            /* no hidden window can be opened */
    pthread_t thread;
    atomic_int state;
    struct stand_in stand_in;
    struct renderer_desc desc;       /* of the stand-in */
    int count_before;                /* programs when it began */
    uint64_t sum;                    /* hash of the renderer_desc that is being compiled */
    uint64_t known[COMPILING_KNOWN]; /* hashes of compiled ones, oldest first */
    int known_count;
};

/* Prepares compiling for the window's context. Another thread calls `wake` on news. */
void compiling_init(struct compiling *compiling, struct context *user, void (*wake)(void));

/* Returns true if the shaders of this picture are compiled, or cannot be compiled in the
 * background. Else starts compiling, unless others are being compiled. What desc points to may
 * change or go, except the environment. */
bool compiling_has(struct compiling *compiling, const struct renderer_desc *desc);

/* Returns true if compiling_has may now return another answer. */
bool compiling_has_news(struct compiling *compiling);

/* Returns true if nothing is being compiled and no environment is in use. */
bool compiling_rests(struct compiling *compiling);

/* Returns the number of programs compiled since it began. */
int compiling_count(const struct compiling *compiling);

/* Waits until compiling ends: the environment is about to be freed. */
void compiling_wait(struct compiling *compiling);

/* Frees everything. Call it on the window's thread before the window is freed. Accepts a zeroed
 * struct. */
void compiling_free(struct compiling *compiling);

#endif
