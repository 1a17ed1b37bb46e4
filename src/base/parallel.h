/* A parallel loop over the machine's cores. */
#ifndef BASE_PARALLEL_H
#define BASE_PARALLEL_H

#include <stdbool.h>
#include <stddef.h>

/* Cores that this process may use: by its affinity, by cpu.max of a container, and by the most that is set before
 * threads start. At least 1. */
int parallel_core_count(void);
void parallel_set_most(int threads);

/* Cores that such a file of a cgroup grants, "150000 100000" is 2; a large number where it sets no bound. */
int parallel_granted(const char *path);

/* Calls body(context, i) for every i in [0, count), on `threads` threads (0 = all cores), in no
 * particular order; each thread takes the next free i. Returns when all calls have returned. */
void parallel_for(size_t count, int threads, void (*body)(void *context, size_t i), void *context);

/* Loops of the calling thread end early once `wanted` says no, which they ask now and then; NULL: they do not ask. */
void parallel_watch(bool (*wanted)(void));

#endif
