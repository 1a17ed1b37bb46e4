/* Tables 1 and 2 of the paper [Dong 2009 §7], with its own figures beside ours. */
#ifndef APPS_BENCH_TABLES_H
#define APPS_BENCH_TABLES_H

#include "apps/bench_case.h"

#include <stdio.h>

/* Frames per second of every case. */
void bench_print_table1(FILE *out, const struct bench_case *cases, int count);

/* Where the time of one case goes. */
void bench_print_table2(FILE *out, const struct bench_case *measured);

/* How many times as fast as the first case of its scene each other one is. */
void bench_print_ratios(FILE *out, const struct bench_case *cases, int count);

#endif
