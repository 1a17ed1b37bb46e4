/* How far what is seen of the lights is from the reference. */
#ifndef LAB_MEASURE_SHARES_H
#define LAB_MEASURE_SHARES_H

#include "base/image.h"
#include "lab/measure/results.h"

/* Adds "visible-share" and "visible-bias", RMS and mean, %, of the share that is seen less the
 * reference's, over the pixels to which unhidden lights would give a hundredth of what they give to
 * the brightest, or more; and "visible-share-all", the RMS over all to which they would give
 * anything: a few pixels where facets turn away are most of that. The reference's noise,
 * "visible-noise" of the first, is taken off as squares.
 *
 * The share is direct light over what there would be of it unshadowed; the reference's is the
 * tracer's visibility, or of a sky, whose parts count by the cosine, its own direct light over the
 * same. reference: with the layers of path_tracer_desc.seen. Error: a layer is missing. */
bool shares_add(struct results *results, const struct image *test, const struct image *reference,
                bool of_sky);

#endif
