/* A path-traced picture whose indirect light is filtered, in place of a frame: where OpenGL runs on
 * the CPU, some pictures take less time so. */
#ifndef QUALITY_TRACED_H
#define QUALITY_TRACED_H

#include "base/progress.h"
#include "quality/measure.h"

/* True where OpenGL is software, paths obey all settings that are not default, and no caustics are
 * shown. */
bool traced_is_possible(const struct measure_desc *desc);

/* Traces so many samples of each pixel, from lights.seed. hides_sky: as path_tracer_desc's.
 * progress NULL: none is shown. Error: the tracer's. */
bool traced_render(const struct measure_desc *desc, int samples, bool hides_sky,
                   struct progress *progress, struct image *image);

/* Draws a layer as renderer_compose does, with the desc's size, exposure, tone map and background.
 * Error: shaders; memory. */
bool traced_display(const struct image *image, const struct renderer_desc *desc, int layer,
                    struct bitmap *bitmap);

#endif
