/* CPU memory. Running out of it ends the program with a message and status 1, so callers need no
 * check; what the world asks for, such as a picture's size in a file, passes mem_check first. free()
 * frees. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Whether `ulimit -d` bounds the memory of this process. */
bool mem_is_limited(void);

/* Whether `ulimit -v` or `-d` is so low that a graphics driver may fail by it. */
bool mem_is_scarce(void);

/* Checks that `ulimit -v` and `-d` leave the memory that an OpenGL driver takes. Drivers crash without it. */
bool mem_check_driver(void);

/* How many bytes are free, by the machine and by the limits of this process. */
uint64_t mem_free_bytes(void);

/* Whether so many bytes are free. Error: how many are wanted and how many there are; the caller puts in front what wants them. */
bool mem_check(uint64_t bytes);

/* What the process has in memory, now and at its most, MiB; 0 where the system does not tell. */
double mem_resident(void);
double mem_most_resident(void);

/* Keeps up to 256 MiB of what is freed for what is allocated next, instead of giving them back to the system. Where the C library
 * cannot, nothing. */
void mem_keep_freed(void);

/* count elements of size bytes each, zeroed; a valid pointer even for 0 bytes. */
void *mem_alloc(size_t count, size_t size);

/* Grows or shrinks; new bytes are not zeroed. */
void *mem_resize(void *pointer, size_t count, size_t size);

/* Calls a function of one pointer with each of several. */
#define MEM_EACH(type, function, ...)                                                              \
    do {                                                                                           \
        type *const each_[] = {__VA_ARGS__};                                                       \
        for (size_t i_ = 0; i_ < sizeof each_ / sizeof *each_; i_++)                               \
            function(each_[i_]);                                                                   \
    } while (0)

/* free() of each. */
#define mem_free(...) MEM_EACH(void, free, __VA_ARGS__)

char *mem_strdup(const char *text);
char *mem_printf(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
