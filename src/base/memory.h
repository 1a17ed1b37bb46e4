/* Allocates CPU memory. Running out of it ends the program with a message and status 1, so callers
 * need no check. Call mem_check first for sizes from outside, such as the size of a picture in a
 * file. Free with free(). */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h> /* free */

/* True if `ulimit -d` limits the memory of this process. */
bool mem_is_limited(void);

/* True if `ulimit -v` or `-d` leaves less than 2 GiB, so that a graphics driver may fail. */
bool mem_is_scarce(void);

/* Checks that `ulimit -v` and `-d` leave the memory that an OpenGL driver needs; without it drivers
 * crash. Error: names the limit, the memory left and the need. */
bool mem_check_driver(void);

/* Returns the free bytes by the machine and by the limits of this process. */
uint64_t mem_free_bytes(void);

/* Checks that this number of bytes is free. Error: wanted and free memory; the caller prefixes the
 * purpose. */
bool mem_check(uint64_t bytes);

/* Return the current and the peak resident memory of the process, MiB; 0: unknown. */
double mem_resident(void);
double mem_most_resident(void);

/* Keeps up to 256 MiB of freed memory for later allocations. Does nothing if the C library
 * cannot. */
void mem_keep_freed(void);

/* Allocates count zeroed elements of size bytes. The pointer is valid even for 0 bytes. */
void *mem_alloc(size_t count, size_t size);

/* Resizes an allocation; new bytes are not zeroed. */
void *mem_resize(void *pointer, size_t count, size_t size);

/* Calls a function of one pointer for each of several pointers. */
#define MEM_EACH(type, function, ...)                                                              \
    do {                                                                                           \
        type *const each_[] = {__VA_ARGS__};                                                       \
        for (size_t i_ = 0; i_ < sizeof each_ / sizeof *each_; i_++)                               \
            function(each_[i_]);                                                                   \
    } while (0)

/* Frees each pointer with free(). */
#define mem_free(...) MEM_EACH(void, free, __VA_ARGS__)

/* Returns a copy of an array, or NULL for NULL; the caller frees it. */
void *mem_copy(const void *elements, size_t count, size_t size);

/* Return allocated text; the caller frees it. */
char *mem_strdup(const char *text);
char *mem_printf(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
