#define _POSIX_C_SOURCE 200809L
#include "base/progress.h"

#include "base/clock.h"
#include "base/log.h"

#include <stdio.h>
#include <unistd.h>

static const double seconds_between_lines = 0.2;

void progress_start(struct progress *progress) {
    progress->shown = isatty(STDERR_FILENO) && log_get_level() > LOG_QUIET;
    progress->start = progress->last = clock_ms() / 1e3;
}

void progress_show(struct progress *progress, double done, const char *note) {
    double time = clock_ms() / 1e3, elapsed = time - progress->start;
    if (!progress->shown || time - progress->last < seconds_between_lines || done <= 0)
        return;
    progress->last = time;
    int left = (int)(elapsed * (1 - done) / done + 0.5);
    fprintf(stderr, "\r%4.0f %%  %d:%02d left  %s\033[K", 100 * done, left / 60, left % 60, note);
}

double progress_end(struct progress *progress) {
    if (progress->shown)
        fprintf(stderr, "\r\033[K");
    return clock_ms() / 1e3 - progress->start;
}
