/* Path-traces a picture in place of a frame. Where OpenGL runs on the CPU, some pictures take less
 * time so. */
#ifndef QUALITY_TRACED_H
#define QUALITY_TRACED_H

#include "base/progress.h"
#include "quality/measure.h"

/* True if OpenGL is software, paths obey all settings that are not default, and the picture has
 * neither panes nor caustics. */
bool traced_is_possible(const struct measure_desc *desc);

/* Traces `samples` of each pixel, seeded by lights.seed, with filtered indirect light. hides_sky:
 * as path_tracer_desc's. progress NULL: none is shown. Error: the tracer's. */
bool traced_render(const struct measure_desc *desc, int samples, bool hides_sky,
                   struct progress *progress, struct image *image);

/* Traces what a renderer of desc shows of the stage. A picture that traced_render has already made
 * of it with the environment, if that is shown, stays. Error: the tracer's. */
bool traced_show(const struct renderer_desc *desc, const struct stage *stage, int samples,
                 struct progress *progress, struct image *picture);

/* Draws a layer as renderer_compose does, with the desc's size, exposure, tone map and background.
 * Error: shaders; memory. */
bool traced_display(const struct image *image, const struct renderer_desc *desc, int layer,
                    struct bitmap *bitmap);

#endif
