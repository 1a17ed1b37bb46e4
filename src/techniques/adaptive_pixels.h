/* Adaptive pixels: pixels that the blur cannot help.
 *
 * The interleaved gather gives each pixel a part of the VPLs, and the blur averages neighbours on
 * the same surface. At edges, leaves and mouldings a pixel has few similar neighbours.
 * passes/gather/adaptive.h lists these pixels. They take more VPLs, test visibility themselves
 * instead of reading their block, and get a smaller blur.
 *
 * Edge samples are antialiasing samples on a surface that no neighbour's centre sees. A list holds
 * one of them for each pixel; it gathers like an adaptive pixel.
 *
 * The frame has no adaptive pixels unless many_lights_passes.c calls adaptive_pixels_init. */
#ifndef TECHNIQUES_ADAPTIVE_PIXELS_H
#define TECHNIQUES_ADAPTIVE_PIXELS_H

#include "techniques/many_lights.h"

/* Makes lights->adaptive and lights->adaptive_gather if the settings enable them. `others` is the
 * gather of all pixels, which then skips list pixels. */
bool adaptive_pixels_init(struct many_lights *lights, const struct technique_desc *desc,
                          struct gather_desc *others);

/* Set the near field's and the blur's parameters for adaptive pixels. Without adaptive pixels they
 * change nothing. */
void adaptive_pixels_fit_near_field(const struct many_lights *lights,
                                    struct near_field_desc *near_field);
void adaptive_pixels_fit_blur(const struct many_lights *lights, struct blur_desc *blur);

/* Returns the VPLs of which two test visibility for all, if pixels test it themselves. */
int vpls_together(const struct gather_desc *desc);

#endif
