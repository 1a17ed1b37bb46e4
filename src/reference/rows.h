/* The rows of a picture, on several cores, with progress and a way out. */
#ifndef REFERENCE_ROWS_H
#define REFERENCE_ROWS_H

#include <stdbool.h>

struct rows {
    int count, threads; /* threads 0 = all cores */
    void (*render)(void *context, int row);
    /* done: the share of rows. Called after each row, from any of the threads but one at a time;
     * false cancels. May be NULL. */
    bool (*report)(void *context, double done);
    void *context;
};

/* Renders all rows, in no particular order. Error: "cancelled". */
bool rows_render(const struct rows *rows);

#endif
