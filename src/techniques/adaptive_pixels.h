/* Adaptive pixels: the pixels that the blur cannot help.
 *
 * The interleaved gather gives each pixel a part of the VPLs, and the blur averages it with neighbours on the same
 * surface. At edges, and on leaves and mouldings, a pixel has few such neighbours. passes/gather/adaptive.h finds these
 * pixels and puts them on lists. They take more VPLs, test visibility themselves in place of their block, and are
 * blurred less.
 *
 * Edge samples: antialiasing finds samples of a pixel that lie on a surface that no neighbour's centre sees. One of
 * them for each pixel is a list of its own and gathers like an adaptive pixel.
 *
 * The frame has no adaptive pixels where many_lights_passes.c does not call adaptive_pixels_init.
 */
#ifndef TECHNIQUES_ADAPTIVE_PIXELS_H
#define TECHNIQUES_ADAPTIVE_PIXELS_H

#include "techniques/many_lights.h"

/* Makes lights->adaptive and adaptive_gather where the settings ask for them. others: the gather of all pixels, which then
 * leaves out what is on lists. */
bool adaptive_pixels_init(struct many_lights *lights, const struct technique_desc *desc,
                          struct gather_desc *others);

/* What adaptive pixels take of the near field and of the blur; without them nothing. */
void adaptive_pixels_fit_near_field(const struct many_lights *lights,
                                    struct near_field_desc *near_field);
void adaptive_pixels_fit_blur(const struct many_lights *lights, struct blur_desc *blur);

/* Of so many VPLs two test visibility for all, where pixels test it themselves. */
int vpls_together(const struct gather_desc *desc);

#endif
