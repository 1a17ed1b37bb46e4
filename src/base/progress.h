/* Shows the progress of long work: "  42 %  0:13 left  noise 1.8 %".
 *
 * A terminal shows one line that is overwritten. Elsewhere, as in a log, a note appears each 30
 * seconds, but not at the end. After --quiet nothing appears. With events as JSON (base/events.h)
 * each line is an event with task, frame and pass, also after --quiet. At most five appear in a
 * second, plus one at the end of each step. */
#ifndef BASE_PROGRESS_H
#define BASE_PROGRESS_H

#include <stdbool.h>

struct progress {
    const char *task; /* "frames" */
    bool shown, rewritten;
    double start, last; /* seconds */
    /* For events; counts are 0 if the task has none. */
    int frame, frame_count; /* number of the current frame, and of all frames */
    int pass, pass_count;   /* finished passes of the frame, and all its passes */
};

/* Starts the clock. The string task is not copied. */
void progress_start(struct progress *progress, const char *task);

/* Sends the event of a finished file of the current frame. */
void progress_tell_file(struct progress *progress, const char *path);

/* Shows the progress. done: in [0, 1]. note: text after it. */
void progress_show(struct progress *progress, double done, const char *note);

/* Shows the progress at the end of a step; as an event always. */
void progress_show_step(struct progress *progress, double done, const char *note);

/* Shows the progress. At done 0 a terminal shows only the note. */
void progress_show_work(struct progress *progress, double done, const char *note);

/* Clears the line. Returns seconds from the start. */
double progress_end(struct progress *progress);

#endif
