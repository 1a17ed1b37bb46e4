/* How far what is seen of the lights is from the reference. */
#ifndef LAB_MEASURE_SHARES_H
#define LAB_MEASURE_SHARES_H

#include "base/image.h"
#include "lab/measure/results.h"

/* Adds "visible-share" and "visible-bias": RMS and mean of the visible share minus the reference's,
 * in %. They are over pixels with at least a hundredth of the brightest unshadowed light.
 * "visible-share-all" is the RMS over all pixels with unshadowed light; a few pixels where facets
 * turn away are most of it. The noise of the reference, "visible-noise", is subtracted as squares.
 *
 * The share is direct light over unshadowed direct light. The reference's share is the tracer's
 * visibility; for a sky it is the tracer's direct light over the same. reference: with the layers
 * of path_tracer_desc.seen. Error: a layer is missing. */
bool shares_add(struct results *results, const struct image *test, const struct image *reference,
                bool of_sky);

#endif
