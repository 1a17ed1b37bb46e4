/* Collects the rectangles of a tiled screen pass, each with its own uniforms, into one dispatch.
 *
 * A dispatch of one tile would fill a small part of a GPU, and the next would wait for it. All
 * tiles of a pass are therefore rows of a storage buffer, dispatched together: workgroups of z = i
 * take row i. A tile that overlaps an earlier one of its part goes into a later round, another
 * dispatch, so sums keep their order. */
#ifndef GL_SCREEN_ROWS_H
#define GL_SCREEN_ROWS_H

#include "gl/api.h"

#include <stddef.h>

struct screen_rectangle {
    int x, y, width, height;
};

/* Creates a context's rows. For contexts only. Free accepts NULL. The buffer ends with the
 * context. */
struct screen_rows *screen_rows_create(GLuint buffer);
void screen_rows_free(struct screen_rows *rows);

/* Deletes the buffer, for a context that outlives its rows. */
void screen_rows_delete_buffer(struct screen_rows *rows);

/* Bytes that the buffer must have. */
extern const GLsizeiptr screen_rows_bytes;

/* Sets a uniform of the rectangles that follow: count elements of size bytes each. */
void screen_rows_set(GLint location, const void *values, size_t size, int count);

/* Adds a rectangle. Rectangles of different parts share no pixel. Asserts room: flush if
 * screen_rows_full. */
void screen_rows_add(const struct screen_rectangle *rectangle, int part);

/* Calls dispatch for each round and removes all rows. width, height: largest rectangle of the
 * round. first, count: its rows. stride: uvec4 per row. */
void screen_rows_flush(void (*dispatch)(int width, int height, int first, int count, int stride));

bool screen_rows_empty(void);
bool screen_rows_full(void);

#endif
