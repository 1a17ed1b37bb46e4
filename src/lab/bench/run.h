/* A run of a mode of `manylight bench`: its rows, its tables as they grow, and its progress. */
#ifndef LAB_BENCH_RUN_H
#define LAB_BENCH_RUN_H

#include "lab/bench/bench.h"

/* Measures and prints all, and writes --csv. Error: of a file, a scene or a renderer. */
bool bench_run(struct bench *bench, const struct bench_mode *mode);

#endif
