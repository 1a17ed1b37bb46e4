/* Makes the picture of a measurement with all layers: by the renderer, by rays to the renderer's
 * VPLs, or by path tracing. */
#ifndef QUALITY_PICTURE_H
#define QUALITY_PICTURE_H

#include "base/progress.h"
#include "quality/measure.h"
#include "reference/light_tracer.h"
#include "reference/path_tracer.h"
#include "reference/vpl_sum.h"

/* Renders one frame. Error: as of the renderer. */
bool picture_render(const struct measure_desc *desc, struct image *image);

/* Sums over all VPLs of a frame with ray-traced visibility, without interleaving and blur; exact
 * except for the clamp near a VPL. `clamp` bounds the geometry term; `near` acts as `disk`, because
 * the near field is no sum over VPLs. progress NULL: not shown. Error: the technique has no VPLs;
 * as of renderer and tracer. */
bool picture_trace(const struct measure_desc *desc, struct progress *progress, struct image *image);

/* Returns a path tracer's descriptor with size, bounces, materials and medium of the measured
 * picture; all else, for example the samples, is zero. */
struct path_tracer_desc picture_paths(const struct measure_desc *desc);

/* Path-traces scene, geometry, camera and lights of the stage, as path_tracer_render. */
bool picture_trace_paths(const struct stage *stage, const struct path_tracer_desc *desc,
                         struct image *image, struct path_tracer_progress *reached);

/* Traces light paths of the stage into an image of its size, as light_tracer_render. */
bool picture_trace_light(const struct stage *stage, const struct light_tracer_desc *desc,
                         struct image *image, struct light_tracer_result *result);

/* Writes samples and noise so far; "" before the first. */
enum { PATH_NOTE_SIZE = 64 };
void path_progress_note(char note[PATH_NOTE_SIZE], const struct path_tracer_progress *progress);

/* Shows them. Implements path_tracer_desc.progress; user: a struct progress. */
bool path_progress_show(void *user, const struct path_tracer_progress *progress);

#endif
