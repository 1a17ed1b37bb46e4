/* Errors of files, formats, drivers and sizes: one message per thread.
 *
 * A function that can fail returns bool or NULL and sets the message. Callers add context in front,
 * so the message reads from the outside in:
 *
 *     render: sponza.glb: material 12: cannot open lion.png: No such file or directory
 *
 * Only apps print the message and exit. A mistake of the programmer is an assert, never an
 * error. */
#ifndef BASE_ERROR_H
#define BASE_ERROR_H

#include <stdbool.h>

/* Kind of an error, for callers that continue. */
enum error_kind { ERROR_OF_WORLD, ERROR_OF_MEMORY };

/* Sets the message and ERROR_OF_WORLD. Returns false, for `return error_set(...)`. */
bool error_set(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Sets the message and ERROR_OF_MEMORY, for CPU or GPU memory that is short. Returns false. */
bool error_set_memory(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Puts "context: " in front of the message. Returns false. */
bool error_prefix(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Returns this thread's message; "" if there is none. Valid until the next call of this module. */
const char *error_get(void);
enum error_kind error_get_kind(void);

#endif
