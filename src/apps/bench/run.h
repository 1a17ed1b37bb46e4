/* A run of a mode of `manylight bench`: its journal, its tables as they grow, and its progress. */
#ifndef APPS_BENCH_RUN_H
#define APPS_BENCH_RUN_H

#include "apps/bench/bench.h"

/* Measures and prints all, and writes --csv. options: those of the mode, up to one of no name. Error: of a file, a scene
 * or a renderer; what was measured stays in the journal. */
bool bench_run(struct bench *bench, const struct bench_mode *mode, const struct option *options);

#endif
