/* Measurements as CSV, a row for each quantity of each case, and as JSON.
 *
 * Every row tells the machine, so that rows of many runs may be put together. Quantities are the
 * passes ("frame/gather", ms), the clock ("wall", ms), "gpu-memory" (MiB) and the errors
 * ("relative-rmse" ..., shares of 1).
 */
#ifndef APPS_BENCH_ROWS_H
#define APPS_BENCH_ROWS_H

#include "apps/bench_case.h"
#include "apps/bench_machine.h"

/* Error: names the file. */
bool bench_write_csv(const char *path, const struct bench_case *cases, int count,
                     const struct bench_machine *machine);
bool bench_write_json(const char *path, const struct bench_case *cases, int count,
                      const struct bench_machine *machine);

#endif
