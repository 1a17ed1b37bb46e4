/* Notes and warnings on stderr. Results go to stdout, errors through base/error.h. */
#ifndef BASE_LOG_H
#define BASE_LOG_H

#include <stdbool.h>

enum log_level { LOG_QUIET, LOG_NORMAL, LOG_VERBOSE };
enum log_kind { LOG_IS_DETAIL, LOG_IS_NOTE, LOG_IS_WARNING };

/* Quiet drops notes; warnings always show. Default LOG_NORMAL. */
void log_set_level(enum log_level level);
enum log_level log_get_level(void);

/* Whether what this thread does is told to anybody at all; true at first. For work that nobody has asked for. */
void log_tell_of_thread(bool tells);

/* Gets notes and warnings as well, from any thread, however quiet stderr is. NULL: nobody. */
typedef void log_listener(void *context, bool is_warning, const char *message);
void log_set_listener(log_listener *listener, void *context);

/* Where all that this thread tells goes instead of stderr and the listener, details too; NULL, as at first: to these. Threads
 * of parallel_for tell the sink of the thread that called it. */
struct log_sink {
    void (*tell)(const struct log_sink *sink, enum log_kind kind, const char *message);
};
void log_set_sink(const struct log_sink *sink);
const struct log_sink *log_get_sink(void);

/* The last line of stderr, a terminal, is written over by the next one: whatever is told clears it first. NULL clears
 * it. Call log_show_line(NULL) before stdout is written to as well. */
void log_show_line(const char *line);

void log_detail(const char *format, ...) __attribute__((format(printf, 1, 2))); /* verbose only */
void log_note(const char *format, ...) __attribute__((format(printf, 1, 2)));
void log_warning(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
