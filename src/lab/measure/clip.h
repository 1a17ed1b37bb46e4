/* How steady moving pictures are.
 *
 * Flicker is what changes from frame to frame in a picture F and not in the reference R, which has
 * all VPLs with a shadow map each, or is path-traced, of as many bounces:
 *
 *     mean over frames and pixels of |(F_t - F_t-1) - (R_t - R_t-1)| / mean R
 *
 * of the indirect light. A picture that is wrong, but steadily so, does not flicker. */
#ifndef LAB_MEASURE_CLIP_H
#define LAB_MEASURE_CLIP_H

#include "lab/measure/results.h"
#include "lab/measure/reference.h"
#include "lab/measure/variants.h"

struct clip_desc {
    struct stage *stage; /* of all subjects; is posed */
    const struct measure_list *subjects;
    int frames;                   /* spread over the clip; at least 2 */
    struct measure_desc all_vpls; /* what is R, unless the reference is path-traced */
    struct reference_desc
        reference; /* REFERENCE_PATH or REFERENCE_CENTERS: R; its cache has no part in it */
};

/* Adds for each subject and frame, whose point is "time=SECONDS":
 *     frame-flicker (%), vals (in use), val-travel and vpl-travel (m since the frame before)
 * then for each subject, without a point:
 *     flicker (the mean), worst-flicker and worst-time, least-vals and most-vals, travel (of VALs'
 *     centres over that of VPLs)
 * and twice, as variant "memory", after a tenth of the clip and at its end:
 *     gl-objects, gpu-memory, resident-memory and most-resident (MiB)
 * What a technique without VPLs or VALs has not is left out. Error: nothing moves; of a renderer or
 * the tracer. */
int clip_subjects(const struct clip_desc *clip); /* how many they are */
bool clip_measure(struct results *results, const struct clip_desc *clip);

#endif
