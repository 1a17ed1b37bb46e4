/* A line on the terminal that tells how long work goes on: "  42 %  0:13 left  noise 1.8 %".
 *
 * Nothing is written where stderr is not a terminal or after --quiet.
 */
#ifndef BASE_PROGRESS_H
#define BASE_PROGRESS_H

#include <stdbool.h>

struct progress {
    bool shown;
    double start, last; /* seconds */
};

void progress_start(struct progress *progress);

/* done in [0, 1], and what else to say. Rewrites the line a few times a second. */
void progress_show(struct progress *progress, double done, const char *note);

/* Clears the line. Returns the seconds since the start. */
double progress_end(struct progress *progress);

#endif
