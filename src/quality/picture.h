/* The picture of a subject, with all layers: by the renderer, by rays from the VPLs that the
 * renderer made, or by paths. */
#ifndef QUALITY_PICTURE_H
#define QUALITY_PICTURE_H

#include "base/progress.h"
#include "quality/measure.h"
#include "reference/light_tracer.h"
#include "reference/path_tracer.h"
#include "reference/vpl_sum.h"

/* One frame. Error: of the renderer. */
bool picture_render(const struct measure_desc *desc, struct image *image);

/* The sum over all VPLs of such a frame, exact but for the bound near a VPL: visibility by ray
 * tracing, no interleaving, no blur. `clamp` bounds the geometry term; `near` is taken as `disk`,
 * as the near field is no sum over VPLs. progress NULL = none shown. Error: the technique has no VPLs; of the
 * renderer or the tracer. */
bool picture_trace(const struct measure_desc *desc, struct progress *progress, struct image *image);

/* Paths of the subject in its size, with its bounces, materials and medium; the rest, as samples, is zero. */
struct path_tracer_desc picture_paths(const struct measure_desc *desc);

/* As path_tracer_render, with scene, geometry, camera and lights of the stage. */
bool picture_trace_paths(const struct stage *stage, const struct path_tracer_desc *desc,
                         struct image *image, struct path_tracer_progress *reached);

/* As light_tracer_render, with the same of the stage, and the size of the image. */
bool picture_trace_light(const struct stage *stage, const struct light_tracer_desc *desc,
                         struct image *image, struct light_tracer_result *result);

#endif
