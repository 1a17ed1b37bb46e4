#define _POSIX_C_SOURCE 200809L
#include "base/progress.h"

#include "base/clock.h"
#include "base/log.h"

#include <stdio.h>
#include <unistd.h>

static const double seconds_between_lines = 0.2, seconds_between_notes = 30;

void progress_start(struct progress *progress) {
    progress->shown = log_get_level() > LOG_QUIET;
    progress->rewritten = isatty(STDERR_FILENO);
    progress->start = progress->last = clock_ms() / 1e3;
}

void progress_show(struct progress *progress, double done, const char *note) {
    double time = clock_ms() / 1e3, elapsed = time - progress->start;
    double between = progress->rewritten ? seconds_between_lines : seconds_between_notes;
    bool tells = done > 0 && (done < 1 || progress->rewritten);
    if (!progress->shown || !tells || time - progress->last < between)
        return;
    progress->last = time;
    int left = (int)(elapsed * (1 - done) / done + 0.5);
    char line[256];
    if (progress->rewritten) {
        snprintf(line, sizeof line, "%4.0f %%  %d:%02d left  %s", 100 * done, left / 60, left % 60,
                 note);
        log_show_line(line);
    } else {
        log_note("%.0f %%, %d:%02d left%s%s", 100 * done, left / 60, left % 60, *note ? ", " : "",
                 note);
    }
}

void progress_show_work(struct progress *progress, double done, const char *note) {
    if (done > 0)
        progress_show(progress, done, note);
    else if (progress->shown && progress->rewritten)
        log_show_line(note);
}

double progress_end(struct progress *progress) {
    if (progress->shown && progress->rewritten)
        log_show_line(NULL);
    return clock_ms() / 1e3 - progress->start;
}
