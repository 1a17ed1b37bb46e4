/* Rectangles of one dispatch: the draws of a screen pass that draws tiles, each with its own uniforms.
 *
 * A dispatch of one tile would fill a small part of a GPU, and the next would wait for it. So all tiles of a pass are
 * collected, as rows of a storage buffer, and dispatched together: workgroups of z = i have row i. A tile that adds to
 * pixels of an earlier one is of a later round, which is another dispatch, so that sums keep their order.
 */
#ifndef GL_SCREEN_ROWS_H
#define GL_SCREEN_ROWS_H

#include "gl/api.h"

#include <stddef.h>

struct screen_rectangle {
    int x, y, width, height;
};

/* For contexts; accepts NULL. The buffer ends with the context. */
struct screen_rows *screen_rows_create(GLuint buffer);
void screen_rows_free(struct screen_rows *rows);

/* For a context that lives on. */
void screen_rows_delete_buffer(struct screen_rows *rows);

/* The bytes that the buffer has room for. */
extern const GLsizeiptr screen_rows_bytes;

/* A uniform's value of the rectangles that follow: count elements of size bytes each. */
void screen_rows_set(GLint location, const void *values, size_t size, int count);

/* Rectangles of different parts share no pixel. Dispatches all before where there is no room. */
void screen_rows_add(const struct screen_rectangle *rectangle, int part);

/* Calls dispatch for each round with what holds all of its rectangles, then there are none. */
void screen_rows_flush(void (*dispatch)(int width, int height, int first, int count, int stride));

bool screen_rows_empty(void);
bool screen_rows_full(void);

#endif
