/* Shaders are compiled in the background, so that the window lives on meanwhile: a thread with a
 * context of its own draws a stand-in of the scene as the picture will be drawn, but smaller. Its
 * programs are handed over as the driver has linked them; what software OpenGL compiles when it
 * first draws with them it keeps on disk, and finds there. */
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
    struct context *user; /* who takes what is compiled */
    void (*wake)(void);
    struct program_store *store;
    struct window *window;   /* never seen */
    struct context *context; /* its own */
    bool refused;            /* there is none */
    pthread_t thread;
    atomic_int state;
    struct stand_in stand_in;
    struct renderer_desc desc;       /* of the stand-in */
    int count_before;                /* of programs, when it began */
    uint64_t sum;                    /* of what is compiled */
    uint64_t known[COMPILING_KNOWN]; /* of what was, the oldest first */
    int known_count;
};

/* For the context of the window; wake is called from another thread when there is news. */
void compiling_init(struct compiling *compiling, struct context *user, void (*wake)(void));

/* Whether the shaders of such a picture have been compiled, or cannot be in the background; else
 * begins that, unless others are being compiled. What desc points to may go or change but for the
 * environment. */
bool compiling_has(struct compiling *compiling, const struct renderer_desc *desc);

/* Whether it may be asked again. */
bool compiling_has_news(struct compiling *compiling);

/* Whether nothing is being compiled, and no environment is in use. */
bool compiling_rests(struct compiling *compiling);

/* How many programs have been compiled since it began. */
int compiling_count(const struct compiling *compiling);

/* Waits for what is being compiled: its environment goes. */
void compiling_wait(struct compiling *compiling);

/* Accepts a zeroed one. From the thread that has the window, before that goes. */
void compiling_free(struct compiling *compiling);

#endif
