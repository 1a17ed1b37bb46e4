/* Compiles and caches shader programs.
 *
 * A context caches its programs by source. Equal sources give the same program without compilation,
 * even for a while after its last user freed it. Uniforms of a shared program may have other
 * values, so a pass sets all of its uniforms at each draw.
 *
 * A store holds linked binaries for contexts of other threads (context_set_store). */
#ifndef GL_PROGRAM_H
#define GL_PROGRAM_H

#include "gl/api.h"

#include <stdbool.h>

/* Screen shader: a body that runs for each pixel (gl/screen.h). */
struct screen_desc {
    const char *body; /* file name; NULL: no screen pass */
    bool layers;      /* instance i writes layer first_layer + i of the targets */
    bool marks;       /* its passes mark pixels of a mask that the body does not discard */
    bool masked;      /* its passes run at marked pixels of a mask */
    bool blended;     /* its passes may add to targets, which are GL_RGBA32F */
    bool tiled;       /* its passes draw rectangles, each with its own uniforms */
};

/* File names below glsl/ or src/ (gl/glsl.h); NULL: no such stage. */
struct program_desc {
    const char *vertex, *geometry, *fragment, *compute;
    /* Replaces the stages; a vertex stage of its own is used if passes are drawn. */
    struct screen_desc screen;
    const char *defines; /* "NAME VALUE;NAME VALUE", for all stages */
};

/* Compiles and links, or takes a cached program. Error: names file and line, with the driver's
 * message. */
bool program_init(GLuint *program, const struct program_desc *desc);
void program_free(GLuint *program);
#define programs_free(...) MEM_EACH(GLuint, program_free, __VA_ARGS__)

/* Returns the screen shader of a program that is dispatched; NULL for other programs. */
const struct screen_desc *program_dispatched(GLuint program);

/* Returns the number of programs of the current context that are in use. */
int program_use_count(void);

/* Creates a context's cache. For contexts only. Free accepts NULL and leaves the programs, which
 * end with the context. */
struct program_cache *program_cache_create(void);
void program_cache_free(struct program_cache *programs);

/* Deletes the cached programs of the current context, for a context that outlives its cache. */
void program_cache_delete_programs(struct program_cache *programs);

/* Creates a store, which must outlive the contexts that use it. Free accepts NULL. */
struct program_store *program_store_create(void);
void program_store_free(struct program_store *store);

/* Returns the number of programs added so far. Accepts NULL. */
int program_store_count(struct program_store *store);

#endif
