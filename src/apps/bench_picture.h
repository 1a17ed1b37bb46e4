/* The picture of a case, with all layers: by the renderer, or by rays from the VPLs that the
 * renderer made. */
#ifndef APPS_BENCH_PICTURE_H
#define APPS_BENCH_PICTURE_H

#include "apps/bench_measure.h"
#include "base/image.h"

/* One frame. Error: of the renderer. */
bool bench_picture_render(const struct bench_case *prepared, const struct stage *stage,
                          bool software, struct image *image);

/* The sum over all VPLs of such a frame, exact but for the bound near a VPL: visibility by ray
 * tracing, no interleaving, no blur. Error: of the renderer or the tracer. */
bool bench_picture_trace(const struct bench_case *prepared, const struct stage *stage,
                         bool software, struct image *image);

#endif
