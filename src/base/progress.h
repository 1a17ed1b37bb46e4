/* A line that tells how long work goes on: "  42 %  0:13 left  noise 1.8 %". On a terminal it is written over the one
 * before; elsewhere, as in a log, it is a note each half minute, but not of the end. After --quiet there is none.
 * With events as JSON (base/events.h) each of these is an event with the task, its frame and its pass, also after
 * --quiet. At most five come in a second; the ends of frames always come.
 */
#ifndef BASE_PROGRESS_H
#define BASE_PROGRESS_H

#include <stdbool.h>

struct progress {
    const char *task; /* "frames" */
    bool shown, rewritten;
    double start, last; /* seconds */
    /* For events; counts are 0 where the task has none. */
    int frame, frame_count; /* number of the present frame, and of how many */
    int pass, pass_count;   /* passes of the frame that are done */
};

/* The task must live on. */
void progress_start(struct progress *progress, const char *task);

/* A file of the present frame is written, as whole as it will be. */
void progress_tell_file(struct progress *progress, const char *path);

/* done in [0, 1], and what else to say. */
void progress_show(struct progress *progress, double done, const char *note);

/* The same of a step that is done: an event always. */
void progress_show_step(struct progress *progress, double done, const char *note);

/* The same; on a terminal it also tells the note of work of which nothing is done yet. */
void progress_show_work(struct progress *progress, double done, const char *note);

/* Clears the line. Returns the seconds since the start. */
double progress_end(struct progress *progress);

#endif
