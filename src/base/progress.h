/* A line that tells how long work goes on: "  42 %  0:13 left  noise 1.8 %". On a terminal it is written over the one
 * before; elsewhere, as in a log, it is a note each half minute, but not of the end. After --quiet there is none.
 */
#ifndef BASE_PROGRESS_H
#define BASE_PROGRESS_H

#include <stdbool.h>

struct progress {
    bool shown, rewritten;
    double start, last; /* seconds */
};

void progress_start(struct progress *progress);

/* done in [0, 1], and what else to say. */
void progress_show(struct progress *progress, double done, const char *note);

/* The same; on a terminal it also tells the note of work of which nothing is done yet. */
void progress_show_work(struct progress *progress, double done, const char *note);

/* Clears the line. Returns the seconds since the start. */
double progress_end(struct progress *progress);

#endif
