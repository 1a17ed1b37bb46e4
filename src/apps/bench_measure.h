/* Times frames: warm-up first, then rounds in which every case renders once with timers and once
 * without, so that A B A B see the same noise of the machine. */
#ifndef APPS_BENCH_MEASURE_H
#define APPS_BENCH_MEASURE_H

#include "apps/bench_case.h"
#include "measure/stage.h"
#include "renderer/renderer.h"

struct bench_protocol {
    int warm_up, frames; /* per case */
    int burst;           /* frames between two looks at the clock, in the rounds without timers */
    bool software;       /* of the context */
    /* Called with the last frame rendered, while the renderer is alive; NULL = no. */
    bool (*inspect)(void *user, struct bench_case *measured, struct renderer *renderer);
    void *user;
};

/* The usual protocol: few frames on the CPU, where one takes seconds; many on a GPU. */
struct bench_protocol bench_protocol_of(bool software);

/* A renderer for the case. Error: of the settings or the renderer; names the case. */
bool bench_case_start(struct renderer *renderer, const struct bench_case *prepared,
                      const struct stage *stage, bool software);

/* Measures the cases, all of one stage and at most BENCH_GROUP, with a renderer each at the same
 * time. */
enum { BENCH_GROUP = 8 };
bool bench_measure(struct bench_case *cases, int count, const struct stage *stage,
                   const struct bench_protocol *protocol);

#endif
