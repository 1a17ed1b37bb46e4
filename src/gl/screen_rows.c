#include "gl/screen_rows.h"

#include "base/memory.h"
#include "shared/bindings.h"
#include "shared/light.h"

#include <assert.h>
#include <string.h>

enum { ROWS_MAX = 256, LOCATIONS = LOCATION_SLOT_LIGHTS + LIGHTS_MAX };

/* What GLSL reads as uvec4: the rectangle, then a value of each location. */
struct cell {
    GLuint words[4];
};

struct row {
    struct screen_rectangle rectangle;
    int part, round;
    struct cell values[LOCATIONS];
};

struct screen_rows {
    GLuint buffer;
    int count, rounds;
    int locations; /* that have been set, from 0 on */
    struct cell values[LOCATIONS];
    struct row rows[ROWS_MAX];
    struct cell upload[ROWS_MAX * (1 + LOCATIONS)];
};

const GLsizeiptr screen_rows_bytes = sizeof((struct screen_rows *)NULL)->upload;

struct screen_rows *screen_rows_create(GLuint buffer) {
    struct screen_rows *rows = mem_alloc(1, sizeof *rows);
    rows->buffer = buffer;
    return rows;
}

void screen_rows_free(struct screen_rows *rows) {
    free(rows);
}

void screen_rows_delete_buffer(struct screen_rows *rows) {
    gl.DeleteBuffers(1, &rows->buffer);
    rows->buffer = 0;
}

bool screen_rows_empty(void) {
    return gl.screen_rows->count == 0;
}

bool screen_rows_full(void) {
    return gl.screen_rows->count == ROWS_MAX;
}

void screen_rows_set(GLint location, const void *values, size_t size, int count) {
    struct screen_rows *rows = gl.screen_rows;
    assert(location + count <= LOCATIONS);
    for (int i = 0; i < count; i++)
        memcpy(&rows->values[location + i], (const char *)values + (size_t)i * size, size);
    if (rows->locations < location + count)
        rows->locations = location + count;
}

static bool overlap(const struct screen_rectangle *a, const struct screen_rectangle *b) {
    return a->x < b->x + b->width && b->x < a->x + a->width && a->y < b->y + b->height &&
           b->y < a->y + a->height;
}

void screen_rows_add(const struct screen_rectangle *rectangle, int part) {
    struct screen_rows *rows = gl.screen_rows;
    assert(!screen_rows_full());
    struct row *row = &rows->rows[rows->count];
    row->rectangle = *rectangle;
    row->part = part;
    row->round = 0;
    for (int i = 0; i < rows->count; i++) {
        const struct row *earlier = &rows->rows[i];
        if (earlier->round >= row->round && earlier->part == part &&
            overlap(&earlier->rectangle, rectangle))
            row->round = earlier->round + 1;
    }
    memcpy(row->values, rows->values, sizeof row->values);
    rows->count++;
    if (rows->rounds <= row->round)
        rows->rounds = row->round + 1;
}

/* --- dispatching them ------------------------------------------------------------------------- */

static void write_row(struct cell *to, const struct row *row, int locations) {
    const struct screen_rectangle *r = &row->rectangle;
    to[0] = (struct cell){{(GLuint)r->x, (GLuint)r->y, (GLuint)r->width, (GLuint)r->height}};
    memcpy(to + 1, row->values, (size_t)locations * sizeof *to);
}

struct round {
    int width, height, first, count;
};

/* Writes the round's rows after the first ones. */
static struct round write_round(struct screen_rows *rows, int number, int first) {
    struct round round = {.first = first};
    int stride = 1 + rows->locations;
    for (int i = 0; i < rows->count; i++) {
        const struct row *row = &rows->rows[i];
        if (row->round != number)
            continue;
        write_row(&rows->upload[(first + round.count++) * stride], row, rows->locations);
        if (round.width < row->rectangle.width)
            round.width = row->rectangle.width;
        if (round.height < row->rectangle.height)
            round.height = row->rectangle.height;
    }
    return round;
}

void screen_rows_flush(void (*dispatch)(int width, int height, int first, int count, int stride)) {
    struct screen_rows *rows = gl.screen_rows;
    struct round rounds[ROWS_MAX];
    int stride = 1 + rows->locations, first = 0;
    if (rows->count == 0)
        return;
    for (int i = 0; i < rows->rounds; i++) {
        rounds[i] = write_round(rows, i, first);
        first += rounds[i].count;
    }
    gl.NamedBufferSubData(rows->buffer, 0, (GLsizeiptr)sizeof(struct cell) * rows->count * stride,
                          rows->upload);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, STORAGE_SCREEN_ROWS, rows->buffer);
    for (int i = 0; i < rows->rounds; i++)
        dispatch(rounds[i].width, rounds[i].height, rounds[i].first, rounds[i].count, stride);
    rows->count = rows->rounds = rows->locations = 0;
}
