/* Renders the rows of a picture on several cores, with progress and cancellation. */
#ifndef REFERENCE_ROWS_H
#define REFERENCE_ROWS_H

#include <stdbool.h>

struct rows {
    int count, threads; /* threads 0: all cores */
    void (*render)(void *context, int row);
    /* Called after each row with the completed fraction, from any thread, one at a time; false
     * cancels. NULL: no report. */
    bool (*report)(void *context, double done);
    void *context;
};

/* Renders all rows, in no particular order. Error: "cancelled". */
bool rows_render(const struct rows *rows);

#endif
