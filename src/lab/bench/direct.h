/* What `manylight bench direct` measures besides errors. */
#ifndef LAB_BENCH_DIRECT_H
#define LAB_BENCH_DIRECT_H

#include "lab/bench/bench.h"

/* A frame with as little indirect light as there can be; for variants. */
#define DIRECT_ALONE                                                                               \
    "technique=unshadowed,vpls=1,rsm-size=16,interleave=1,near-samples=1,clamp=none,adaptive=0,"   \
    "blur.radius=0,picture.samples=1"

/* Tables 5.1, 7.1 and 7.2 of the thesis [Dong 2011], as ratios and shares beside its own: of the
 * present scene's first light, which must be a lamp. Error: there is none, or of a renderer. */
enum { DIRECT_TABLES_SUBJECTS = 21 };
bool direct_tables(struct bench *bench);

#endif
