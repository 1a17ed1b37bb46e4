/* Notes and warnings on stderr. Results go to stdout, errors through base/error.h. */
#ifndef BASE_LOG_H
#define BASE_LOG_H

#include <stdbool.h>

enum log_level { LOG_QUIET, LOG_NORMAL, LOG_VERBOSE };
enum log_kind { LOG_IS_DETAIL, LOG_IS_NOTE, LOG_IS_WARNING };

/* Sets the level of stderr. LOG_QUIET drops notes; warnings always show. Default LOG_NORMAL. */
void log_set_level(enum log_level level);
enum log_level log_get_level(void);

/* Turns all messages of this thread on or off; on at first. For work that the user did not
 * request. */
void log_tell_of_thread(bool tells);

/* Receives notes and warnings of all threads without a sink, at any level. NULL: none. */
typedef void log_listener(void *context, bool is_warning, const char *message);
void log_set_listener(log_listener *listener, void *context);

/* Receives all messages of this thread, details included, in place of stderr and listener. NULL,
 * the default: none. Threads of parallel_for use the sink of the thread that called it. */
struct log_sink {
    void (*tell)(const struct log_sink *sink, enum log_kind kind, const char *message);
};
void log_set_sink(const struct log_sink *sink);
const struct log_sink *log_get_sink(void);

/* Writes a last line on the terminal at stderr that the next line overwrites. Messages clear it
 * first; NULL clears it. Call log_show_line(NULL) before a write to stdout. */
void log_show_line(const char *line);

/* Writes a message; details appear at LOG_VERBOSE only. */
void log_detail(const char *format, ...) __attribute__((format(printf, 1, 2)));
void log_note(const char *format, ...) __attribute__((format(printf, 1, 2)));
void log_warning(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
