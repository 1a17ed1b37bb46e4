#define _POSIX_C_SOURCE 200809L
#include "base/progress.h"

#include "base/clock.h"
#include "base/events.h"
#include "base/log.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

static const double seconds_between_lines = 0.2, seconds_between_notes = 30;

void progress_start(struct progress *progress, const char *task) {
    *progress = (struct progress){.task = task};
    progress->shown = log_get_level() > LOG_QUIET;
    progress->rewritten = isatty(STDERR_FILENO);
    progress->start = progress->last = clock_ms() / 1e3;
}

/* --- events ----------------------------------------------------------------------------------- */

static void add_place(struct json *json, const struct progress *progress) {
    if (progress->frame_count > 0) {
        json_number(json, "frame", progress->frame);
        json_number(json, "frames", progress->frame_count);
    }
    if (progress->pass_count > 0) {
        json_number(json, "pass", progress->pass);
        json_number(json, "passes", progress->pass_count);
    }
}

static void send(struct progress *progress, double done, const char *note, double time) {
    struct event event;
    double elapsed = time - progress->start;
    event_begin(&event, "progress");
    json_text(&event.json, "task", progress->task);
    json_number(&event.json, "done", done);
    add_place(&event.json, progress);
    json_number(&event.json, "seconds", elapsed);
    json_number(&event.json, "eta", done > 0 ? elapsed * (1 - done) / done : NAN);
    json_text(&event.json, "note", note);
    event_send(&event);
}

void progress_tell_file(struct progress *progress, const char *path) {
    struct event event;
    if (!events_are_json())
        return;
    event_begin(&event, "file");
    json_text(&event.json, "task", progress->task);
    add_place(&event.json, progress);
    json_text(&event.json, "file", path);
    event_send(&event);
}

/* --- text ------------------------------------------------------------------------------------- */

static void show_text(struct progress *progress, double done, const char *note, double time) {
    int left = (int)((time - progress->start) * (1 - done) / done + 0.5);
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

void progress_show(struct progress *progress, double done, const char *note) {
    double time = clock_ms() / 1e3;
    bool is_event = events_are_json();
    double between =
        is_event || progress->rewritten ? seconds_between_lines : seconds_between_notes;
    bool tells = done > 0 && (done < 1 || progress->rewritten);
    if (is_event ? time - progress->last >= between
                 : progress->shown && tells && time - progress->last >= between) {
        progress->last = time;
        (is_event ? send : show_text)(progress, done, note, time);
    }
}

void progress_show_step(struct progress *progress, double done, const char *note) {
    if (events_are_json())
        send(progress, done, note, clock_ms() / 1e3);
    else
        progress_show(progress, done, note);
}

void progress_show_work(struct progress *progress, double done, const char *note) {
    if (done > 0 || events_are_json())
        progress_show(progress, done, note);
    else if (progress->shown && progress->rewritten)
        log_show_line(note);
}

double progress_end(struct progress *progress) {
    if (progress->shown && progress->rewritten)
        log_show_line(NULL);
    return clock_ms() / 1e3 - progress->start;
}
