/* Parallel loops over the machine's cores. */
#ifndef BASE_PARALLEL_H
#define BASE_PARALLEL_H

#include <stdbool.h>
#include <stddef.h>

/* Returns the cores that this process may use, at least 1. Limits: affinity, cpu.max of a
 * container, and parallel_set_most, which is called before threads start. */
int parallel_core_count(void);
void parallel_set_most(int threads);

/* Returns the cores that a cgroup file such as cpu.max grants: "150000 100000" is 2. Without a
 * limit returns 256. */
int parallel_granted(const char *path);

/* Calls body(context, i) for each i in [0, count), in any order, on `threads` threads (0: all
 * cores). Each thread takes the next free i. Returns after all calls. */
void parallel_for(size_t count, int threads, void (*body)(void *context, size_t i), void *context);

/* Ends loops of the calling thread early after `wanted` returns false; they call it at intervals.
 * NULL: never. */
void parallel_watch(bool (*wanted)(void));

#endif
