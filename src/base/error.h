/* Errors of the world (files, formats, drivers, sizes): one message per thread.
 *
 * A function that can fail returns bool or NULL and leaves a message here. Each caller may put its
 * own context in front, so that the message reads outermost first:
 *
 *     render: sponza.glb: material 12: cannot open lion.png: No such file or directory
 *
 * Only apps print the message and exit. A programmer's mistake is an assert, never an error.
 */
#ifndef BASE_ERROR_H
#define BASE_ERROR_H

#include <stdbool.h>

/* What a program that goes on may want to know of an error. */
enum error_kind { ERROR_OF_WORLD, ERROR_OF_MEMORY };

/* Sets the message. Always returns false, so that a function can end in `return error_set(...)`. */
bool error_set(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The same where memory is short, of the CPU or the GPU. */
bool error_set_memory(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Puts "context: " in front of the present message. Always returns false. */
bool error_prefix(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The present message; "" when there is none. Valid until the next call of this module. */
const char *error_get(void);
enum error_kind error_get_kind(void);

#endif
