/* A parallel loop over the machine's cores. */
#ifndef BASE_PARALLEL_H
#define BASE_PARALLEL_H

#include <stddef.h>

/* Cores available to this process, at least 1. */
int parallel_core_count(void);

/* Calls body(context, i) for every i in [0, count), on `threads` threads (0 = all cores), in no
 * particular order; each thread takes the next free i. Returns when all calls have returned. */
void parallel_for(size_t count, int threads, void (*body)(void *context, size_t i), void *context);

#endif
