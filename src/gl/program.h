/* Shader programs.
 *
 * A context keeps what it has compiled: whoever asks for the same sources again gets the same
 * program, at once, and for a while after all have freed it. So a pass sets all its uniforms at
 * each draw, and what is made anew for another size or setting costs no compilation.
 *
 * A store holds programs as the driver has linked them, for contexts of other threads (context_set_store).
 */
#ifndef GL_PROGRAM_H
#define GL_PROGRAM_H

#include "gl/api.h"

#include <stdbool.h>

/* A body that runs for each pixel (gl/screen.h). */
struct screen_desc {
    const char *body; /* file name; NULL = no screen pass */
    bool layers;      /* instance i of a draw has layer first_layer + i of the targets */
    bool marks;       /* its passes mark the pixels of a mask that the body does not discard */
    bool masked;      /* its passes run at the marked pixels of a mask */
    bool blended;     /* its passes may add to targets, which are GL_RGBA32F */
    bool tiled;       /* its passes draw rectangles, each with uniforms of its own */
};

/* File names below glsl/; NULL = no such stage. */
struct program_desc {
    const char *vertex, *geometry, *fragment, *compute;
    struct screen_desc
        screen;          /* in place of stages, but for a vertex stage of its own if it is drawn */
    const char *defines; /* "NAME VALUE;NAME VALUE", for all stages */
};

/* Compiles and links. Error: names file and line, with the driver's message. */
bool program_init(GLuint *program, const struct program_desc *desc);
void program_free(GLuint *program);
#define programs_free(...) MEM_EACH(GLuint, program_free, __VA_ARGS__)

/* What it runs for each pixel, if that is by a dispatch; else NULL. */
const struct screen_desc *program_dispatched(GLuint program);

/* How many programs of the current context nobody has freed. */
int program_use_count(void);

/* For contexts: what they keep. Freed without the programs, which end with the context; accepts
 * NULL.
 */
struct program_cache *program_cache_create(void);
void program_cache_free(struct program_cache *programs);

/* Deletes those that the current context keeps, for a context that lives on. */
void program_cache_delete_programs(struct program_cache *programs);

/* Must outlive the use that contexts make of it. Freed: accepts NULL. */
struct program_store *program_store_create(void);
void program_store_free(struct program_store *store);

/* How many it has been given so far. Accepts NULL. */
int program_store_count(struct program_store *store);

#endif
