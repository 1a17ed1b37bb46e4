/* Visibility by ray tracing from the VPLs that a renderer has made on the GPU. */
#ifndef MEASURE_VPL_TRACE_H
#define MEASURE_VPL_TRACE_H

#include "measure/progress.h"
#include "base/image.h"
#include "renderer/renderer.h"

/* From the renderer's last frame, in another size if need be; progress NULL = none shown. The
 * settings' clamp bounds the geometry term; `near` is taken as `disk`, as the near field is no sum
 * over VPLs. Error: the technique has no VPLs; the tracer's. */
bool vpl_trace(struct renderer *renderer, int width, int height, struct progress *progress,
               struct image *image);

#endif
