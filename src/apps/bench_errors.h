/* How far a frame is from the truth: its picture against a reference. */
#ifndef APPS_BENCH_ERRORS_H
#define APPS_BENCH_ERRORS_H

#include "apps/bench_case.h"
#include "base/image.h"
#include "renderer/renderer.h"

/* All layers of both; the indirect layer gives the errors, the beauty layer FLIP. */
bool bench_errors_between(const struct image *test, const struct image *reference,
                          struct bench_errors *errors);

/* The same for the renderer's last frame. */
bool bench_errors_of_frame(struct renderer *renderer, const struct image *reference,
                           struct bench_errors *errors);

#endif
